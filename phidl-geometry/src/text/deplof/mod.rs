//! DEPLOF, the built-in stencil font: every printable ASCII character and µ, drawn for etching.
//!
//! Nothing of a stencil may fall out, whether the letters are etched or what is around them. So no glyph has a counter:
//! wherever another font closes a bowl, ours leaves a gap. It follows from how glyphs are described. Nearly all of them
//! are trees of center lines, which the pen of one width follows; a tree has no circle to enclose anything. The others
//! (`*`, `` ` ``, commas) are blunt little outlines.
//!
//! | measure | units | at size 10 |
//! |---|---|---|
//! | [`CAP_HEIGHT`]: capitals and digits; `size` is this height | 1000 | 10 µm |
//! | [`STROKE`]: width of every stroke | 200 | 2 µm |
//! | [`GAP`]: no gap within a glyph is narrower; the bridges are 100 wide | 80 | 0.8 µm |
//! | [`LINE_PITCH`]: from baseline to baseline | 1500 | 15 µm |
//! | [`SPACE`]: advance of a space | 500 | 5 µm |
//! | left indent of most glyphs: the space between letters | 100 | 1 µm |
//!
//! Indents, widths, advances and ink boxes are those of docs/reference/text.md; the drawings are our own. All coordinates are
//! whole units, so a stroke that is neither level, upright nor diagonal may be a unit wider or narrower, and a size of
//! whole micrometers puts every vertex on a grid of 1 nm. Corners are 55° or blunter on both sides; inside an acute one
//! the notch is filled to where it is 100 wide.
//!
//! The metrics themselves let four glyphs touch or come near their neighbors: `&` and `^` have no indent, and `"` and `#`
//! reach beyond their advance. Put a space beside these.
//!
//! A font file in the repository was the alternative. It would draw letters with counters, or need bridges cut by a
//! boolean engine, and a text editor could not show it for review.

mod stroke;
mod table;

use std::sync::LazyLock;

use phidl_core::geom::Point;

use table::{GLYPHS, Part, Row};

/// Height of capitals and digits, in units; `size` is this height in micrometers.
pub const CAP_HEIGHT: f64 = 1000.0;
/// Width of every stroke, in units.
pub const STROKE: f64 = 200.0;
/// The narrowest gap within any glyph, in units.
pub const GAP: f64 = 80.0;
/// From the baseline of one line to that of the next, in units.
pub const LINE_PITCH: f64 = 1500.0;
/// Advance of a space, in units.
pub const SPACE: f64 = 500.0;

/// How wide the end of a filled acute notch is, in units.
const NOTCH: f64 = 100.0;

/// A drawn character. All lengths are in units, [`CAP_HEIGHT`] of which are the `size` of a text.
#[derive(Debug, Clone, PartialEq)]
pub struct Glyph {
    /// The character.
    pub character: char,
    /// From the pen to where the ink begins, as a rule.
    pub indent: f64,
    /// How far the pen moves beyond the indent.
    pub width: f64,
    /// The outlines with the pen at the origin: clockwise, disjoint.
    pub outlines: Vec<Vec<Point>>,
}

impl Glyph {
    /// How far the pen moves: indent and width.
    #[must_use]
    pub fn advance(&self) -> f64 {
        self.indent + self.width
    }

    fn new((character, indent, width, parts): &Row) -> Self {
        let outline = |part: &Part| match part {
            Part::Strokes(lines) => stroke::outline(lines),
            Part::Outline(corners) => corners.iter().copied().map(Point::from).collect(),
        };
        Self {
            character: *character,
            indent: (*indent).into(),
            width: (*width).into(),
            outlines: parts.iter().map(outline).collect(),
        }
    }
}

/// All glyphs in the order of their character codes.
///
/// ```
/// use phidl_geometry::text::deplof;
/// assert_eq!(deplof::glyphs().len(), 95);
/// ```
#[must_use]
pub fn glyphs() -> &'static [Glyph] {
    static ALL: LazyLock<Vec<Glyph>> = LazyLock::new(|| GLYPHS.iter().map(Glyph::new).collect());
    &ALL
}

/// The glyph of a character in the font. The Greek letter μ (U+03BC) is drawn as the micro sign µ (U+00B5).
///
/// ```
/// use phidl_geometry::text::deplof;
/// let o = deplof::glyph('O').expect("all of ASCII is there");
/// assert_eq!((o.indent, o.advance(), o.outlines.len()), (100.0, 900.0, 1)); // one open ring
/// ```
#[must_use]
pub fn glyph(character: char) -> Option<&'static Glyph> {
    let character = if character == 'μ' { 'µ' } else { character };
    let index = glyphs().binary_search_by_key(&character, |glyph| glyph.character).ok()?;
    Some(&glyphs()[index])
}
