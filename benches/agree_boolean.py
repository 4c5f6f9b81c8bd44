"""Checks results of ours against KLayout's region engine; `cargo xtask interop` calls it.

    python agree_boolean.py SCENE.gds RESULT.gds

The scene has layers 1 and 2; the result has or, and, not, B-A and xor on layers 11 to 15, and offsets of layer 1 by
0.5 µm and by -0.3 µm on layers 21 and 22. Two correct engines round crossings their own way, so results may differ by half
a grid step along the outlines, and by nothing that is left when the difference is shrunk by two steps.

KLayout sometimes leaves the join out at the tip of a needle-thin slit or spike. Whatever the join, an offset must take
what is nearer than the distance to an outline; where KLayout does not, and ours does, the difference is theirs. Such places
are counted and shown, and do not make a result off.

Prints a line for each result, and ends with 1 if one is off.
"""
import math
import sys

import klayout.db as kdb


def regions(path, numbers):
    layout = kdb.Layout()
    layout.read(path)
    top = layout.top_cell()
    return [kdb.Region(top.begin_shapes_rec(layout.layer(number, 0))).merged() for number in numbers], layout.dbu


def distance_to(edge, x, y):
    """Distance of a point from an edge, in grid steps."""
    dx, dy = edge.x2 - edge.x1, edge.y2 - edge.y1
    along = ((x - edge.x1) * dx + (y - edge.y1) * dy) / (dx * dx + dy * dy)
    along = min(max(along, 0.0), 1.0)
    return math.hypot(x - edge.x1 - along * dx, y - edge.y1 - along * dy)


def breaks_distance(part, shapes, ours, distance):
    """Whether KLayout, and not ours, breaks the distance in a part that differs: the part has a corner that is nearer
    to the outline than the distance, and ours has taken the whole part away (shrinking) or in (growing)."""
    part = kdb.Region(part)
    ours_took_it = (part - ours).is_empty() if distance > 0 else (part & ours).is_empty()
    near = shapes.edges().interacting(kdb.Region(part.bbox().enlarged(abs(distance), abs(distance))))
    corners = [point for polygon in part.each() for point in polygon.each_point_hull()]
    nearest = min((distance_to(edge, p.x, p.y) for edge in near.each() for p in corners), default=math.inf)
    return ours_took_it and nearest < abs(distance) - 2


def main(scene, result):
    (a, b), dbu = regions(scene, (1, 2))
    grow, shrink = round(0.5 / dbu), round(-0.3 / dbu)
    theirs = {
        11: ("or", a | b, None),
        12: ("and", a & b, None),
        13: ("not", a - b, None),
        14: ("B-A", b - a, None),
        15: ("xor", a ^ b, None),
        21: ("offset +0.5", a.sized(grow, 2), grow),
        22: ("offset -0.3", a.sized(shrink, 2), shrink),
    }
    ours, our_dbu = regions(result, theirs)
    assert abs(our_dbu - dbu) < 1e-12, "both files have the same grid"
    is_off = False
    for region, (name, expected, distance) in zip(ours, theirs.values()):
        expected = expected.merged()
        difference = (region ^ expected).merged()
        allowed = 0.5 * expected.perimeter()
        parts = list(difference.sized(-2).merged().each())
        mistakes = [p for p in parts if distance is not None and breaks_distance(p, a, region, distance)]
        theirs_area = sum(part.area() for part in mistakes)
        good = difference.area() - theirs_area <= allowed and len(mistakes) == len(parts)
        is_off |= not good
        line = f"{name:<12} differs by {(difference.area() - theirs_area) / max(allowed, 1):6.3f} of what is allowed"
        line += f"; {len(mistakes)} places where KLayout breaks the distance" if mistakes else ""
        print(line + ("" if good else "; OFF"))
    return is_off


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
