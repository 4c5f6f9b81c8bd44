"""Draws the little fonts of this folder: pip install fonttools, python make.py

Each has an o, a square ring of 600 units around a square hole of 200, and the measures 800, -200, 0. They differ in what
they are: curves as CFF (OpenType), a weight axis (TrueType), two faces in one file.
"""

from fontTools.fontBuilder import FontBuilder
from fontTools.pens.t2CharStringPen import T2CharStringPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTCollection

GLYPHS = [".notdef", "o", "n"]
ADVANCE = 700


def square(pen, x, size, hole):
    """A square from x on; counter-clockwise, a hole clockwise."""
    low = (600 - size) / 2
    corners = [(x, low), (x + size, low), (x + size, low + size), (x, low + size)]
    if hole:
        corners.reverse()
    pen.moveTo(corners[0])
    for corner in corners[1:]:
        pen.lineTo(corner)
    pen.closePath()


def ring(pen, left, outer, hole):
    square(pen, left, outer, False)
    square(pen, left + (outer - hole) / 2, hole, True)


def dome(pen):
    """Half a disc of radius 300 above the baseline, of two cubic quarters."""
    k = 300 * 0.5522847498
    pen.moveTo((650, 0))
    pen.curveTo((650, k), (350 + k, 300), (350, 300))
    pen.curveTo((350 - k, 300), (50, k), (50, 0))
    pen.closePath()


def start(kind, style):
    font = FontBuilder(1000, isTTF=kind == "ttf")
    font.setupGlyphOrder(GLYPHS)
    font.setupCharacterMap({ord("o"): "o", ord("n"): "n"})
    font.setupNameTable({"familyName": "Phidl Test", "styleName": style}, mac=False)
    return font


def finish(font):
    font.setupHorizontalMetrics({glyph: (ADVANCE, 50) for glyph in GLYPHS})
    font.setupHorizontalHeader(ascent=800, descent=-200)
    font.setupOS2(sTypoAscender=800, sTypoDescender=-200, sTypoLineGap=0, usWinAscent=800, usWinDescent=200)
    font.setupPost(keepGlyphNames=False)
    font.updateHead(created=0, modified=0)
    font.font.recalcTimestamp = False
    return font.font


def cff():
    font = start("otf", "Regular")
    charstrings = {}
    for glyph, draw in [(".notdef", None), ("o", lambda p: ring(p, 50, 600, 200)), ("n", dome)]:
        pen = T2CharStringPen(ADVANCE, None)
        if draw:
            draw(pen)
        charstrings[glyph] = pen.getCharString()
    font.setupCFF("PhidlTest-Regular", {}, charstrings, {})
    return finish(font)


def truetype(style, outer=600, hole=200):
    font = start("ttf", style)
    glyphs = {}
    for glyph in GLYPHS:
        pen = TTGlyphPen(None)
        if glyph != ".notdef":
            ring(pen, 50, outer, hole)
        glyphs[glyph] = pen.glyph()
    font.setupGlyf(glyphs)
    return font


def variable():
    """The hole closes from 200 units at weight 400 to 100 at weight 900."""
    from fontTools.ttLib.tables.TupleVariation import TupleVariation

    font = truetype("Regular")
    font.setupFvar([("wght", 400, 400, 900, "Weight")], [])
    inner = [(50, 50), (50, -50), (-50, -50), (-50, 50)]
    corners = [(0, 0)] * 4
    hole = font.font["glyf"]["o"].coordinates[4:8]
    middle = (350, 300)
    moves = [(50 if x < middle[0] else -50, 50 if y < middle[1] else -50) for x, y in hole]
    assert sorted(moves) == sorted(inner)
    phantoms = [(0, 0)] * 4
    variation = TupleVariation({"wght": (0.0, 1.0, 1.0)}, corners + moves + phantoms)
    font.setupGvar({"o": [variation]})
    return finish(font)


def collection():
    faces = TTCollection()
    faces.fonts = [finish(truetype("Regular")), finish(truetype("Fine", hole=400))]
    return faces


cff().save("cff.otf")
variable().save("variable.ttf")
collection().save("two.ttc")
