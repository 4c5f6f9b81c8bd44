//! Fonts from files: found by [`find`], shaped by harfrust, flattened, and opened for GDSII.
//!
//! harfrust is HarfBuzz's own Rust port and brings the font reader along; `ttf-parser` and `rustybuzz`, its
//! predecessors, are no longer developed. `unicode-bidi` orders right-to-left text and `fontdb` knows where systems
//! keep their fonts.

mod contour;
mod find;
mod opened;
mod polygon;
mod shape;
mod stencil;

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use harfrust::font::Font;
use phidl_core::prelude::*;

use super::pen::Pen;
use contour::Flattened;

/// A TrueType or OpenType font with the measures of its lines.
pub(super) struct OutlineFont {
    font: Font,
    /// What the user calls it.
    name: String,
    /// Height of the ascender, in font units.
    ascender: f64,
    /// Distance of two baselines, in ascenders.
    line_pitch: f64,
}

impl OutlineFont {
    /// The font in a file at this path, or the font of the system with this name.
    pub(super) fn find(check: Check<'_>, font: &str) -> Result<Self> {
        find::font(check, font).and_then(|found| Self::new(check, font, found))
    }

    /// Distance of two baselines, in sizes.
    pub(super) fn line_pitch(&self) -> f64 {
        self.line_pitch
    }

    fn new(check: Check<'_>, name: &str, font: Font) -> Result<Self> {
        let line = font.metrics().h_line().unwrap_or_default();
        let [ascender, descender, gap] = [line.ascender, line.descender, line.line_gap].map(|v| v.to_f64());
        let given = format!("{name:?}");
        check.that("font", &given, !font.outline_glyphs().is_empty(), "have outlines, not only bitmaps")?;
        let has_lines = ascender > 0.0 && ascender - descender + gap > 0.0;
        check.that("font", &given, has_lines, "have an ascender, which gives the size")?;
        Ok(Self { font, name: name.to_owned(), ascender, line_pitch: (ascender - descender + gap) / ascender })
    }

    /// The letters of one line, with the pen starting at the origin, in micrometers.
    pub(super) fn line(&self, line: &str, pen: &Pen<'_>) -> Result<Vec<Vec<Point>>> {
        let scale = pen.size / self.ascender;
        let mut drawn: HashMap<u32, Vec<Vec<Point>>> = HashMap::new();
        let mut outlines = Vec::new();
        let mut points = 0;
        for placed in shape::line(&self.font, line) {
            let glyph = match drawn.entry(placed.glyph) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(new) => {
                    let letter = line[placed.byte..].chars().next().unwrap_or_default();
                    new.insert(self.glyph(placed.glyph, letter, pen, scale)?)
                }
            };
            points += glyph.iter().map(Vec::len).sum::<usize>();
            pen.check_points(points)?;
            let to_um = |p: &Point| (*p + placed.at) * scale;
            outlines.extend(glyph.iter().map(|outline| outline.iter().map(to_um).collect()));
        }
        Ok(outlines)
    }

    /// The outlines of a glyph, in font units: without holes, since GDSII has none. Errors name the letter it stands for.
    fn glyph(&self, glyph: u32, letter: char, pen: &Pen<'_>, scale: f64) -> Result<Vec<Vec<Point>>> {
        let tolerance = pen.tolerance / scale.abs();
        let refused = |rule: &str| Error::custom("text", format_args!("in {letter:?} of {:?}: {rule}", self.name));
        let contours = Flattened::glyph(&self.font, glyph, tolerance);
        let contours = contours.ok_or_else(|| refused("its outline cannot be read"))?;
        match pen.stencil {
            None => Ok(opened::outlines(contours)),
            Some(width) => stencil::bridged(contours, width / scale.abs()).map_err(|rule| refused(&rule)),
        }
    }
}

#[cfg(test)]
mod tests {
    use clipper2_rust::{FillRule, Path64, Paths64, Point64, area, area_paths, union_subjects_64};

    use super::*;

    /// Steps of the judging grid in a font unit.
    const STEPS: f64 = 1000.0;

    /// What some contours cover by the winding number, as the second engine sees it.
    fn covered(contours: &[Vec<Point>]) -> Paths64 {
        #[expect(clippy::cast_possible_truncation, reason = "a few thousand units")]
        let step = |units: f64| (units * STEPS).round() as i64;
        let path =
            |contour: &Vec<Point>| -> Path64 { contour.iter().map(|p| Point64::new(step(p.x), step(p.y))).collect() };
        union_subjects_64(&contours.iter().map(path).collect(), FillRule::NonZero)
    }

    /// The contours of Latin, Greek and Cyrillic letters, signs and accents of DejaVu Sans.
    fn letters() -> Vec<(u32, Vec<Vec<Point>>)> {
        let font = Font::new(dejavu::sans::regular(), 0).expect("a font");
        let glyphs = (0x21..0x530).filter_map(|code: u32| font.charmap().map_unicode(code).map(|id| id.to_u32()));
        glyphs.map(|glyph| (glyph, Flattened::glyph(&font, glyph, 1.0).expect("an outline"))).collect()
    }

    #[test]
    fn opened_glyphs_cover_what_their_contours_cover() {
        for (glyph, contours) in letters() {
            let expected = area_paths(&covered(&contours));
            let opened = area_paths(&covered(&opened::outlines(contours)));
            // Contours may be of either direction, and the area then has either sign.
            assert!((expected.abs() - opened.abs()).abs() <= 2.0 * STEPS * STEPS, "glyph {glyph}");
        }
    }

    #[test]
    fn bridged_glyphs_enclose_nothing() {
        for (glyph, contours) in letters() {
            let ink = stencil::bridged(contours, 60.0).unwrap_or_else(|error| panic!("glyph {glyph}: {error}"));
            assert!(covered(&ink).iter().all(|path| area(path) > 0.0), "glyph {glyph}");
        }
    }
}
