"""Reference results drawn by the Python package `phidl`, in the format of the given ones.

    python draw.py REGISTRY.json OUT --seed 1 --count 20          further cases with random parameters
    python draw.py REGISTRY.json OUT --redraw FOLDER              the cases of a folder once more

REGISTRY.json is what `cargo xtask devices --json` prints. Release 1.7.2 draws everything but `route_basic`, which 1.5.2
has; run by that release, only `route_basic.json` is written.
"""
import argparse
import json
import pathlib
import random
import resource
import warnings

import phidl

import describe

OLD = phidl.__version__.startswith("1.5")
# A mistaken parameter may ask for any number of points.
MEMORY = 3 << 30


def kinds():
    """Per file: how its cases are drawn again, and how further ones are made."""
    import routes

    if OLD:
        return {"route_basic": (routes.redraw, routes.basic_cases, 3)}
    import paths
    import placement
    import shapes

    return {
        "geometry": (shapes.redraw, shapes.cases, 1),
        "path": (paths.redraw, paths.cases, 10),
        "routing": (routes.redraw, routes.cases, 2),
        "placement": (placement.redraw, placement.cases, 5),
    }


def redrawn(folder, name, redraw):
    cases = json.loads((folder / f"{name}.json").read_text(encoding="utf-8"))
    for case in cases:
        try:
            yield redraw(case)
        except describe.Unfit as unfit:
            print(f"{case['id']}: {unfit}")


def write(file, cases):
    with open(file, "w", encoding="utf-8") as out:
        out.write("[\n" + ",\n".join(json.dumps(case, allow_nan=False) for case in cases) + "\n]\n")
    print(f"{file}: {len(cases)} cases")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("registry", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=10)
    parser.add_argument("--redraw", type=pathlib.Path)
    parser.add_argument("--only", default="", help="one file, such as path")
    parser.add_argument("--like-given", action="store_true", help="parameters of the ranges of the given results only")
    flags = parser.parse_args()
    warnings.filterwarnings("ignore")
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    flags.out.mkdir(parents=True, exist_ok=True)
    if not OLD:
        import shapes

        shapes.REGISTRY.update({entry["name"]: entry for entry in json.loads(flags.registry.read_text(encoding="utf-8"))})
    for name, (redraw, further, share) in kinds().items():
        if flags.only and name != flags.only:
            continue
        random.seed(f"{flags.seed} {name}")
        cases = redrawn(flags.redraw, name, redraw) if flags.redraw else further(f"s{flags.seed}-", flags.count * share, flags.like_given)
        write(flags.out / f"{name}.json", list(cases))


main()
