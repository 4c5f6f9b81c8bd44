"""Cases of `path.json`: pieces or smoothed corners, moved about, perhaps extruded."""
import random

import numpy
import phidl.path as pp
from phidl import CrossSection, Path

import describe
from values import between, chance, layer_of, pick


def angle(widely):
    if widely and chance(0.4):
        return pick(45, 90, -90, 30, 60, 120, 180, -135, 270, -60, 1, -3)
    return between(15, 250 if chance(0.5) else 175) * pick(1, -1)


def line():
    return {"points": [[0, 0], [between(1, 5), between(-1, 1)], [between(6, 9), between(3, 6)], [between(10, 14), between(3, 6)]]}


def straight(widely):
    counts = [2, 10, 100, *([1, 3, 7] if widely else [])]
    return {"fn": "straight", "params": {"length": between(1, 40), "num_pts": pick(*counts)}}


def arc(widely):
    counts = [20, 61, 720, *([8, 45, 360, 90.5] if widely else [])]
    return {"fn": "arc", "params": {"radius": between(5, 30), "angle": angle(widely), "num_pts": pick(*counts)}}


def euler(widely):
    turn = angle(widely) if widely else between(15, 170) * pick(1, -1)
    share = pick(1.0, 0.5, between(0.05, 1), *([0, 0.25, 0.75, 1 / 3] if widely else []))
    counts = [40, 101, 720, *([16, 64, 360] if widely else [])]
    return {"fn": "euler", "params": {"radius": between(2, 20), "angle": turn, "p": share, "use_eff": chance(0.5), "num_pts": pick(*counts)}}


def spiral(widely):
    turns = pick(2, 3.5, 5, *([2.2, 2.7, 1, between(1.2, 6)] if widely else []))
    counts = [400, *([100, 1000] if widely else [])]
    return {"fn": "spiral", "params": {"num_turns": turns, "gap": between(1, 3), "inner_gap": between(3, 9), "num_pts": pick(*counts)}}


def segment(widely):
    made = pick(lambda _: line(), straight, arc, arc, euler, euler, spiral)(widely)
    if widely and "params" in made:
        made["params"] = {name: value for name, value in made["params"].items() if chance(0.75)}
        if made["fn"] == "spiral":  # ten thousand points by default
            made["params"].setdefault("num_pts", 400)
    return made


def zigzag():
    return [
        [0, 0], [between(30, 50), between(-3, 3)], [between(80, 100), between(38, 56)], [between(80, 100), between(-60, -40)],
        [between(140, 180), between(-60, -40)],
    ]


def staircase():
    points, x, y = [[0, 0]], 0, 0
    for i in range(random.randint(2, 6)):
        step = random.randint(20, 60)
        x, y = (x + step, y) if i % 2 == 0 else (x, y + pick(step, -step))
        points.append([x, y])
    return points


def scattered():
    return [[between(-100, 100), between(-100, 100)] for _ in range(random.randint(3, 6))]


def smooth(widely):
    made = {"points": pick(zigzag, staircase, scattered)() if widely else zigzag(), "radius": between(2, 8)}
    made["corner_fun"] = pick("arc", "euler")
    if made["corner_fun"] == "euler":
        made["use_eff"] = chance(0.5)
        if widely and chance(0.5):
            made["p"] = pick(1.0, 0.5, between(0.1, 1))
    if widely and chance(0.4):
        made["num_pts"] = pick(40, 101, 360)
    return made


def operation():
    return pick(
        lambda: {"op": "rotate", "angle": between(-180, 180), "center": [between(-5, 5), between(-5, 5)]},
        lambda: {"op": "move", "by": [between(-50, 50), between(-50, 50)]},
        lambda: {"op": "mirror", "p1": [between(-5, 5), 1], "p2": [between(-5, 5), 7]},
    )()


def three_sections():
    return {"sections": [
        {"width": between(0.3, 0.9), "offset": 0, "layer": 1, "ports": ["in", "out"], "name": "wg"},
        {"width": between(0.1, 0.4), "offset": between(0.8, 1.5), "layer": 2, "name": "heater"},
        {"width": between(0.1, 0.4), "offset": -between(0.8, 1.5), "layer": [3, 1], "ports": ["a", None], "name": "etch"},
    ]}


def extrusion():
    return pick(
        lambda: {"width": between(0.4, 1.5), "layer": pick(0, 1, 3, [4, 2])},
        lambda: {"width": [between(0.2, 1.4), between(0.2, 1.4)], "layer": 5},
        lambda: {"width": between(0.4, 1.5), "layer": 1, "simplify": pick(0.01, 0.001)},
        three_sections,
        lambda: None,
    )()


def piece(given):
    if "points" in given:
        return numpy.array(given["points"], dtype=float)
    return getattr(pp, given["fn"])(**given["params"])


def build(case):
    if "smooth" in case:
        given = dict(case["smooth"])
        corner = {"arc": pp.arc, "euler": pp.euler}[given.pop("corner_fun", "euler")]
        points = numpy.array(given.pop("points"), dtype=float)
        path = pp.smooth(points=points, corner_fun=corner, **given)
    else:
        path = Path()
        for given in case["segments"]:
            path.append(piece(given))
    for op in case["ops"]:
        if op["op"] == "rotate":
            path.rotate(op["angle"], center=op["center"])
        elif op["op"] == "mirror":
            path.mirror(op["p1"], op["p2"])
        else:
            path.move(op["by"])
    return path


def cross_section(sections):
    made = CrossSection()
    for section in sections:
        made.add(
            width=section["width"], offset=section["offset"], layer=layer_of(section["layer"]),
            ports=tuple(section.get("ports", (None, None))), name=section["name"],
        )
    return made


def extruded(path, given):
    if "sections" in given:
        return path.extrude(cross_section(given["sections"]))
    simplify = {"simplify": given["simplify"]} if "simplify" in given else {}
    return path.extrude(given["width"], layer=layer_of(given["layer"]), **simplify)


def described(case):
    path = build(case)
    expect = {
        "points": describe.rounded(path.points),
        "length": describe.number(path.length()),
        "start_angle": describe.number(path.start_angle),
        "end_angle": describe.number(path.end_angle),
        "hash_geometry": path.hash_geometry(),
        "bbox": describe.box(path),
    }
    if "extrude" in case:
        expect["device"] = describe.device(extruded(path, case["extrude"]))
    return expect


def complete(made):
    return {**made, "expect": describe.attempt(lambda: described(made))}


def redraw(given):
    return complete({key: value for key, value in given.items() if key != "expect"})


def made(ident, widely):
    case = {"id": ident}
    if chance(0.3):
        case["smooth"] = smooth(widely)
    else:
        case["segments"] = [segment(widely) for _ in range(random.randint(1, 4))]
    case["ops"] = [operation() for _ in range(random.randint(0, 2))]
    extrude = extrusion()
    return {**case, "extrude": extrude} if extrude else case


def cases(prefix, count, like_given):
    """Random cases: half of them like the given ones, half of a wider range."""
    for n in range(count):
        try:
            yield complete(made(f"path-{prefix}{n}", widely=n % 2 == 1 and not like_given))
        except describe.Unfit:
            continue
