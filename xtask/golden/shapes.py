"""Cases of `geometry.json`: a registered shape with parameters."""
import inspect
import random

import phidl.geometry as pg
from phidl import Device

import describe
from values import between, chance, layer_of, pick, port_of, some_layer, some_port, tuples

# Drawn without their glyphs: the font of the reference is its own.
LETTERED = {"litho_steps", "basic_die"}
# Results of set operations: nobody's starting points, so nothing to hash.
SETS = {"boolean", "offset", "outline", "invert", "xor_diff", "union"}


def widths(count, low, high):
    return [between(low, high) for _ in range(count)]


def size(low, high):
    return [between(low, high), between(low, high)]


def whole_size(low, high):
    return [float(random.randint(low, high)), float(random.randint(low, high))]


def resolution():
    return pick(1, 2.5, 3.7, 4.1, 7)


def polygon_outline():
    xs = [between(-8, -4), between(-3, 0), between(1, 4), between(5, 9), 0]
    ys = [between(0, 2), between(4, 8), between(6, 9), between(-2, 1), -between(5, 8)]
    return {"xpts": xs + xs[:1], "ypts": ys + ys[:1], "layer": some_layer()}


def meander():
    row = sorted(widths(5, 2, 8))
    return {
        "x_taper": [0, 10, 20, 30, 40], "w_taper": row, "meander_length": float(random.randint(60, 150)),
        "spacing_factor": 3, "min_spacing": 0.5, "layer": 0,
    }


def critical_currents():
    count = random.randint(2, 5)
    return {
        "wire_widths": widths(count, 0.2, 3), "wire_widths_wide": widths(count, 5, 9), "pad_size": [200, 200],
        "pad_gap": between(60, 120),
    }


def wire(low=0.1, high=0.3):
    width = between(low, high)
    return {"wire_width": width, "wire_pitch": round(width + between(0.2, 0.9), 3)}


def operand():
    name = pick("ellipse", "rectangle", "cross", "C", "ring", "flagpole", "litho_star", "L", "taper", "arc")
    params = {
        "ellipse": lambda: {"radii": size(3, 14)},
        "rectangle": lambda: {"size": size(3, 18)},
        "cross": lambda: {"length": between(14, 26), "width": between(2, 5)},
        "C": lambda: {"width": between(1, 3), "size": size(8, 19)},
        "L": lambda: {"width": between(1, 3), "size": size(8, 19)},
        "ring": lambda: {"radius": between(5, 12), "width": between(1, 3)},
        "flagpole": lambda: {"size": [between(9, 15), between(3, 6)], "stub_size": size(1, 4), "shape": pick("p", "d", "b", "q")},
        "litho_star": lambda: {"num_lines": random.randint(3, 9), "line_width": between(1, 2), "diameter": between(15, 25)},
        "taper": lambda: {"length": between(4, 20), "width1": between(1, 6), "width2": between(1, 6)},
        "arc": lambda: {"radius": between(5, 12), "width": between(1, 3), "theta": between(30, 300)},
    }[name]()
    return {"device": name, "params": {**params, "layer": 1}}


def offsetting(**more):
    return {"elements": operand(), **more, "precision": 0.0001, "layer": some_layer_of_one()}


def some_layer_of_one():
    n = random.randrange(60)
    return pick(0, n, [n, random.randrange(20)])


# Parameters of the same kind and range as those of the given reference results.
USUAL = {
    "rectangle": lambda: {"size": size(1, 50), "layer": some_layer()},
    "bbox": lambda: {"bbox": [[between(-20, 0), between(-20, 0)], [between(1, 20), between(1, 20)]], "layer": some_layer()},
    "cross": lambda: {"length": between(5, 50), "width": between(0.5, 5), "layer": some_layer()},
    "ellipse": lambda: {"radii": size(1, 50), "angle_resolution": resolution(), "layer": some_layer()},
    "circle": lambda: {"radius": between(1, 100), "angle_resolution": resolution(), "layer": some_layer()},
    "ring": lambda: {"radius": between(5, 50), "width": between(0.2, 3), "angle_resolution": resolution(), "layer": some_layer()},
    "arc": lambda: {"radius": between(5, 50), "width": between(0.2, 3), "theta": between(-350, 350), "start_angle": between(-180, 180), "angle_resolution": resolution(), "layer": some_layer()},
    "turn": lambda: {"port": some_port(), "radius": between(5, 50), "angle": between(-350, 350), "angle_resolution": 2.5, "layer": some_layer()},
    "straight": lambda: {"size": size(1, 50), "layer": some_layer()},
    "L": lambda: {"width": between(0.4, 4), "size": size(5, 50), "layer": some_layer()},
    "C": lambda: {"width": between(0.4, 4), "size": size(5, 50), "layer": some_layer()},
    "litho_steps": lambda: {"line_widths": widths(random.randint(1, 7), 0.5, 10), "line_spacing": between(1, 20), "height": between(10, 100), "layer": some_layer_of_one()},
    "litho_star": lambda: {"num_lines": random.randint(1, 30), "line_width": between(0.5, 5), "diameter": between(20, 300), "layer": some_layer_of_one()},
    "litho_calipers": lambda: {"notch_size": size(1, 8), "notch_spacing": between(0.5, 5), "num_notches": random.randint(1, 20), "offset_per_notch": between(0.01, 0.3), "row_spacing": between(0, 2), "layer1": 1, "layer2": 2},
    "litho_ruler": lambda: {"height": between(1, 5), "width": between(0.3, 1), "spacing": between(1, 4), "scale": [random.randint(1, 3) for _ in range(random.randint(1, 10))], "num_marks": random.randint(1, 30), "layer": some_layer_of_one()},
    "connector": lambda: {"midpoint": [between(-9, 9), between(-9, 9)], "width": between(0.5, 9), "orientation": pick(0, 90, 180, 270, between(-360, 720, 1))},
    "compass": lambda: {"size": size(1, 50), "layer": some_layer()},
    "compass_multi": lambda: {"size": size(1, 50), "ports": {side: random.randint(1, 5) for side in random.sample("NSEW", random.randint(1, 4))}, "layer": some_layer_of_one()},
    "flagpole": lambda: {"size": [between(10, 50), between(2, 20)], "stub_size": size(1, 4), "shape": pick("p", "q", "b", "d"), "taper_type": pick(None, "straight", "fillet"), "layer": some_layer()},
    "tee": lambda: {"size": [between(10, 50), between(2, 9)], "stub_size": size(1, 4), "taper_type": pick(None, "straight", "fillet"), "layer": some_layer()},
    "taper": lambda: {"length": between(1, 30), "width1": between(0.5, 8), "width2": pick(None, between(0.5, 8)), "layer": some_layer()},
    "ramp": lambda: {"length": between(1, 30), "width1": between(0.5, 8), "width2": pick(None, between(0.5, 8)), "layer": some_layer()},
    "hecken_taper": lambda: {"length": between(50, 400), "width1": pick(None, between(0.3, 3)), "width2": pick(None, between(3, 20)), "Z1": pick(None, 50), "Z2": pick(None, 200), "num_pts": 100, "layer": 0},
    "meander_taper": meander,
    "basic_die": lambda: {"size": whole_size(1000, 12000), "street_width": float(random.randint(20, 200)), "street_length": float(random.randint(100, 400)), "die_name": pick("", "chip7"), "text_size": 100, "text_location": pick("SW", "S", "SE", "NW", "N", "NE"), "layer": some_layer_of_one(), "draw_bbox": chance(0.5), "bbox_layer": 99},
    "racetrack_gradual": lambda: {"width": between(0.1, 1), "layer": some_layer_of_one()},
    "polygon_ports": polygon_outline,
    "grating": lambda: {"num_periods": random.randint(1, 25), "period": between(0.4, 1.2), "fill_factor": between(0.2, 0.8), "width_grating": between(2, 9), "length_taper": between(5, 20), "width": between(0.2, 0.9), "partial_etch": chance(0.4)},
    "test_via": lambda: {"num_vias": pick(20, 50, 100, random.randint(1, 60) * 2), "wire_width": 10, "via_width": float(random.randint(10, 20)), "via_spacing": float(random.randint(30, 60)), "pad_size": [300, 300], "min_pad_spacing": pick(0, 700)},
    "test_comb": lambda: {"pad_size": whole_size(100, 250), "wire_width": between(0.5, 2), "wire_gap": between(1, 4)},
    "test_ic": critical_currents,
    "test_res": lambda: {"pad_size": size(40, 80), "num_squares": pick(100, 500, 1000, 2500), "width": between(0.5, 2)},
    "optimal_hairpin": lambda: {"width": (w := between(0.1, 0.5)), "pitch": round(w * between(1.6, 3.5), 3), "length": between(4, 15), "turn_ratio": pick(2, 3, 4), "num_pts": pick(30, 50), "layer": some_layer()},
    "optimal_step": lambda: {"start_width": between(1, 20), "end_width": between(1, 30), "num_pts": pick(30, 50), "width_tol": 0.001, "anticrowding_factor": between(1.05, 1.3), "symmetric": chance(0.5), "layer": some_layer()},
    "optimal_90deg": lambda: {"width": between(1, 100), "num_pts": pick(15, 25), "length_adjust": between(0.8, 2), "layer": some_layer_of_one()},
    "snspd": lambda: {**wire(), "size": size(4, 15), "num_squares": None, "turn_ratio": pick(2, 3, 4), "terminals_same_side": chance(0.5), "layer": some_layer_of_one()},
    "snspd_expanded": lambda: {**wire(), "size": size(4, 15), "num_squares": None, "connector_width": between(1, 3), "connector_symmetric": chance(0.5), "turn_ratio": pick(2, 3, 4), "terminals_same_side": chance(0.5), "layer": some_layer_of_one()},
    "snspd_candelabra": lambda: {"wire_width": 0.52, "wire_pitch": between(0.54, 0.6), "haxis": float(random.randint(60, 100)), "vaxis": float(random.randint(35, 60)), "equalize_path_lengths": chance(0.5), "xwing": chance(0.5), "layer": 0},
    "ytron_round": lambda: {"rho": between(0.5, 4), "arm_lengths": whole_size(300, 600), "source_length": float(random.randint(300, 600)), "arm_widths": whole_size(150, 300), "theta": between(1, 5), "theta_resolution": 10, "layer": some_layer()},
    "boolean": lambda: {"A": operand(), "B": operand(), "operation": pick("not", "and", "or", "xor", "A-B", "B-A", "A+B"), "precision": 0.0001, "num_divisions": [random.randint(1, 3), random.randint(1, 3)], "layer": some_layer_of_one()},
    "offset": lambda: offsetting(distance=between(-0.4, 2), join=pick("miter", "bevel", "round")),
    "outline": lambda: offsetting(distance=between(0.1, 2)),
    "invert": lambda: offsetting(border=between(0.5, 6)),
    "xor_diff": lambda: {"A": operand(), "B": operand(), "precision": 0.0001},
    "union": lambda: {"D": operand(), "by_layer": chance(0.5), "precision": 0.0001, "layer": some_layer_of_one()},
}

# Functions without lengths to vary, or whose figures say nothing beyond these bounds: they are not varied one by one.
NOT_VARIED = {"snspd_candelabra", "hecken_taper"}


def variations(kind, default, usual, choices):
    """Values of one parameter that somebody may try: ordinary ones, whole ones, extremes, zero, negative, wrong ones."""
    if choices:
        return [*choices, *([None] if "or none" in kind else []), "middle"]
    if kind.endswith(" or none"):
        return [None, *variations(kind.removesuffix(" or none"), default, usual, choices)]
    base = default if default is not None else usual
    if kind == "number":
        base = base if isinstance(base, (int, float)) and base else 3
        return [base, int(base) or 1, between(0.2, 3) * base, base * 7, base / 10, base * 100, 0, -base, 1e-3]
    if kind == "integer":
        base = base if isinstance(base, int) and base else 5
        return [base, 1, 2, 3, 0, -1, base + 1, base * 2, random.randint(1, 3 * base)]
    if kind == "true or false":
        return [True, False]
    if kind in ("size", "point"):
        x, y = base or (4, 2)
        return [[x, y], [y, x], [x, x], [x * between(0.3, 3), y * between(0.3, 3)], [x * 20, y], [x, y * 20], [0, y], [x, -y], [x / 20, y]]
    if kind in ("layers", "layer"):
        several = [None, {"layers": [3, 1, [2, 5]]}] if kind == "layers" else []
        return [0, 7, [4, 2], 255, *several]
    if kind == "text":
        return [base, "", "a b"]
    if kind == "list of number" or kind == "list of integer":
        base = base or [1, 2, 3]
        return [base, base[:1], base[::-1], base + base, [v * 2 for v in base], []]
    return []


def params_of(name, entry):
    """The parameters that the reference has too: ours has some more."""
    theirs = inspect.signature(inspect.unwrap(getattr(pg, name))).parameters
    return [p for p in entry["params"] if p["name"] in theirs]


def varied(name, entry):
    """The defaults with one to three parameters changed."""
    params = dict(USUAL[name]()) if any(p["required"] for p in entry["params"]) else {}
    usual = USUAL[name]()
    names = [p for p in params_of(name, entry) if variations(p["kind"], p["default"], usual.get(p["name"]), p["choices"])]
    for p in random.sample(names, min(len(names), pick(1, 1, 2, 2, 3))):
        value = random.choice(variations(p["kind"], p["default"], usual.get(p["name"]), p["choices"]))
        params[p["name"]] = value
    return params


def mixed(name, entry):
    """Some usual parameters with some left at their defaults, and perhaps one varied."""
    params = {key: value for key, value in USUAL[name]().items() if chance(0.6) or required(entry, key)}
    if chance(0.3):
        params.update(varied(name, entry))
    return params


def required(entry, name):
    return any(p["name"] == name and p["required"] for p in entry["params"])


def arguments(entry, params):
    kinds = {p["name"]: p["kind"] for p in entry["params"]}
    given = {}
    for name, value in params.items():
        kind = kinds.get(name, "").removesuffix(" or none")
        if kind in ("layers", "layer"):
            value = layer_of(value)
        elif kind == "port" and value is not None:
            value = port_of(value)
        elif isinstance(value, dict) and "device" in value:
            value = drawn(value["device"], value["params"])
        elif kind in ("size", "point"):
            value = tuples(value)
        elif kind.startswith("list of") and isinstance(value, list):
            value = list(value)
        given[name] = value
    return given


REGISTRY = {}


def drawn(name, params):
    """The reference's device, its glyphs left out where it has some."""
    function = getattr(pg, name)
    arguments_ = arguments(REGISTRY[name], params)
    if name not in LETTERED:
        return function(**arguments_)
    text, pg.text = pg.text, lambda *_, **__: Device()
    try:
        return function(**arguments_)
    finally:
        pg.text = text


def compare_by_region(name, params):
    return name == "snspd_candelabra" or (name in ("tee", "flagpole") and params.get("taper_type") == "fillet")


def described(name, params):
    if name == "polygon_ports":
        # The reference closes its own defaults too, once more with every call.
        params = {"xpts": [-1, -1, 0, 0], "ypts": [0, 1, 1, 0], **params}
        # The reference closes the lists that it is given, so a case has them closed: it was drawn from open ones.
        x, y = params["xpts"], params["ypts"]
        if x[:1] == x[1:][-1:] and y[:1] == y[1:][-1:]:
            params = {**params, "xpts": x[:-1], "ypts": y[:-1]}
    region = compare_by_region(name, params)
    hashed = not region and name not in LETTERED and name not in SETS
    return describe.device(drawn(name, params), hashed, region or name in SETS)


def case(ident, name, params):
    """One case, as the file has it. Raises `describe.Unfit` where there is nothing to compare with."""
    made = {"id": ident, "device": name, "params": params}
    if name in LETTERED:
        made["text"] = True
    if compare_by_region(name, params):
        made["compare"] = "region"
    return {**made, "expect": describe.attempt(lambda: described(name, params))}


def redraw(given):
    return case(given["id"], given["device"], given["params"])


def cases(prefix, count, like_given):
    """Random cases: of every function as many, a third of each kind."""
    names = [name for name in USUAL if name in REGISTRY]
    for n in range(count):
        for name in names:
            entry = REGISTRY[name]
            kinds = [lambda n, e: USUAL[n](), mixed, varied]
            one_kind = like_given or name in NOT_VARIED or name in SETS
            make = kinds[0] if one_kind else kinds[n % 3]
            params = make(name, entry)
            try:
                yield case(f"{name}-{prefix}{n}", name, params)
            except describe.Unfit:
                continue
