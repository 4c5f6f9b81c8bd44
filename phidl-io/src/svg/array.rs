//! Arrays by doubling: two of a thing, two of those, and so on.

use std::fmt::Write;

use phidl_core::geom::{Point, Transform};

use super::number::placement;

/// Something that can be placed, by the name of its definition, with a placement of its own before the array's.
#[derive(Debug, Clone)]
pub(super) struct Thing {
    pub(super) id: String,
    pub(super) transform: Transform,
}

/// `count` of a thing, one `step` (µm) after the other, as the content of a group.
///
/// Definitions of 2, 4, 8 … of it are appended to `defs` under names that begin with `name`.
pub(super) fn row(thing: &Thing, step: Point, count: u32, name: &str, defs: &mut String) -> String {
    let mut content = String::new();
    let mut doubled = thing.clone();
    let mut placed = 0;
    for bit in 0..u32::BITS - count.leading_zeros() {
        if bit > 0 {
            let half = step * f64::from(1_u32 << (bit - 1));
            let id = format!("{name}x{}", 1_u64 << bit);
            // Writing into a String cannot fail.
            let _ = writeln!(defs, "<g id=\"{id}\">{}{}</g>", place(&doubled, Point::ORIGIN), place(&doubled, half));
            doubled = Thing { id, transform: Transform::IDENTITY };
        }
        if count >> bit & 1 == 1 {
            content.push_str(&place(&doubled, step * f64::from(placed)));
            placed += 1 << bit;
        }
    }
    content
}

/// A thing, shifted.
pub(super) fn place(thing: &Thing, by: Point) -> String {
    let moved = Transform { origin: thing.transform.origin + by, ..thing.transform };
    format!("<use href=\"#{}\"{}/>", thing.id, placement(&moved))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eleven_are_one_and_two_and_eight() {
        let mut defs = String::new();
        let thing = Thing { id: "a".into(), transform: Transform::IDENTITY };
        let content = row(&thing, Point::new(10.0, 0.0), 11, "r", &mut defs);
        assert_eq!(
            content,
            "<use href=\"#a\"/><use href=\"#rx2\" transform=\"translate(10 0)\"/>\
             <use href=\"#rx8\" transform=\"translate(30 0)\"/>"
        );
        let expected = "<g id=\"rx2\"><use href=\"#a\"/><use href=\"#a\" transform=\"translate(10 0)\"/></g>\n\
                        <g id=\"rx4\"><use href=\"#rx2\"/><use href=\"#rx2\" transform=\"translate(20 0)\"/></g>\n\
                        <g id=\"rx8\"><use href=\"#rx4\"/><use href=\"#rx4\" transform=\"translate(40 0)\"/></g>\n";
        assert_eq!(defs, expected);
    }

    #[test]
    fn a_thing_keeps_its_own_placement_and_shifts_only_once() {
        let mut defs = String::new();
        let thing = Thing { id: "a".into(), transform: Transform::scaling(2.0) };
        let content = row(&thing, Point::new(0.0, 5.0), 2, "r", &mut defs);
        assert_eq!(content, "<use href=\"#rx2\"/>");
        assert!(defs.contains("<use href=\"#a\" transform=\"translate(0 5) scale(2)\"/>"), "{defs}");
    }
}
