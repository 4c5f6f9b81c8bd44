//! Lettering: [`text()`], the built-in stencil font [`deplof`], and fonts from files.
//!
//! A line of text is a list of outlines around a pen that starts at x = 0, whatever the font; `layout` then justifies
//! the lines by their ink and stacks them. So both kinds of fonts share one meaning of `justify` and of empty lines.
//!
//! Text is drawn flat. A cell per letter and a reference per use was the alternative: it makes smaller files, but text is
//! a sliver of any mask, kerned text has few repeats, and one flat cell can be offset, inverted or bridged at once.

pub mod deplof;
mod face;
#[cfg(feature = "fonts")]
mod font;
mod layout;
mod pen;

use phidl_core::prelude::*;
use phidl_macros::{Choice, device};

use face::Face;
use pen::Pen;

/// The smallest tolerance, in sizes: some thousand corners to a curve.
const FINEST: f64 = 1e-8;

/// Largest length of a text (bytes).
const MOST_TEXT: usize = 1_000_000;

/// Alignment of the lines of a [`text()`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum Justify {
    /// The pen of every line starts at x = 0.
    #[default]
    Left,
    /// The ink of every line ends at x = 0.
    Right,
    /// The ink of every line has its middle at x = 0.
    Center,
}

/// Draws lettering, one or several lines of it, in the built-in stencil font or in any TrueType or OpenType font.
///
/// ```text
///     ┃  ┏━╸ ╻ ╻ ╻ ┏━┓   ┬
///     ┃  ┃   ┣━┫ ┃ ┣━┛   │ size
///   ──╂──┗━╸─╹─╹─╹─╹──   ┴ first baseline, y = 0
///     ┃  ┏━┓ ┏━┓           line pitch
///     ┃  ┗━┫ ┗━┫
///   ──╂──╺━┛─╺━┛──────     second baseline
///   x = 0: the pen (left), the end or the middle of the ink (right, center)
/// ```
///
/// Lines end at `\n` or `\r\n`; empty ones count. Line k has its baseline at `-k` line pitches.
///
/// | | built-in | other fonts |
/// |---|---|---|
/// | `font` | `DEPLOF`, in any case | the path of a font file, or the name of a font of the system |
/// | `size` | height of capitals | the ascender of the font |
/// | line pitch | 1.5 sizes | ascender, descender and line gap of the font |
/// | characters | ASCII and µ, see [`deplof`] | those of the font; its replacement box for others |
/// | spacing | the table of [`deplof`] | shaping and kerning by the font, right-to-left scripts too |
///
/// Fonts other than DEPLOF need the feature `fonts` of this crate, which is on by default.
///
/// `font` is first tried as the path of a file, then as a name among the fonts of the system: a family, such as
/// `DejaVu Sans`, or a PostScript name, such as `DejaVuSans-Bold`. A file with several fonts gives the first one, a variable
/// font its default instance. System fonts differ between machines: a mask that must not change names a file. The cache
/// knows the path only: a file that changes during a run is not read again.
///
/// Right and center align the ink: spaces at the end of a line have no effect. At the left, the ink of DEPLOF starts at the
/// indent of the first glyph. A negative size turns the text by 180°.
///
/// # Ports
/// None.
///
/// # Errors
/// A size of zero. A character missing in DEPLOF. A font that is neither a file nor installed, or that cannot be read.
/// A text of more than a million bytes or ten million points. With `stencil`, a glyph whose counters leave no room for a bridge.
///
/// # Numerics
/// DEPLOF is drawn from whole thousandths of `size`. Outline fonts are scaled from their unhinted design; a curve is cut
/// into equal steps of its parameter, the fewest that stay within `tolerance`. A hole is opened along a seam between two
/// vertices that exist anyway, so its area stays exact and no rounding can open the seam.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// # use pg::text::Justify;
/// let label = pg::text("chip99", 100, Justify::Left, 1, "DEPLOF")?;
/// assert_eq!(label.bbox(), Some(Rect::new((10, -30), (430, 110))));
/// let lines = pg::TextParams::default().text("wafer 7\ndie 12").justify(Justify::Center).build()?;
/// assert!(lines.ymin() < -14.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `text` in parameters and DEPLOF's metrics; the letters are our own.
#[device(picture = "docs/text.svg")]
pub fn text(
    /// The text; `\n` starts a new line.
    #[default("abcd")]
    text: String,
    /// Height of capitals, or of the ascender of an outline font; a negative one turns the text by 180°.
    #[default(10.0)]
    #[param(unit = "um")]
    size: f64,
    /// Where the lines are put.
    #[default(Justify::Left)]
    justify: Justify,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
    /// `DEPLOF`, the path of a font file, or the name of a font of the system.
    #[default("DEPLOF")]
    font: String,
    /// Largest distance of a chord from a curve of an outline font. DEPLOF has no curves.
    #[default(0.005)]
    #[param(named, unit = "um", above = 0.0)]
    tolerance: f64,
    /// Width of the bridges that open every counter of an outline font, so that it can be etched; none leaves counters
    /// closed. DEPLOF has no counters.
    #[default(None)]
    #[param(named, unit = "um", above = 0.0)]
    stencil: Option<f64>,
) -> Result<Device> {
    check.that("size", format_args!("{size} µm"), size != 0.0, "not be 0")?;
    check.at_least("tolerance", tolerance, ("10⁻⁸ of the size", FINEST * size.abs()))?;
    check.at_most("number of bytes of text", text.len(), MOST_TEXT)?;
    let face = Face::find(check, &font)?;
    let pen = Pen { check, size, tolerance, stencil };

    let mut d = Device::builder("text");
    for outline in layout::set(&text, &face, &pen, justify)? {
        d.add_polygon(outline, &layer)?;
    }
    d.build()
}
