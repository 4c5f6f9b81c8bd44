//! [`Face`]: the font of a text, built in or from a file.

use phidl_core::prelude::*;

use super::deplof;
#[cfg(feature = "fonts")]
use super::font::OutlineFont;
use super::pen::Pen;

/// The font of a text.
pub(super) enum Face {
    /// The built-in font.
    Deplof,
    /// A font from a file.
    #[cfg(feature = "fonts")]
    Outline(Box<OutlineFont>),
}

impl Face {
    /// The built-in font, that of a file, or one of the system.
    pub(super) fn find(check: Check<'_>, font: &str) -> Result<Self> {
        if font.eq_ignore_ascii_case("DEPLOF") { Ok(Self::Deplof) } else { Self::outline(check, font) }
    }

    #[cfg(feature = "fonts")]
    fn outline(check: Check<'_>, font: &str) -> Result<Self> {
        OutlineFont::find(check, font).map(|found| Self::Outline(Box::new(found)))
    }

    #[cfg(not(feature = "fonts"))]
    fn outline(check: Check<'_>, font: &str) -> Result<Self> {
        let rule = "be DEPLOF, since this program was built without the feature `fonts` of phidl-geometry";
        check.that("font", format_args!("{font:?}"), false, rule).map(|()| Self::Deplof)
    }

    /// Distance of two baselines, in sizes.
    pub(super) fn line_pitch(&self) -> f64 {
        match self {
            Self::Deplof => deplof::LINE_PITCH / deplof::CAP_HEIGHT,
            #[cfg(feature = "fonts")]
            Self::Outline(font) => font.line_pitch(),
        }
    }

    /// The outlines of one line, with the pen starting at the origin (µm).
    pub(super) fn line(&self, line: &str, pen: &Pen<'_>) -> Result<Vec<Vec<Point>>> {
        match self {
            Self::Deplof => deplof_line(line, pen.size),
            #[cfg(feature = "fonts")]
            Self::Outline(font) => font.line(line, pen),
        }
    }
}

/// The letters of one line, with the pen starting at the origin.
fn deplof_line(line: &str, size: f64) -> Result<Vec<Vec<Point>>> {
    let mut pen = 0.0;
    let mut outlines = Vec::new();
    for character in line.chars() {
        if character == ' ' {
            pen += deplof::SPACE;
            continue;
        }
        let glyph = deplof::glyph(character).ok_or_else(|| unknown(character))?;
        // Multiplied before divided: a thousandth of the size has no exact float, the products of whole numbers do.
        let to_um = |p: &Point| Point::new(p.x + pen, p.y) * size / deplof::CAP_HEIGHT;
        outlines.extend(glyph.outlines.iter().map(|outline| outline.iter().map(to_um).collect()));
        pen += glyph.advance();
    }
    Ok(outlines)
}

fn unknown(character: char) -> Error {
    let code = u32::from(character);
    let known = "space, \"!\" to \"~\", and \"µ\"";
    Error::custom(
        "text",
        format_args!("the character {character:?} (U+{code:04X}) is not in DEPLOF, which has {known}"),
    )
}
