"""Times booleans and offsets of other tools; `cargo xtask compare` calls it and puts the times beside ours.

    python compare_boolean.py SCENE.gds OPERATION DISTANCE THREADS PEER

The scene has layer 1 and, for booleans, layer 2. OPERATION is or, and, not, xor or offset. PEER is a name of PEERS;
"klayout, tiled=8" is the tiling processor with 8 x 8 tiles. Prints a line of JSON: the
best of a few times in seconds, or null if this peer does not take part. Only the work is timed: shapes are in memory, as
the tool wants them, before and after.
"""
import json
import sys
import time


def best(work, patience=20.0):
    """The best of five times; fast work is timed for half a second, slow work less often."""
    times = []
    while len(times) < 5 or sum(times) < 0.5:
        start = time.perf_counter()
        result = work()
        times.append(time.perf_counter() - start)
        del result
        if sum(times) > patience:
            break
    return min(times)


def klayout_layers(path):
    import klayout.db as kdb

    layout = kdb.Layout()
    layout.read(path)
    top = layout.top_cell()
    regions = [kdb.Region(top.begin_shapes_rec(layout.layer(number, 0))).flatten() for number in (1, 2)]
    return kdb, layout.dbu, regions


def klayout_flat(path, operation, distance, _threads):
    kdb, dbu, (a, b) = klayout_layers(path)
    steps = round(distance / dbu)
    work = {
        "or": lambda: (a + b).merged(),
        "and": lambda: a & b,
        "not": lambda: a - b,
        "xor": lambda: a ^ b,
        "offset": lambda: a.sized(steps, 2).merged(),
    }[operation]
    return best(work)


def klayout_tiled(path, operation, distance, threads, sides=(2, 4, 8, 16, 32)):
    kdb, dbu, (a, b) = klayout_layers(path)
    box = (a.bbox() + b.bbox()) if operation != "offset" else a.bbox()
    steps = round(distance / dbu)
    script = {
        "or": "_output(out, a + b)",
        "and": "_output(out, a & b)",
        "not": "_output(out, a - b)",
        "xor": "_output(out, a ^ b)",
        "offset": "_output(out, a.sized(%d, 2))" % steps,
    }[operation]

    def work(tile):
        processor = kdb.TilingProcessor()
        out = kdb.Region()
        processor.dbu = dbu
        processor.input("a", a)
        processor.input("b", b)
        processor.output("out", out)
        processor.tile_size(tile, tile)
        if operation == "offset":
            processor.tile_border(3 * abs(distance), 3 * abs(distance))
        processor.threads = threads
        processor.queue(script)
        processor.execute("")
        out.merge()
        return out

    # The best of several tile sizes counts.
    side = max(box.width(), box.height()) * dbu
    return min(best(lambda: work(side / parts + dbu)) for parts in sides)


def gdstk_layers(path):
    import gdstk

    cell = gdstk.read_gds(path).top_level()[0]
    cell.flatten()
    layers = [[p for p in cell.polygons if p.layer == number] for number in (1, 2)]
    return gdstk, layers


def gdstk_flat(path, operation, distance, _threads):
    gdstk, (a, b) = gdstk_layers(path)
    if operation == "offset":
        return best(lambda: gdstk.offset(a, distance, join="miter", precision=1e-4, use_union=True))
    return best(lambda: gdstk.boolean(a, b, operation, precision=1e-4))


def phidl_flat(path, operation, distance, _threads):
    import numpy as np
    from phidl import Device
    from phidl import geometry as pg

    _, layers = gdstk_layers(path)
    devices = []
    for polygons in layers:
        device = Device()
        for polygon in polygons:
            device.add_polygon(np.asarray(polygon.points))
        devices.append(device)
    if operation == "offset":
        return best(lambda: pg.offset(devices[0], distance, precision=1e-4), patience=5.0)
    return best(lambda: pg.boolean(devices[0], devices[1], operation, precision=1e-4), patience=5.0)


PEERS = {"klayout": klayout_flat, "klayout, tiled": klayout_tiled, "gdstk": gdstk_flat, "phidl": phidl_flat}

if __name__ == "__main__":
    scene, operation, distance, threads, peer = sys.argv[1:]
    peer, _, tiles = peer.partition("=")
    tiled = {"sides": (int(tiles),)} if tiles else {}
    print(json.dumps(PEERS[peer](scene, operation, float(distance), int(threads), **tiled)))
