//! From lines of text to placed outlines, the same for every font.

use phidl_core::prelude::*;

use super::Justify;
use super::face::Face;
use super::pen::Pen;

/// All outlines of a text, line by line, each in the order of its letters.
pub(super) fn set(text: &str, face: &Face, pen: &Pen<'_>, justify: Justify) -> Result<Vec<Vec<Point>>> {
    let mut drawn = Vec::new();
    let mut points = 0;
    let pitch = face.line_pitch() * pen.size;
    for (number, line) in text.split('\n').enumerate() {
        let line = line.strip_suffix('\r').unwrap_or(line);
        let mut outlines = face.line(line, pen)?;
        let by = Point::new(justification(&outlines, justify), -(number as f64) * pitch);
        outlines.iter_mut().flatten().for_each(|point| *point += by);
        points += outlines.iter().map(Vec::len).sum::<usize>();
        pen.check_points(points)?;
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
