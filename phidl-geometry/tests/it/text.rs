//! Lettering in the built-in font: boxes measured on PHIDL, justification, errors.

use pg::TextParams;
use pg::text::Justify;
use phidl_core::prelude::*;
use phidl_geometry as pg;

/// A box to six digits, as measured on PHIDL.
pub(crate) fn assert_box(device: &Device, [x0, y0, x1, y1]: [f64; 4]) {
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
    assert!(error(text.clone().text("né")).contains("the character 'é' (U+00E9) is not in DEPLOF"));
    assert!(error(text.clone().text("a\tb")).contains("'\\t'"));
    assert!(error(text.clone().size(0)).ends_with("it must not be 0"));
    assert!(error(text.clone().tolerance(1e-9)).contains("tolerance is"));
    for font in ["No Such Font, Surely", "missing.ttf"] {
        let unknown = error(text.clone().font(font));
        assert!(unknown.starts_with(&format!("text: font is {font:?}, but it must be DEPLOF")), "{unknown}");
    }
}

#[test]
fn deplof_is_known_in_any_case_and_has_nothing_to_bridge() {
    let params = TextParams::default().text("B8").font("deplof").stencil(3);
    assert_eq!(params.build().unwrap().drawing_hash(), left("B8", 10.0).drawing_hash());
}
