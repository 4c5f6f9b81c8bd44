"""Cases of `routing.json` and `route_basic.json`: ways and routes between two ports."""
import math
import random

import phidl.routing as pr
from phidl import Device

import describe
from values import between, layer_of, pick, port_of, some_port

QUARTERS = (0, 90, 180, 270)
WAYS = ["path_straight", "path_L", "path_U", "path_J", "path_C", "path_V", "path_Z", "path_xy", "path_manhattan"]
ROUTES = ["route_smooth", "route_sharp", "route_quad", "route_xy"]


def quarter_port():
    return some_port(300, QUARTERS)


def any_port():
    return some_port(300)


def opposite(port, turn):
    """A port somewhere that looks back at another one, or turned from that."""
    return {**quarter_port(), "orientation": (port["orientation"] + 180 + turn) % 360}


def ahead(port):
    """A port straight in front of another one."""
    distance, angle = between(5, 100), math.radians(port["orientation"])
    x, y = port["midpoint"]
    midpoint = [round(x + distance * math.cos(angle), 9), round(y + distance * math.sin(angle), 9)]
    return {**port, "midpoint": midpoint, "width": between(0.5, 4), "orientation": (port["orientation"] + 180) % 360}


def lengths(kind):
    return {
        "U": lambda: {"length1": between(20, 200)},
        "J": lambda: {"length1": between(20, 150), "length2": between(10, 150)},
        "C": lambda: {"length1": between(20, 150), "left1": between(-100, 100), "length2": between(20, 150)},
        "Z": lambda: {"length1": between(20, 150), "length2": between(10, 100)},
    }.get(kind, dict)()


def pair(kind):
    """Two ports in a position that this kind of way is for; now and then in any position."""
    first = quarter_port()
    if random.random() < 0.15:
        return first, any_port()
    second = {
        "straight": lambda: ahead(first),
        "L": lambda: opposite(first, pick(90, -90)),
        "U": lambda: opposite(first, pick(0, 180)),
        "J": lambda: opposite(first, pick(90, -90)),
        "C": lambda: opposite(first, pick(0, 180)),
    }.get(kind, any_port if kind in ("V", "Z") else quarter_port)()
    return first, second


def directions():
    return pick("xxyx", "yx", "xyx", "yxy", "yyxyx", "xy", "xxyy", "xyxy")


def way(name):
    kind = name.removeprefix("path_")
    first, second = pair(kind)
    extra = {"manhattan": lambda: {"radius": between(1, 40)}, "xy": lambda: {"directions": directions()}}.get(kind, lambda: lengths(kind))()
    return {"port1": first, "port2": second, **extra}


def route_width():
    return pick(None, between(0.5, 3), [between(0.5, 2), between(0.5, 2)])


def shaped(name):
    kind = pick("manhattan", "manhattan", "Z", "Z", "V", "L", "U", "J", "C", "straight")
    first, second = pair(kind)
    params = {"port1": first, "port2": second, "path_type": kind, "width": route_width(), "layer": pick(1, [2, 3])}
    if name == "route_smooth":
        params["radius"] = between(2, 10)
    return {**params, **lengths(kind)}


def route(name):
    if name == "route_quad":
        width = lambda: pick(None, between(0.5, 3))
        return {"port1": any_port(), "port2": any_port(), "width1": width(), "width2": width(), "layer": 4}
    if name == "route_xy":
        return {"port1": quarter_port(), "port2": quarter_port(), "directions": directions(), "width": pick(None, between(0.5, 3)), "layer": 2}
    return shaped(name)


def facing():
    """Two ports that look at each other, side by side or at an angle."""
    first = {**some_port(50, QUARTERS if random.random() < 0.5 else None)}
    angle = math.radians(first["orientation"])
    forward, left = between(10, 120), between(-60, 60)
    x, y = first["midpoint"]
    midpoint = [
        round(x + forward * math.cos(angle) - left * math.sin(angle), 9),
        round(y + forward * math.sin(angle) + left * math.cos(angle), 9),
    ]
    turn = 180 if random.random() < 0.9 else pick(90, 170, 0)
    return first, {"midpoint": midpoint, "width": between(0.5, 4), "orientation": (first["orientation"] + turn) % 360}


def basic():
    first, second = facing()
    return {
        "port1": first, "port2": second, "path_type": pick("sine", "straight"), "width_type": pick("sine", "straight"),
        "width1": pick(None, between(0.5, 3)), "width2": pick(None, between(0.5, 3)), "num_path_pts": pick(41, 99, random.randint(2, 99)),
        "layer": pick(0, 5),
    }


def arguments(params):
    given = dict(params)
    for name in ("port1", "port2"):
        # The routes of this library read which port of a device they are given by its name.
        given[name] = port_of(given[name], name)
    if "layer" in given:
        given["layer"] = layer_of(given["layer"])
    if isinstance(given.get("width"), list):
        given["width"] = tuple(given["width"])
    return given


def described(name, params):
    made = getattr(pr, name)(**arguments(params))
    if isinstance(made, Device):
        return described_basic(made) if name == "route_basic" else describe.device(made)
    return {"points": describe.rounded(made.points)}


def described_basic(d):
    polygons = d.get_polygons()
    return {
        "bbox": describe.box(d),
        "points": [describe.rounded(p, 6) for p in polygons],
        "polygons": len(polygons),
        "vertices": sum(len(p) for p in polygons),
        "area": describe.number(d.area()),
        "ports": describe.ports(d),
        "length": describe.number(d.info["length"]),
    }


def case(ident, name, params):
    return {"id": ident, "fn": name, "params": params, "expect": describe.attempt(lambda: described(name, params))}


def redraw(given):
    return case(given["id"], given["fn"], given["params"])


def each(names, make, prefix, count):
    for n in range(count):
        for name in names:
            try:
                yield case(f"{name}-{prefix}{n}", name, make(name))
            except describe.Unfit:
                continue


def cases(prefix, count, _):
    """Random ways and routes, of every function as many."""
    yield from each(WAYS, way, prefix, count)
    yield from each(ROUTES, route, prefix, count)


def basic_cases(prefix, count, _):
    """Random cases of `route_basic`, which an older release of the library has."""
    yield from each(["route_basic"], lambda _: basic(), prefix, count)
