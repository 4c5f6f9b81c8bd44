"""Random parameters, and the forms that the reference library takes for the JSON of a case."""
import random

import phidl
from phidl.device_layout import Port


def between(low, high, digits=3):
    return round(random.uniform(low, high), digits)


def chance(share):
    return random.random() < share


def pick(*values):
    return random.choice(values)


def some_layer():
    """A layer in one of its forms: a number, a number with a datatype, several of them."""
    n = random.randrange(60)
    return pick(0, n, n, [n, random.randrange(20)], {"layers": [n % 15, n % 15 + 21, [n % 15 + 40, 3]]})


def some_port(reach=50, turns=None):
    orientation = pick(*turns) if turns else between(0, 360, 1)
    return {
        "midpoint": [between(-reach, reach), between(-reach, reach)],
        "width": between(0.5, 4),
        "orientation": orientation,
    }


def layer_of(value):
    if isinstance(value, dict):
        return {layer_of(v) for v in value["layers"]}
    return tuple(value) if isinstance(value, list) else value


def port_of(value, name=1):
    return Port(name=name, midpoint=value["midpoint"], width=value["width"], orientation=value["orientation"])


def tuples(value):
    """Lists of plain numbers as tuples, which is how people write sizes."""
    if isinstance(value, list):
        return tuple(tuples(v) for v in value)
    return value


def reference_version():
    return phidl.__version__
