//! Lettering in fonts from files: scale, holes, kerning, curves, stencils.

use std::path::PathBuf;

use clipper2_rust::{FillRule, Path64, Point64, area, union_subjects_64};
use pg::TextParams;
use phidl_core::prelude::*;
use phidl_geometry as pg;

use crate::text::assert_box;

/// DejaVu Sans in a folder that lives as long as the value.
struct DejaVu(tempfile::TempDir);

impl DejaVu {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        // The suffix says nothing about the kind of file.
        std::fs::write(folder.path().join("DejaVu.TTF"), dejavu::sans::regular()).unwrap();
        Self(folder)
    }

    fn path(&self) -> PathBuf {
        self.0.path().join("DejaVu.TTF")
    }

    fn write(&self, text: &str) -> TextParams {
        TextParams::default().text(text).font(self.path().to_str().unwrap()).size(ASCENDER)
    }

    fn draw(&self, text: &str) -> Device {
        self.write(text).build().unwrap()
    }
}

/// Ascender of DejaVu Sans in its units, of which 2048 make an em; as the size of a text, it makes a unit a micrometer.
const ASCENDER: f64 = 1901.0;

#[test]
fn a_font_from_a_file_is_scaled_by_its_ascender_and_its_lines_by_its_own_pitch() {
    let font = DejaVu::new();
    // H of DejaVu Sans is 1493 units high, with stems from 201 to 403 and 1137 to 1339.
    assert_box(&font.draw("H"), [201.0, 0.0, 1339.0, 1493.0]);
    // Its line pitch is 1901 + 483 units.
    assert_box(&font.draw("H\nH"), [201.0, -2384.0, 1339.0, 1493.0]);
    assert_box(&font.write("H").size(-ASCENDER).build().unwrap(), [-1339.0, -1493.0, -201.0, 0.0]);
}

#[test]
fn holes_are_cut_open_and_keep_their_area() {
    let font = DejaVu::new();
    let o = font.draw("o");
    assert_eq!(o.polygons().len(), 1);
    let inside = Rect::new((600, 500), (650, 550)).center();
    assert!(!winds(&o, inside) && winds(&o, Point::new(200.0, 560.0)));
    // B has two holes, i two parts.
    assert_eq!((font.draw("B").polygons().len(), font.draw("i").polygons().len()), (1, 2));
}

/// A counter-clockwise outline for the second engine, in thousandths of a micrometer.
fn path(points: &[Point]) -> Path64 {
    #[expect(clippy::cast_possible_truncation, reason = "the text is some centimeters long")]
    let step = |um: f64| (um * 1000.0).round() as i64;
    let path: Path64 = points.iter().map(|p| Point64::new(step(p.x), step(p.y))).collect();
    if area(&path) < 0.0 { path.into_iter().rev().collect() } else { path }
}

/// Whether the drawing covers a point, by the winding number.
fn winds(device: &Device, p: Point) -> bool {
    let turns = |points: &[Point]| -> f64 {
        (0..points.len())
            .map(|i| {
                let (a, b) = (points[i] - p, points[(i + 1) % points.len()] - p);
                a.cross(b).atan2(a.dot(b))
            })
            .sum()
    };
    device.polygons().any(|polygon| turns(polygon.points).abs() > 3.0)
}

#[test]
fn letters_are_kerned_joined_and_ordered_by_the_font() {
    let font = DejaVu::new();
    let width = |text: &str| font.draw(text).xsize();
    let (a, v) = (width("A"), width("V"));
    assert!(width("AV") < a + v, "a kerned pair is narrower than its letters");
    // Arabic lam and alef join to one glyph; each alone is another.
    assert_ne!(font.draw("لا").polygons().len(), font.draw("ل").polygons().len() + font.draw("ا").polygons().len());
    // Hebrew runs to the left: alef, the first letter, stands at the right.
    let (alef, word) = (font.draw("א"), font.draw("אל"));
    let last = word.polygons().max_by(|p, q| p.points[0].x.total_cmp(&q.points[0].x)).unwrap();
    assert_eq!(last.points.len(), alef.polygons().next().unwrap().points.len());
    // A letter with its accent as a mark is drawn like the composed letter.
    assert!((width("e\u{301}") - width("é")).abs() < 1e-9);
}

#[test]
fn a_finer_tolerance_brings_more_points_and_less_error() {
    let font = DejaVu::new();
    let o = |tolerance: f64| font.write("O").tolerance(tolerance).build().unwrap();
    let (coarse, fine, finest) = (o(10.0), o(0.1), o(0.001));
    let points = |d: &Device| d.polygons().map(|p| p.points.len()).sum::<usize>();
    assert!(points(&coarse) < points(&fine) && points(&fine) < points(&finest));
    // A strip along the contours, some 8000 units long, is all that can differ.
    assert!((coarse.area() - finest.area()).abs() < 10.0 * 8000.0);
    assert!((fine.area() - finest.area()).abs() < 0.1 * 8000.0);
}

#[test]
fn a_stencil_of_an_outline_font_encloses_nothing() {
    let font = DejaVu::new();
    let letters = "ABDOPQRabdegopq04689@&%#®ÄÖéÅ";
    let bridged = font.write(letters).stencil(100).build().unwrap();
    let whole = font.draw(letters);
    let ink = union_subjects_64(&bridged.polygons().map(|polygon| path(polygon.points)).collect(), FillRule::NonZero);
    assert!(ink.iter().all(|path| area(path) > 0.0), "a counter is left");
    let lost = whole.area() - bridged.area();
    // Over forty bridges, through strokes of 100 to 300 units.
    assert!(lost > 40.0 * 100.0 * 100.0 && lost < 80.0 * 100.0 * 300.0, "{lost}");
    let error = font.write("ψ o").stencil(2000).build().unwrap_err().to_string();
    assert!(error.contains("no room") && error.contains("in 'o' of"), "{error}");
}

/// A text in one of the little fonts of `tests/fonts`, in which a unit is a micrometer at size 800.
fn little(font: &str, text: &str) -> Device {
    let path = format!("{}/tests/fonts/{font}", env!("CARGO_MANIFEST_DIR"));
    TextParams::default().text(text).font(path).size(800).build().unwrap()
}

#[test]
fn a_font_with_cubic_curves_is_drawn_with_its_holes() {
    let ring = little("cff.otf", "o");
    assert_box(&ring, [50.0, 0.0, 650.0, 600.0]);
    assert_eq!(ring.area(), 600.0 * 600.0 - 200.0 * 200.0);
    // Two quarters of radius 300, each a cubic with arms of 166 units; chords lose at most their tolerance.
    let dome = little("cff.otf", "n");
    assert_box(&dome, [50.0, 0.0, 650.0, 300.0]);
    let arm = 166.0 / 300.0;
    let curved = 2.0 * 300.0 * 300.0 * (0.5 + 0.6 * arm - 0.15 * arm * arm);
    let lost = curved - dome.area();
    assert!(lost > 0.0 && lost < 0.005 * 300.0 * PI, "{lost}");
}

#[test]
fn a_variable_font_is_drawn_at_its_default_and_a_collection_by_its_first_face() {
    for font in ["variable.ttf", "two.ttc"] {
        let two = little(font, "oo");
        assert_box(&two, [50.0, 0.0, 1350.0, 600.0]);
        assert_eq!(two.area(), 2.0 * (600.0 * 600.0 - 200.0 * 200.0), "{font}");
    }
}
