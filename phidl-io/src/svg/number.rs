//! Numbers, placements and texts, as short as they can be.

use std::fmt::Write;

use phidl_core::geom::{Point, Transform};

/// Decimals of a coordinate: a picometer.
const DECIMALS: usize = 6;

/// Appends a length (µm), without zeros at its end.
pub(super) fn push_length(text: &mut String, um: f64) {
    let start = text.len();
    // Writing into a String cannot fail.
    let _ = write!(text, "{um:.DECIMALS$}");
    let end = text.trim_end_matches('0').trim_end_matches('.').len();
    text.truncate(end);
    if text[start..] == *"-0" {
        text.replace_range(start.., "0");
    }
}

pub(super) fn length(um: f64) -> String {
    let mut text = String::new();
    push_length(&mut text, um);
    text
}

/// Appends both coordinates.
pub(super) fn push_point(text: &mut String, point: Point) {
    push_length(text, point.x);
    text.push(' ');
    push_length(text, point.y);
}

/// ` transform="…"`, or nothing where nothing is transformed.
pub(super) fn placement(transform: &Transform) -> String {
    let Transform { x_reflection, magnification, rotation, origin } = *transform;
    let mut parts: Vec<String> = Vec::new();
    if origin != Point::ORIGIN {
        parts.push(format!("translate({} {})", length(origin.x), length(origin.y)));
    }
    if rotation != 0.0 {
        parts.push(format!("rotate({rotation})"));
    }
    match x_reflection {
        true => parts.push(format!("scale({magnification} -{magnification})")),
        false if magnification != 1.0 => parts.push(format!("scale({magnification})")),
        false => {}
    }
    if parts.is_empty() { String::new() } else { format!(" transform=\"{}\"", parts.join(" ")) }
}

/// A text between tags or quotes. What XML cannot hold at all becomes a replacement character.
pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\t' | '\n' => escaped.push(c),
            '\0'..' ' | '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            _ => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_no_zeros_to_spare() {
        let cases =
            [(0.0, "0"), (-0.0, "0"), (-1e-9, "0"), (100.0, "100"), (0.1 + 0.2, "0.3"), (-12.3456789, "-12.345679")];
        for (um, expected) in cases {
            assert_eq!(length(um), expected);
        }
    }

    #[test]
    fn placements_name_only_what_they_do() {
        let t = Transform { x_reflection: true, magnification: 2.0, rotation: 30.0, origin: Point::new(1.5, 0.0) };
        assert_eq!(placement(&t), r#" transform="translate(1.5 0) rotate(30) scale(2 -2)""#);
        assert_eq!(placement(&Transform::IDENTITY), "");
    }

    #[test]
    fn texts_cannot_break_out() {
        assert_eq!(escaped("<a & \"b\">\u{1}"), "&lt;a &amp; &quot;b&quot;&gt;\u{fffd}");
    }
}
