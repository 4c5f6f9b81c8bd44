"""Opens a mask in KLayout, gdstk and gdspy and compares what they see with the summary in its metadata.

    python benches/agree_mask.py target/mask/demo/demo.gds target/mask/demo/metadata.json
"""
import json
import math
import sys

import gdspy
import gdstk
import klayout.db as kdb
import numpy

# Rounding to 1 nm moves an edge by half a step: areas agree to this part.
AREA_TOLERANCE = 2e-3


def by_klayout(path):
    layout = kdb.Layout()
    layout.read(path)
    top = layout.top_cell()
    layers = {}
    for index in layout.layer_indexes():
        info = layout.get_info(index)
        figures = {"polygons": 0, "area": 0.0, "labels": 0}
        shapes = top.begin_shapes_rec(index)
        while not shapes.at_end():
            shape = shapes.shape()
            if shape.is_text():
                figures["labels"] += 1
            else:
                polygon = shape.polygon.transformed(shapes.itrans())
                figures["polygons"] += 1
                figures["area"] += polygon.area() * layout.dbu**2
            shapes.next()
        layers[f"{info.layer}/{info.datatype}"] = figures
    return layout.cells(), top.name, layers


def by_gdstk(path):
    library = gdstk.read_gds(path)
    (top,) = library.top_level()
    layers = {}
    for polygon in top.get_polygons():
        figures = layers.setdefault(f"{polygon.layer}/{polygon.datatype}", {"polygons": 0, "area": 0.0, "labels": 0})
        figures["polygons"] += 1
        figures["area"] += polygon.area()
    for label in top.get_labels():
        figures = layers.setdefault(f"{label.layer}/{label.texttype}", {"polygons": 0, "area": 0.0, "labels": 0})
        figures["labels"] += 1
    return len(library.cells), top.name, layers


def by_gdspy(path):
    library = gdspy.GdsLibrary(infile=path)
    (top,) = library.top_level()
    layers = {}
    for (layer, datatype), polygons in top.get_polygons(by_spec=True).items():
        area = sum(shoelace(points) for points in polygons)
        layers[f"{layer}/{datatype}"] = {"polygons": len(polygons), "area": area, "labels": 0}
    for label in top.get_labels():
        figures = layers.setdefault(f"{label.layer}/{label.texttype}", {"polygons": 0, "area": 0.0, "labels": 0})
        figures["labels"] += 1
    return len(library.cells), top.name, layers


def shoelace(points):
    x, y = points[:, 0], points[:, 1]
    return abs((x * numpy.roll(y, -1) - numpy.roll(x, -1) * y).sum()) / 2


def main(gds, metadata):
    with open(metadata, encoding="utf-8") as file:
        summary = json.load(file)["summary"]
    failures = []
    for name, read in [("KLayout", by_klayout), ("gdstk", by_gdstk), ("gdspy", by_gdspy)]:
        cells, top, layers = read(gds)
        wrong = []
        if (cells, top) != (summary["cells"], summary["top"]):
            wrong.append(f"{cells} cells under {top}")
        if layers.keys() != summary["layers"].keys():
            wrong.append(f"layers {sorted(layers)}")
        for layer, expected in summary["layers"].items():
            seen = layers.get(layer, {})
            for key in ["polygons", "labels"]:
                if seen.get(key) != expected[key]:
                    wrong.append(f"{layer}: {seen.get(key)} {key}, the summary says {expected[key]}")
            if not math.isclose(seen.get("area", 0.0), expected["area"], rel_tol=AREA_TOLERANCE, abs_tol=1e-9):
                wrong.append(f"{layer}: area {seen.get('area')}, the summary says {expected['area']}")
        verdict = "agrees with the summary" if not wrong else "; ".join(wrong)
        print(f"{name:<8} {verdict}", file=sys.stderr if wrong else sys.stdout)
        failures += wrong
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
