"""What `cargo xtask bench` times, done with other tools; it calls this script and puts the times beside ours.

    python peers.py SECTION [ARGUMENT]

SECTION is shapes, text, paths, routes, scene or files. Prints a line of JSON: for each work the peers that have such a
thing, with the best of a few times in seconds. Only the work is timed: imports, inputs and a cold first call are not.
"""
import json
import sys
import time
import warnings

warnings.simplefilter("ignore")


def best(work, patience=4.0, repeats=7, batch=0.01):
    """The shortest time of a call among some batches of calls; a first call is not counted. Slow work is timed once."""
    work()
    once = _time(work, 1)
    if once > patience:
        return once
    count = max(1, int(batch / once))
    rounds = max(1, min(repeats, int(patience / (once * count))))
    return min([once] + [_time(work, count) for _ in range(rounds)])


def _time(work, count):
    start = time.perf_counter()
    for _ in range(count):
        work()
    return (time.perf_counter() - start) / count


# Shapes and text: PHIDL -----------------------------------------------------------------------------------------------


def uncached_geometry():
    """PHIDL's shapes, with the memory taken away from those that have one: they draw anew, as ours do."""
    from phidl import geometry as pg

    for name in dir(pg):
        function = getattr(pg, name)
        if hasattr(function, "__wrapped__"):
            setattr(pg, name, function.__wrapped__)
    return pg


def from_value(pg, kind, value):
    """A parameter of PHIDL from what our registry writes for it."""
    from phidl import LayerSet
    from phidl.device_layout import Port

    if isinstance(value, dict) and "device" in value:
        function = getattr(pg, value["device"])
        return function if kind == "generator" else function(**from_params(pg, function, value["params"]))
    if kind == "port":
        return Port("port", value["midpoint"], value["width"], value["orientation"])
    if kind == "map of names to layer":
        layers = LayerSet()
        for name, layer in value.items():
            number, datatype = layer if isinstance(layer, list) else (layer, 0)
            layers.add_layer(name, number, datatype)
        return layers
    if kind.startswith("values by parameter"):
        return dict(value)
    if kind.startswith("a device, a list of devices") and len(value) == 1:
        return from_value(pg, "device", value[0])
    if isinstance(value, list):
        return [from_value(pg, "item", item) for item in value]
    return value


def from_params(pg, function, params):
    """The parameters that PHIDL's function has, too; ours have some more, which stand at their defaults."""
    import inspect

    names = inspect.signature(function).parameters
    return {name: from_value(pg, "item", value) for name, value in params.items() if name in names}


def shapes(jobs):
    """The work of every job in a file: a list of {"device", "params": {name: {"kind", "value"}}}."""
    pg = uncached_geometry()
    times = {}
    with open(jobs) as file:
        for job in json.load(file):
            function = getattr(pg, job["device"], None)
            if function is None:
                continue
            try:
                params = {name: from_value(pg, p["kind"], p["value"]) for name, p in job["params"].items()}
                if job["device"] == "union" and isinstance(params["D"], list):
                    params["D"] = together(params["D"])
                times[job["device"]] = {"PHIDL": best(lambda: function(**params))}
            except Exception as error:  # what PHIDL cannot draw is left out, and why is said
                print(f"{job['device']}: PHIDL {type(error).__name__}: {error}".splitlines()[0], file=sys.stderr)
    return times


def together(devices):
    """PHIDL's union takes a single device."""
    from phidl import Device

    device = Device()
    device << devices
    return device


def text(font):
    """A thousand characters in twenty lines."""
    pg = uncached_geometry()
    lines = "\n".join(["The quick brown fox jumps over the lazy dog 012345"] * 20)
    times = {"built-in font": {"PHIDL": best(lambda: pg.text(lines))}}
    if font:
        times["outline font"] = {"PHIDL": best(lambda: pg.text(lines, font=font))}
    return times


# Paths: PHIDL and gdstk -----------------------------------------------------------------------------------------------


def paths(_):
    import gdstk
    import numpy as np
    from phidl import CrossSection, Path
    from phidl import path as pp

    t = np.arange(10_000) * 0.01
    points = np.column_stack((5.0 * t, 5.0 * np.sin(t)))

    def extrude_phidl():
        path = Path(points)
        cross = CrossSection()
        cross.add(width=0.5, layer=1, ports=("in", "out"))
        cross.add(width=1.0, offset=2, layer=2)
        cross.add(width=1.0, offset=-2, layer=3)
        return path.extrude(cross)

    strips = dict(width=[0.5, 1.0, 1.0], offset=[0, 2, -2], layer=[1, 2, 3])
    flex = [list(p) for p in points]

    def extrude_flex():
        return gdstk.FlexPath(flex, **strips).to_polygons()

    def extrude_robust():
        path = gdstk.RobustPath(flex[0], **strips)
        for point in flex[1:]:
            path.segment(point)
        return path.to_polygons()

    radii = [3.0 + 0.01 * i for i in range(1000)]

    def euler_phidl():
        return [pp.euler(radius, 90) for radius in radii]

    def euler_phidl_extruded():
        return [pp.euler(radius, 90).extrude(0.5, 1) for radius in radii]

    def flex_bends(points_per_turn):
        bends = []
        for radius in radii:
            path = gdstk.FlexPath((0, 0), 0.5, layer=1, tolerance=radius * (1 - np.cos(np.pi / points_per_turn)))
            bends.append(path.turn(radius, np.pi / 2).to_polygons())
        return bends

    def flex_bends_within():
        return [gdstk.FlexPath((0, 0), 0.5, layer=1, tolerance=1e-3).turn(r, np.pi / 2).to_polygons() for r in radii]

    def robust_bends_within():
        return [gdstk.RobustPath((0, 0), 0.5, layer=1, tolerance=1e-3).arc(r, 0, np.pi / 2).to_polygons() for r in radii]

    corners = [(i // 2 * 40.0, 0.0 if i % 4 in (0, 3) else 40.0) for i in range(1000)]

    def smooth_phidl():
        return pp.smooth(points=corners, radius=5, corner_fun=pp.euler, use_eff=False)

    return {
        "extrude": {"PHIDL": best(extrude_phidl), "FlexPath": best(extrude_flex), "RobustPath": best(extrude_robust)},
        "bends": {"PHIDL": best(euler_phidl)},
        "bends, extruded": {"PHIDL": best(euler_phidl_extruded), "FlexPath": best(lambda: flex_bends(720))},
        "bends within 1 nm, extruded": {"FlexPath": best(flex_bends_within), "RobustPath": best(robust_bends_within)},
        "smooth": {"PHIDL": best(smooth_phidl)},
    }


# Routes: PHIDL and gdstk ----------------------------------------------------------------------------------------------


def routes(pairs):
    """Every pair of ports in a file: [[x, y, width, orientation], [x, y, width, orientation], points of the way]."""
    import gdstk
    from phidl import path as pp
    from phidl import routing as pr
    from phidl.device_layout import Port

    with open(pairs) as file:
        pairs = json.load(file)
    ports = [[Port(name, p[:2], p[2], p[3]) for name, p in zip("ab", pair)] for pair in pairs]
    ways = [[tuple(point) for point in pair[2]] for pair in pairs]

    def routable(pair):
        try:
            pr.route_smooth(*pair, radius=10, smooth_options={"corner_fun": pp.arc}, layer=0)
            return True
        except ValueError:
            return False

    roomy = [pair for pair in ports if routable(pair)]
    if len(roomy) < len(ports):
        print(f"routes: PHIDL draws {len(roomy)} of {len(ports)}; its time is scaled up", file=sys.stderr)

    def way_points():
        return [pr.path_manhattan(a, b, 10) for a, b in ports]

    def devices():
        arcs = {"corner_fun": pp.arc}
        return [pr.route_smooth(a, b, radius=10, smooth_options=arcs, layer=0) for a, b in roomy]

    def flex():
        return [gdstk.FlexPath(way, 2, bend_radius=10, tolerance=9.5e-5).to_polygons() for way in ways]

    return {
        "way points": {"PHIDL": best(way_points)},
        "devices": {"PHIDL": best(devices) * len(ports) / len(roomy), "FlexPath": best(flex)},
    }


# Cells and files: gdstk -----------------------------------------------------------------------------------------------


def scene(_):
    import gdstk

    def build_rectangles():
        cell = gdstk.Cell("field")
        for i in range(1_000_000):
            x, y = (i % 1000) * 3.0, (i // 1000) * 3.0
            cell.add(gdstk.Polygon([(x, y), (x + 2, y), (x + 2, y + 1), (x, y + 1)], layer=1))
        return cell

    ten = gdstk.Cell("ten")
    for i in range(10):
        ten.add(gdstk.rectangle((i * 0.1, 0), (i * 0.1 + 0.05, 1), layer=1))

    def flatten_array():
        cell = gdstk.Cell("array")
        cell.add(gdstk.Reference(ten, rotation=0.5235987755982988, columns=1000, rows=1000, spacing=(2, 2)))
        cell.flatten()
        return cell

    top = ten
    for level in range(6):
        parent = gdstk.Cell(f"level {level}")
        for i in range(10):
            parent.add(gdstk.Reference(top, (20 * i, 3 * i), rotation=(7 * i + level) * 0.017453292519943295))
        top = parent

    return {
        "rectangles": {"gdstk": best(build_rectangles)},
        "flatten": {"gdstk": best(flatten_array)},
        "box": {"gdstk": best(top.bounding_box)},
    }


def files(folder):
    """Reads squares.gds and placements.gds in a folder, and writes each again."""
    import os

    import gdstk

    times = {}
    for name in ("squares", "placements"):
        path = os.path.join(folder, f"{name}.gds")
        library = gdstk.read_gds(path)
        again = os.path.join(folder, "again.gds")
        times[f"{name}, write"] = {"gdstk": best(lambda: library.write_gds(again))}
        times[f"{name}, read"] = {"gdstk": best(lambda: gdstk.read_gds(path))}
    return times


SECTIONS = {"shapes": shapes, "text": text, "paths": paths, "routes": routes, "scene": scene, "files": files}

if __name__ == "__main__":
    section, argument = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None
    print(json.dumps(SECTIONS[section](argument)))
