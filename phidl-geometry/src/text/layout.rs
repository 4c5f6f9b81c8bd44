//! From lines of text to placed outlines, the same for every font.

use phidl_core::prelude::*;

use super::font::Face;
use super::{Justify, deplof};

/// How letters are drawn.
pub(super) struct Pen {
    /// Size of the text (µm), not zero.
    pub(super) size: f64,
    /// Largest distance of a chord from its curve (µm).
    pub(super) tolerance: f64,
    /// Width of the bridges through counters (µm).
    pub(super) stencil: Option<f64>,
}

/// All outlines of a text, line by line, each in the order of its letters.
pub(super) fn set(check: Check<'_>, text: &str, face: &Face, pen: &Pen, justify: Justify) -> Result<Vec<Vec<Point>>> {
    let mut drawn = Vec::new();
    let pitch = face.line_pitch() * pen.size;
    for (number, line) in text.split('\n').enumerate() {
        let line = line.strip_suffix('\r').unwrap_or(line);
        let mut outlines = match face {
            Face::Deplof => deplof_line(check, line, pen.size)?,
            Face::Outline(font) => font.line(line, pen)?,
        };
        let by = Point::new(justification(&outlines, justify), -(number as f64) * pitch);
        outlines.iter_mut().flatten().for_each(|point| *point += by);
        drawn.append(&mut outlines);
    }
    Ok(drawn)
}

/// How far a line moves to the right. A line without ink stays where it is.
fn justification(outlines: &[Vec<Point>], justify: Justify) -> f64 {
    let Some(ink) = Rect::around(outlines.iter().flatten().copied()) else {
        return 0.0;
    };
    match justify {
        Justify::Left => 0.0,
        Justify::Right => -ink.max.x,
        Justify::Center => -ink.center().x,
    }
}

/// The letters of one line, with the pen starting at the origin.
fn deplof_line(check: Check<'_>, line: &str, size: f64) -> Result<Vec<Vec<Point>>> {
    let mut pen = 0.0;
    let mut outlines = Vec::new();
    for character in line.chars() {
        if character == ' ' {
            pen += deplof::SPACE;
            continue;
        }
        let glyph = deplof::glyph(character).ok_or_else(|| unknown(check, character))?;
        // Multiplied before divided: a thousandth of the size has no exact float, the products of whole numbers do.
        let place = |p: &Point| Point::new(p.x + pen, p.y) * size / deplof::CAP_HEIGHT;
        outlines.extend(glyph.outlines.iter().map(|outline| outline.iter().map(place).collect()));
        pen += glyph.advance();
    }
    Ok(outlines)
}

fn unknown(check: Check<'_>, character: char) -> Error {
    let code = u32::from(character);
    check
        .that(
            "text",
            format_args!("with {character:?} (U+{code:04X})"),
            false,
            "be of the characters of DEPLOF: space, \"!\" to \"~\", and \"µ\"; other fonts have others",
        )
        .expect_err("invariant: the condition is false")
}
