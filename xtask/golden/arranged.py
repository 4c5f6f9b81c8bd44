"""Fixed reference results of functions that take devices: `arranged.json`, and bounds for the crate's own tests.

    python arranged.py GOLDEN_FOLDER TESTS_FOLDER

Grids, sweeps, parts of cells and KLayout's set functions are compared polygon by polygon. What phidl does differently on
purpose (bins of the packer, cells of a fill near the margin, letters) is described by numbers that a test compares: bins
and their boxes, lower left corners of fill cells, boxes of ink.
"""
import json
import pathlib
import sys
import warnings

import phidl.geometry as pg
from phidl import Device, LayerSet

import describe

warnings.filterwarnings("ignore")

RECTANGLE = {"device": "rectangle", "params": {"size": [9, 4], "layer": 0}}
CIRCLE = {"device": "circle", "params": {"radius": 4, "angle_resolution": 10, "layer": 1}}
CROSS = {"device": "cross", "params": {"length": 9.5, "width": 2, "layer": 2}}
FLAG = {"device": "flagpole", "params": {"size": [6, 3], "stub_size": [1, 5.25], "layer": 3}}
ARC = {"device": "arc", "params": {"radius": 5, "width": 1.5, "theta": 130, "start_angle": 20, "layer": 4}}
SHAPES = [RECTANGLE, CIRCLE, CROSS, FLAG, ARC]
IC = {"device": "test_ic", "params": {"wire_widths": [1, 2], "wire_widths_wide": [3, 4]}}
VIA = {"device": "test_via", "params": {"num_vias": 10, "pad_size": [100, 100]}}


def value(given):
    """The reference's form of a parameter."""
    if isinstance(given, dict) and "device" in given:
        function = getattr(pg, given["device"])
        return function(**{name: value(v) for name, v in given["params"].items()})
    if isinstance(given, list) and not any(isinstance(v, (dict, list)) for v in given):
        return tuple(given)
    return [value(v) for v in given] if isinstance(given, list) else given


def drawn(case):
    params = {name: value(v) for name, v in case["params"].items()}
    if case["device"] == "gridsweep":
        params["function"] = getattr(pg, case["params"]["function"]["device"])
    if case["device"] == "preview_layerset":
        layers = LayerSet()
        for name, layer in case["params"]["ls"].items():
            layers.add_layer(name, *layer)
        text, pg.text = pg.text, lambda *_, **__: Device()
        try:
            return pg.preview_layerset(layers, **{n: v for n, v in params.items() if n != "ls"})
        finally:
            pg.text = text
    return getattr(pg, case["device"])(**params)


def grids():
    yield "row", {"device_list": SHAPES}
    yield "columns", {"device_list": SHAPES + [RECTANGLE], "shape": [2, 3], "spacing": [3, 7.5]}
    yield "rows", {"device_list": [SHAPES[:2], SHAPES[2:4]], "spacing": 2.25, "align_x": "xmin", "align_y": "ymax"}
    yield "pitch", {"device_list": SHAPES[:4], "shape": [2, 2], "spacing": [20, 30], "separation": False, "align_x": "xmax", "align_y": "ymin", "edge_x": "xmin", "edge_y": "y"}


def cases():
    for name, params in grids():
        yield {"id": f"grid-{name}", "device": "grid", "params": params}
    for name, device, layers in (("ic", IC, [1]), ("via", VIA, [0, 3])):
        yield {"id": f"extract-{name}", "device": "extract", "params": {"D": device, "layers": layers}}
        yield {"id": f"copy_layer-{name}", "device": "copy_layer", "params": {"D": device, "layer": layers[-1], "new_layer": 17}}
        yield {"id": f"copy-{name}", "device": "copy", "params": {"D": device}}
        yield {"id": f"deepcopy-{name}", "device": "deepcopy", "params": {"D": device}}
        yield {"id": f"flatten-{name}", "device": "flatten", "params": {"D": device}}
    yield {"id": "flatten-layer", "device": "flatten", "params": {"D": CROSS, "single_layer": 9}}
    layers = {"gold": [1, 0], "pads": [2, 5], "via": [3, 0], "etch": [40, 1], "top": [41, 0]}
    yield {"id": "preview_layerset-five", "device": "preview_layerset", "params": {"ls": layers, "size": 40, "spacing": 25}, "text": True}
    for operation in ("A-B", "and", "or", "xor"):
        yield {"id": f"kl_boolean-{operation}", "device": "kl_boolean", "params": {"A": ARC, "B": CROSS, "operation": operation, "layer": 5}, "compare": "region"}
    for mode, distance in ((2, 1.25), (0, 0.5), (1, -0.3)):
        yield {"id": f"kl_offset-{mode}", "device": "kl_offset", "params": {"elements": FLAG, "distance": distance, "miter_mode": mode, "layer": 5}, "compare": "region"}
    yield {"id": "kl_outline-cross", "device": "kl_outline", "params": {"elements": CROSS, "distance": 0.75, "layer": 5}, "compare": "region"}
    yield {"id": "kl_invert-arc", "device": "kl_invert", "params": {"elements": ARC, "border": [3, 5], "layer": 5}, "compare": "region"}


def described(case):
    plain = "compare" not in case and not case.get("text")
    return describe.device(drawn(case), plain, True)


def box(d):
    return [[round(float(v), 6) for v in corner] for corner in d.bbox]


def packings():
    """Boxes, parameters, and how many bins of which size the reference needs."""
    for n, (count, seed, more) in enumerate([(8, 3, {}), (30, 5, {"spacing": 1}), (40, 11, {"max_size": [60, 40], "spacing": 0.5}), (25, 7, {"aspect_ratio": [3, 1], "spacing": 2}), (60, 13, {"sort_by_area": False, "spacing": 0})]):
        boxes = [[3 + (k * seed * 7) % 17 + 0.25 * (k % 3), 2 + (k * seed * 5) % 13] for k in range(count)]
        params = {"spacing": 10, "max_size": [None, None], **more}
        bins = pg.packer([pg.rectangle(size=b) for b in boxes], **params)
        yield {"boxes": boxes, "params": params, "bins": [box(b) for b in bins]}


def fills():
    """A layout, parameters, and the lower left corners of the cells that the reference fills."""
    layout = {"circle": [30, [0, 0]], "rectangle": [[50, 8], [20, 45]], "cross": [[40, 6], [-60, -35]]}
    d = Device()
    d.add_ref(pg.circle(30, layer=0))
    d.add_ref(pg.rectangle((50, 8), layer=1)).move((20, 45))
    d.add_ref(pg.cross(40, 6, layer=0)).move((-60, -35))
    for margin in (0, 5, 12.5):
        fill = pg.fill_rectangle(d, fill_size=(5, 4), margin=margin, fill_layers=7, fill_densities=1.0, bbox=[(-100, -80), (100, 80)])
        corners = sorted([round(float(p[:, 0].min()), 6), round(float(p[:, 1].min()), 6)] for p in fill.get_polygons())
        yield {"layout": layout, "margin": margin, "corners": corners}


def letters():
    """Box of the ink of every character at size 100; and of a text in lines."""
    for code in [*range(33, 127), 181]:
        d = pg.text(chr(code), size=100)
        yield {"text": chr(code), "polygons": len(d.get_polygons()), "bbox": box(d)}
    for justify in ("left", "center", "right"):
        text = "two lines\nof text, (7)"
        yield {"text": text, "justify": justify, "bbox": box(pg.text(text, size=100, justify=justify))}


def main():
    golden, tests = map(pathlib.Path, sys.argv[1:])
    all_cases = [{**case, "expect": describe.attempt(lambda case=case: described(case))} for case in cases()]
    (golden / "arranged.json").write_text("[\n" + ",\n".join(json.dumps(c) for c in all_cases) + "\n]\n", encoding="utf-8")
    tests.mkdir(exist_ok=True)
    for name, rows in (("packer", packings()), ("fill", fills()), ("letters", letters())):
        lines = ",\n".join(json.dumps(row) for row in rows)
        (tests / f"{name}.json").write_text(f"[\n{lines}\n]\n", encoding="utf-8")


main()
