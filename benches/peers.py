"""The work of `phidl-core/benches/scene.rs`, done with gdstk: `pip install gdstk`, then `python benches/peers.py`."""
import time

import gdstk


def timed(label, work, repeat=3):
    best = min(_time(work) for _ in range(repeat))
    print(f"{label:<48} {best * 1e3:12.3f} ms")


def _time(work):
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def build_rectangles():
    cell = gdstk.Cell("field")
    for i in range(1_000_000):
        x, y = (i % 1000) * 3.0, (i // 1000) * 3.0
        cell.add(gdstk.Polygon([(x, y), (x + 2, y), (x + 2, y + 1), (x, y + 1)], layer=1))
    return cell


def ten_rectangles():
    cell = gdstk.Cell("ten")
    for i in range(10):
        cell.add(gdstk.rectangle((i * 0.1, 0), (i * 0.1 + 0.05, 1), layer=1))
    return cell


def flatten_array(child):
    cell = gdstk.Cell("array")
    cell.add(gdstk.Reference(child, rotation=0.5235987755982988, columns=1000, rows=1000, spacing=(2, 2)))
    cell.flatten()


def turned_hierarchy():
    cell = ten_rectangles()
    for level in range(6):
        parent = gdstk.Cell(f"level {level}")
        for i in range(10):
            parent.add(gdstk.Reference(cell, (20 * i, 3 * i), rotation=(7 * i + level) * 0.017453292519943295))
        cell = parent
    return cell


timed("build a million rectangles", build_rectangles)
timed("flatten 1000 x 1000 cells of 10 polygons", lambda child=ten_rectangles(): flatten_array(child), repeat=1)
timed("bbox, 6 levels, a million turned instances", lambda top=turned_hierarchy(): top.bounding_box())
