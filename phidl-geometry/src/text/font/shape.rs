//! Which glyphs a line is made of and where they stand.
//!
//! A line is divided into runs of one direction, these into runs of one script; harfrust shapes each, with ligatures,
//! marks and kerning as the font has them. Runs are then set from left to right in their visual order.

use std::ops::Range;

use harfrust::font::Font;
use harfrust::{Buffer, Direction, Script, ShapeOptions, ShaperFont, unicode};
use phidl_core::geom::Point;
use unicode_bidi::{BidiInfo, Level};

/// A glyph of a line.
pub(super) struct Placed {
    /// Its number in the font.
    pub(super) glyph: u32,
    /// Where its origin is, in font units.
    pub(super) at: Point,
    /// The byte of the line where the text that it stands for begins.
    pub(super) byte: usize,
}

/// The glyphs of a line, with the pen starting at the origin.
pub(super) fn line(font: &Font, line: &str) -> Vec<Placed> {
    let shaper = ShaperFont::new(font);
    let mut pen = Point::ORIGIN;
    let mut placed = Vec::new();
    for (run, level) in visual_runs(line) {
        let mut scripts = script_runs(&line[run.clone()]);
        if level.is_rtl() {
            scripts.reverse();
        }
        for (part, script) in scripts {
            let part = run.start + part.start..run.start + part.end;
            let first = placed.len();
            pen = shape(&shaper, &line[part.clone()], script, level, pen, &mut placed);
            placed[first..].iter_mut().for_each(|glyph| glyph.byte += part.start);
        }
    }
    placed
}

/// Runs of one direction, from left to right.
fn visual_runs(line: &str) -> Vec<(Range<usize>, Level)> {
    let bidi = BidiInfo::new(line, None);
    let mut ordered = Vec::new();
    for paragraph in &bidi.paragraphs {
        let (levels, runs) = bidi.visual_runs(paragraph, paragraph.range.clone());
        ordered.extend(runs.into_iter().filter(|run| !run.is_empty()).map(|run| (run.clone(), levels[run.start])));
    }
    ordered
}

/// Runs of one script, in the order of the text. Marks, digits and punctuation belong to what is before them, at the
/// start to what follows.
fn script_runs(text: &str) -> Vec<(Range<usize>, Option<Script>)> {
    let mut runs: Vec<(Range<usize>, Option<Script>)> = Vec::new();
    for (start, character) in text.char_indices() {
        let end = start + character.len_utf8();
        let script = match unicode::script(u32::from(character)) {
            Script::COMMON | Script::INHERITED | Script::UNKNOWN => None,
            script => Some(script),
        };
        match runs.last_mut() {
            Some((range, known)) if script.is_none() || known.is_none() || script == *known => {
                range.end = end;
                *known = known.or(script);
            }
            _ => runs.push((start..end, script)),
        }
    }
    runs
}

/// Shapes one run and gives back where the pen stands behind it.
fn shape(
    shaper: &ShaperFont<'_, '_>,
    text: &str,
    script: Option<Script>,
    level: Level,
    mut pen: Point,
    placed: &mut Vec<Placed>,
) -> Point {
    let mut buffer = Buffer::new();
    buffer.push_str(text);
    buffer.set_direction(if level.is_rtl() { Direction::RightToLeft } else { Direction::LeftToRight });
    buffer.set_script(script);
    harfrust::shape(shaper, &mut buffer, ShapeOptions::new()).expect("invariant: a new buffer with a direction");
    for (info, position) in buffer.glyph_infos().iter().zip(buffer.glyph_positions()) {
        let vector = |x: i32, y: i32| Point::new(x.into(), y.into());
        let at = pen + vector(position.x_offset, position.y_offset);
        placed.push(Placed { glyph: info.glyph_id, at, byte: info.cluster as usize });
        pen += vector(position.x_advance, position.y_advance);
    }
    pen
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_to_left_text_is_set_from_its_end() {
        let runs: Vec<Range<usize>> = visual_runs("ab אב 12").into_iter().map(|(run, _)| run).collect();
        // Digits are left to right, and stand to the left of the Hebrew word that they follow.
        assert_eq!(runs, [0..3, 8..10, 3..8]);
    }

    #[test]
    fn marks_and_spaces_stay_with_their_script() {
        let runs: Vec<Range<usize>> = script_runs("(a, β!").into_iter().map(|(run, _)| run).collect();
        assert_eq!(runs, [0..4, 4..7]);
    }
}
