"""Descriptions of devices and the ways a call can fail, as the reference results have them."""
import math
import signal

import gdspy

# Points of a layer are left out of a description beyond this many vertices, unless they are what is compared.
MANY = 6000
# Seconds after which a call is given up.
PATIENCE = 10


class Unfit(Exception):
    """A result that no file of reference results can hold: it takes too long, is too large or not finite."""


def number(value):
    value = float(value)
    if not math.isfinite(value):
        raise Unfit("not finite")
    return int(value) if value == int(value) and abs(value) < 1e15 and isinstance(value, int) else value


def numbers(values):
    return [number(v) for v in values]


def rounded(points, digits=7):
    return [numbers(point) for point in points.round(digits).tolist()]


def port(p):
    return {"midpoint": numbers(p.midpoint), "width": number(p.width), "orientation": number(p.orientation)}


def ports(thing):
    return {str(name): port(p) for name, p in thing.ports.items()}


def box(thing):
    if thing.bbox is None:
        return [[0, 0], [0, 0]]
    return [numbers(corner) for corner in thing.bbox.tolist()]


def merged_area(polygons):
    merged = gdspy.boolean(polygons, None, "or", precision=1e-4, max_points=0)
    return round(number(merged.area()), 8) if merged is not None else 0.0


def layer(polygons, with_points):
    described = {
        "polygons": len(polygons),
        "vertices": sum(len(p) for p in polygons),
        "area": merged_area(polygons),
    }
    if with_points:
        described["points"] = [rounded(p) for p in polygons]
    return described


def info_value(value):
    if value is None or isinstance(value, (bool, str)):
        return value
    if isinstance(value, dict):
        return {str(k): info_value(v) for k, v in value.items()}
    if hasattr(value, "tolist"):
        return info_value(value.tolist())
    if isinstance(value, (list, tuple)):
        return [info_value(v) for v in value]
    return value if isinstance(value, int) else number(value)


def device(d, hashed=True, region=False):
    layers = d.get_polygons(by_spec=True)
    total = sum(len(p) for polygons in layers.values() for p in polygons)
    if total > 200_000:
        raise Unfit("too large")
    described = {
        "bbox": box(d),
        "layers": {
            f"{key[0]}/{key[1]}": layer(polygons, region or total <= MANY)
            for key, polygons in sorted(layers.items())
            if polygons
        },
        "ports": ports(d),
        "info": {str(k): info_value(v) for k, v in d.info.items()},
    }
    if hashed:
        described["hash_geometry"] = d.hash_geometry() if described["layers"] else None
    return described


def attempt(work):
    """What work returns, or how it fails. Calls that take too long are nobody's reference."""

    def give_up(*_):
        raise Unfit("too long")

    signal.signal(signal.SIGALRM, give_up)
    signal.alarm(PATIENCE)
    try:
        return work()
    except (Unfit, MemoryError, RecursionError) as unfit:
        raise Unfit(str(unfit)) from unfit
    except Exception as error:
        return {"error": type(error).__name__}
    finally:
        signal.alarm(0)
