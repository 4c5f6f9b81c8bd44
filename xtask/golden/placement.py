"""Cases of `placement.json`: small scripts of placement words."""
import random

import phidl.geometry as pg
from phidl import Device, Group

import describe
from values import between, chance, pick

EDGES = ("x", "xmin", "xmax", "y", "ymin", "ymax")


def shape():
    return pick(
        lambda: ("taper", {"length": between(3, 17), "width1": between(1, 5), "width2": between(1, 5), "layer": 4}),
        lambda: ("compass", {"size": [between(2, 20), between(2, 20)], "layer": 1}),
        lambda: ("arc", {"radius": between(5, 20), "width": between(0.5, 2), "theta": between(20, 150), "layer": 3}),
        lambda: ("flagpole", {"size": [between(10, 20), between(3, 8)], "stub_size": [between(1, 3), between(1, 3)], "shape": pick("p", "q", "b", "d"), "layer": 5}),
        lambda: ("straight", {"size": [between(2, 6), between(4, 20)], "layer": 2}),
    )()


PORTS = {"taper": ["1", "2"], "compass": ["N", "S", "E", "W"], "arc": ["1", "2"], "flagpole": ["1", "2"], "straight": ["1", "2"]}


def point(reach=10):
    return [between(-reach, reach), between(-reach, reach)]


def placed(on):
    """A placement word with what it acts on, or without for the whole device."""
    word = pick(
        lambda: {"op": "movex", "by": between(-30, 30)},
        lambda: {"op": "movey", "by": between(-30, 30)},
        lambda: {"op": "move", "by": point(30)},
        lambda: {"op": "move", "origin": point(5), "destination": point(30)},
        lambda: {"op": "rotate", "angle": pick(45, 90, 180, 270, -30, between(-180, 180)), "center": point()},
        lambda: {"op": "mirror", "p1": point(), "p2": point(13)},
    )()
    return {"op": word.pop("op"), **({"on": on} if on else {}), **word}


def setting(on, names):
    if chance(0.3):
        return {"op": "set", "on": on, "what": "center", "value": point()}
    if chance(0.5):
        return {"op": "set", "on": on, "what": pick(*EDGES), "value": between(-20, 20)}
    edge = pick(*EDGES)
    other = pick(*[e for e in EDGES if e[0] == edge[0]])
    return {"op": "set", "on": on, "what": edge, "from": [pick(*names), other], "plus": between(-5, 5)}


def distributing(names):
    direction = pick("x", "y")
    return {
        "op": "distribute", "on": names, "direction": direction, "spacing": between(0, 15), "separation": chance(0.5),
        "edge": pick(*[e for e in EDGES if e[0] == direction]),
    }


def operation(names, devices):
    on = random.choice(names)
    kind = random.random()
    if kind < 0.4:
        return placed(on)
    if kind < 0.6:
        return setting(on, names)
    if kind < 0.7:
        return {"op": "align", "on": names, "alignment": pick(*EDGES)}
    if kind < 0.8:
        return distributing(names)
    other = random.choice([name for name in names if name != on])
    return {"op": "connect", "on": on, "port": pick(*PORTS[devices[on]]), "to": [other, pick(*PORTS[devices[other]])], "overlap": pick(0, between(-1, 1))}


def script():
    ops, devices = [], {}
    for i in range(random.randint(2, 5)):
        device, params = shape()
        ops.append({"op": "add_ref", "as": f"r{i}", "device": device, "params": params})
        devices[f"r{i}"] = device
    ops += [operation(list(devices), devices) for _ in range(random.randint(3, 9))]
    if chance(0.5):
        ops.append({"op": "whole", "do": placed(None)})
    if chance(0.4):
        ops.append({
            "op": "array", "device": "rectangle", "params": {"size": [2, 3], "layer": 9}, "columns": random.randint(1, 4),
            "rows": random.randint(1, 4), "spacing": [between(3, 9), between(4, 9)], "rotate": pick(0, 30, 90),
        })
    return ops


def port_name(name):
    return int(name) if name.isdigit() else name


def place(thing, op):
    if op["op"] == "movex":
        thing.movex(op["by"])
    elif op["op"] == "movey":
        thing.movey(op["by"])
    elif op["op"] == "rotate":
        thing.rotate(op["angle"], center=op["center"])
    elif op["op"] == "mirror":
        thing.mirror(op["p1"], op["p2"])
    elif "by" in op:
        thing.move(op["by"])
    else:
        thing.move(origin=op["origin"], destination=op["destination"])


def perform(op, cell, references):
    kind = op["op"]
    if kind == "add_ref":
        references[op["as"]] = cell.add_ref(getattr(pg, op["device"])(**op["params"]))
    elif kind == "array":
        array = cell.add_array(getattr(pg, op["device"])(**op["params"]), columns=op["columns"], rows=op["rows"], spacing=op["spacing"])
        array.rotate(op["rotate"])
    elif kind == "set":
        value = op["value"] if "value" in op else getattr(references[op["from"][0]], op["from"][1]) + op["plus"]
        setattr(references[op["on"]], op["what"], value)
    elif kind == "align":
        Group([references[name] for name in op["on"]]).align(op["alignment"])
    elif kind == "distribute":
        group = Group([references[name] for name in op["on"]])
        group.distribute(direction=op["direction"], spacing=op["spacing"], separation=op["separation"], edge=op["edge"])
    elif kind == "connect":
        target = references[op["to"][0]].ports[port_name(op["to"][1])]
        references[op["on"]].connect(port_name(op["port"]), target, overlap=op["overlap"])
    elif kind == "whole":
        place(cell, op["do"])
    else:
        place(references[op["on"]], op)


def described(ops):
    cell, references = Device(), {}
    for op in ops:
        perform(op, cell, references)
    expect = describe.device(cell)
    expect["references"] = {name: {"bbox": describe.box(r), "ports": describe.ports(r)} for name, r in references.items()}
    return expect


def case(ident, ops):
    return {"id": ident, "ops": ops, "expect": describe.attempt(lambda: described(ops))}


def redraw(given):
    return case(given["id"], given["ops"])


def cases(prefix, count, _):
    """Random scripts."""
    for n in range(count):
        try:
            yield case(f"place-{prefix}{n}", script())
        except describe.Unfit:
            continue
