"""Layout files between phidl, KLayout and gdstk.

agree_files.py write X.gds FOLDER   writes X in OASIS with every setting of KLayout and gdstk
agree_files.py check X.gds FILE...  compares each file with X: cells, areas by XOR, labels, properties
"""

import itertools
import sys
from pathlib import Path

import gdstk
import klayout.db as kdb

# What phidl puts beside a label, for itself.
OURS = "PHIDL_LABEL"


def write(source, folder):
    layout = kdb.Layout()
    layout.read(source)
    for level, blocks, strict in itertools.product((0, 1, 2), (False, True), (False, True)):
        options = kdb.SaveLayoutOptions()
        options.format = "OASIS"
        options.oasis_compression_level = level
        options.oasis_write_cblocks = blocks
        options.oasis_strict_mode = strict
        options.oasis_write_std_properties_ext = level
        layout.write(str(folder / f"klayout_{level}{blocks:d}{strict:d}.oas"), options)
    library = gdstk.read_gds(source)
    settings = [
        {},
        {"detect_rectangles": False},
        {"detect_trapezoids": True},
        {"compression_level": 0},
        {"compression_level": 9, "validation": "crc32"},
        {"validation": "checksum32"},
        {"standard_properties": True},
    ]
    for number, setting in enumerate(settings):
        library.write_oas(str(folder / f"gdstk_{number}.oas"), **setting)


def content(path):
    layout = kdb.Layout()
    options = kdb.LoadLayoutOptions()
    options.oasis_expect_strict_mode = 1 if path.name.startswith("phidl") and path.suffix == ".oas" else 0
    layout.read(str(path), options)
    found = {}
    for cell in layout.each_cell():
        for index in layout.layer_indexes():
            info = layout.get_info(index)
            region = kdb.Region(cell.begin_shapes_rec(index)).merged()
            texts = cell.shapes(index).each(kdb.Shapes.STexts)
            texts = sorted((shape.text.string, shape.text.x, shape.text.y) for shape in texts)
            properties = []
            for shape in cell.shapes(index).each():
                if shape.prop_id:
                    pairs = [(str(key), str(value)) for key, value in layout.properties(shape.prop_id)]
                    pairs = sorted(pair for pair in pairs if pair[0] != OURS)
                    if pairs:
                        properties.append((str(shape.bbox()), pairs))
            if not region.is_empty() or texts:
                found[cell.name, info.layer, info.datatype] = (region, texts, sorted(properties, key=str))
    return sorted(cell.name for cell in layout.each_cell()), found


def check(source, files):
    cells, expected = content(Path(source))
    failed = False
    for file in map(Path, files):
        found_cells, found = content(file)
        faults = [] if cells == found_cells else [f"cells {found_cells} instead of {cells}"]
        for key in sorted(set(expected) | set(found)):
            nothing = (kdb.Region(), [], [])
            (region, texts, properties), (other, other_texts, other_properties) = expected.get(key, nothing), found.get(key, nothing)
            # Outlines of paths are rounded by every tool independently, by one step at most.
            if not (region ^ other).sized(-1).is_empty():
                faults.append(f"{key}: areas differ by {(region ^ other).area()} square steps")
            if texts != other_texts:
                faults.append(f"{key}: labels {other_texts} instead of {texts}")
            if properties != other_properties:
                faults.append(f"{key}: properties {other_properties} instead of {properties}")
        if file.name.startswith("phidl") and file.suffix == ".oas":
            if gdstk.oas_validate(str(file))[0] is not True:
                faults.append("gdstk does not find the checksum")
            names = sorted(cell.name for cell in gdstk.read_oas(str(file)).cells)
            if names != cells:
                faults.append(f"gdstk finds the cells {names}")
        failed |= bool(faults)
        print(f"{file.name:<24} {'agrees' if not faults else '; '.join(faults)}")
    return failed


if __name__ == "__main__":
    command, source, *rest = sys.argv[1:]
    if command == "write":
        write(source, Path(rest[0]))
    else:
        sys.exit(check(source, rest))
