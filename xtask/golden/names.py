"""Lists every public name of PHIDL, for the page "Coming from PHIDL".

    python names.py > docs/guide/phidl-names.json

Needs phidl==1.7.2. Members of classes include those that instances get when they are made.
"""

import json

import phidl.device_layout as dl
import phidl.geometry as pg
import phidl.path as pp
import phidl.quickplotter as pq
import phidl.routing as pr
import phidl.utilities as pu


def functions(module):
    own = lambda value: callable(value) and getattr(value, "__module__", "").startswith("phidl")
    home = lambda value: getattr(value, "__module__", None) == module.__name__
    return sorted(
        name for name, value in vars(module).items()
        if not name.startswith("_") and own(value) and home(value) and (name.islower() or not isinstance(value, type))
    )


def members(instance):
    return sorted({name for name in [*dir(instance), *vars(instance)] if not name.startswith("_")})


def main():
    device = dl.Device("d")
    polygon = device.add_polygon([(0, 0), (1, 0), (0, 1)])
    instances = {
        "Layer": dl.Layer(),
        "LayerSet": dl.LayerSet(),
        "Port": dl.Port(),
        "Polygon": polygon,
        "Device": device,
        "DeviceReference": dl.DeviceReference(device),
        "CellArray": dl.CellArray(device, 2, 2, (1, 1)),
        "Label": device.add_label(),
        "Group": dl.Group(),
        "Path": pp.arc(),
        "CrossSection": dl.CrossSection(),
    }
    names = {
        module.__name__.removeprefix("phidl."): functions(module) for module in [pg, pp, pr, pu, pq]
    }
    names["device_layout"] = functions(dl)
    names |= {kind: members(instance) for kind, instance in instances.items()}
    print(json.dumps(names, indent=1))


if __name__ == "__main__":
    main()
