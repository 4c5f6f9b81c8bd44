"""Checks results of ours against KLayout's region engine; `cargo xtask interop` calls it.

    python agree_boolean.py SCENE.gds RESULT.gds

The scene has layers 1 and 2; the result has or, and, not, B-A and xor on layers 11 to 15, and offsets of layer 1 by
0.5 µm and by -0.3 µm on layers 21 and 22. Two correct engines round crossings their own way, so results may differ by half
a grid step along the outlines, and by nothing that is left when the difference is shrunk by two steps. Prints a line for
each result, and ends with 1 if one is off.
"""
import sys

import klayout.db as kdb


def regions(path, numbers):
    layout = kdb.Layout()
    layout.read(path)
    top = layout.top_cell()
    return [kdb.Region(top.begin_shapes_rec(layout.layer(number, 0))).merged() for number in numbers], layout.dbu


def main(scene, result):
    (a, b), dbu = regions(scene, (1, 2))
    theirs = {
        11: ("or", a | b),
        12: ("and", a & b),
        13: ("not", a - b),
        14: ("B-A", b - a),
        15: ("xor", a ^ b),
        21: ("offset +0.5", a.sized(round(0.5 / dbu), 2)),
        22: ("offset -0.3", a.sized(round(-0.3 / dbu), 2)),
    }
    ours, our_dbu = regions(result, theirs)
    assert abs(our_dbu - dbu) < 1e-12, "both files have the same grid"
    is_off = False
    for region, (name, expected) in zip(ours, theirs.values()):
        expected = expected.merged()
        difference = (region ^ expected).merged()
        allowed = 0.5 * expected.perimeter()
        slivers_only = difference.sized(-2).is_empty()
        good = difference.area() <= allowed and slivers_only
        is_off |= not good
        print(f"{name:<12} differs by {difference.area() / max(allowed, 1):6.3f} of what is allowed", "" if good else "OFF")
    return is_off


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
