//! Lettering: boxes of the specification, justification, fonts from files.

use std::path::PathBuf;

use clipper2_rust::{FillRule, Path64, Point64, area, union_subjects_64};
use pg::TextParams;
use pg::text::Justify;
use phidl_core::prelude::*;
use phidl_geometry as pg;

/// A box to six digits, which is what the specification gives.
fn assert_box(device: &Device, [x0, y0, x1, y1]: [f64; 4]) {
    let ink = device.bbox().expect("something is drawn");
    let near = ink.min.distance(Point::new(x0, y0)) < 1e-6 && ink.max.distance(Point::new(x1, y1)) < 1e-6;
    assert!(near, "{ink:?}, expected ({x0}, {y0})–({x1}, {y1})");
}

fn left(text: &str, size: f64) -> Device {
    pg::text(text, size, Justify::Left, 0, "DEPLOF").unwrap()
}

#[test]
fn boxes_and_polygon_counts_are_those_of_the_specification() {
    let all: String = ('!'..='~').chain(['µ']).collect();
    let pangram = "the quick brown\n fox jumped over\nthe lazy dog";
    let hello = "Hello world!\nMultiline text\nLeft-justified";
    for (device, expected, polygons) in [
        (left("abcd", 10.0), [1.0, 0.0, 32.0, 10.0], 4),
        (left("A", 10.0), [0.99, 0.0, 8.0, 10.0], 1),
        (left("  A", 10.0), [10.99, 0.0, 18.0, 10.0], 1),
        (left("A B", 10.0), [0.99, 0.0, 21.0, 10.0], 2),
        (left("a\n\nb", 10.0), [1.0, -30.0, 8.0, 7.75], 2),
        (left("chip99", 100.0), [10.0, -30.0, 430.0, 110.0], 7),
        (left("0123456789", 1000.0), [100.0, 0.0, 7800.0, 1000.0], 11),
        (left(hello, 10.0), [1.0, -32.0, 94.0, 11.0], 44),
        (left(&all, 77.0), [7.7, -23.1, 5459.3, 92.4], 112),
        (left("a", -10.0), [-8.0, -7.75, -1.0, 0.0], 1),
        (pg::text("A  ", 10, Justify::Right, 0, "DEPLOF").unwrap(), [-7.01, 0.0, 0.0, 10.0], 1),
        (pg::text(pangram, 800, Justify::Center, 0, "DEPLOF").unwrap(), [-4400.0, -2640.0, 4400.0, 880.0], 38),
    ] {
        assert_box(&device, expected);
        assert_eq!(device.polygons().len(), polygons);
        assert_eq!(device.name(), "text");
    }
}

#[test]
fn every_line_is_justified_by_its_own_ink() {
    for (justify, expected) in [
        (Justify::Left, [(1.0, 16.0), (1.0, 57.0), (6.0, 13.0)]),
        (Justify::Right, [(-15.0, 0.0), (-56.0, 0.0), (-7.0, 0.0)]),
        (Justify::Center, [(-7.5, 7.5), (-28.0, 28.0), (-3.5, 3.5)]),
    ] {
        let text = pg::text("ab\nWide line\n\n x ", 10, justify, 0, "DEPLOF").unwrap();
        assert_eq!(text.polygons().len(), 13);
        for (line, (x0, x1)) in [0.0, 1.0, 3.0].into_iter().zip(expected) {
            let baseline = -15.0 * line;
            let in_line = |p: &Point| p.y > baseline - 3.5 && p.y < baseline + 11.0;
            let ink = Rect::around(text.polygons().flat_map(|p| p.points.to_vec()).filter(in_line)).unwrap();
            assert!(
                (ink.min.x - x0).abs() < 1e-9 && (ink.max.x - x1).abs() < 1e-9,
                "{justify:?}, line {line}: {ink:?}"
            );
        }
    }
}

#[test]
fn text_without_ink_is_empty_and_several_layers_repeat_it() {
    for nothing in ["", "   ", "\n\r\n"] {
        assert!(left(nothing, 10.0).is_empty());
    }
    assert!(pg::text("abcd", 10, Justify::Left, Layers::NONE, "DEPLOF").unwrap().is_empty());
    assert_eq!(pg::text("abcd", 10, Justify::Left, [1, 2], "DEPLOF").unwrap().polygons().len(), 8);
    assert_eq!(left("a\r\nb", 10.0).drawing_hash(), left("a\nb", 10.0).drawing_hash());
}

#[test]
fn what_cannot_be_written_is_refused_by_name() {
    let error = |params: TextParams| params.build().unwrap_err().to_string();
    let text = TextParams::default();
    assert!(error(text.clone().text("né")).contains("text is with 'é' (U+00E9)"));
    assert!(error(text.clone().text("a\tb")).contains("'\\t'"));
    assert!(error(text.clone().size(0)).ends_with("it must not be 0"));
    assert!(error(text.clone().tolerance(1e-9)).contains("tolerance is"));
    let unknown = error(text.clone().font("No Such Font, Surely"));
    assert!(unknown.contains("\"No Such Font, Surely\"") && unknown.contains("font file"), "{unknown}");
    let missing = error(text.font("missing.ttf"));
    assert!(missing.contains("there is none at it"), "{missing}");
}

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
    // Its lines are 1901 + 483 units apart.
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

#[test]
fn deplof_is_known_in_any_case_and_has_nothing_to_bridge() {
    let params = TextParams::default().text("B8").font("deplof").stencil(3);
    assert_eq!(params.build().unwrap().drawing_hash(), left("B8", 10.0).drawing_hash());
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
