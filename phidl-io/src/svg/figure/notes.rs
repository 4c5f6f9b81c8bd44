//! What is written into a figure: ports, labels, and the bar that tells the scale.

use std::fmt::Write;

use phidl_core::geom::Point;
use phidl_core::port::Port;
use phidl_core::scene::Device;

use super::scale::ScaleBar;
use super::view::{PER_PIXEL, Step, View, step};
use crate::svg::number::escaped;

/// Height of letters, in steps, and about how wide one is.
const LETTER: i64 = 12 * PER_PIXEL;
const LETTER_WIDTH: i64 = 7 * PER_PIXEL;
/// From the middle of letters down to the line they stand on.
const TO_BASELINE: i64 = 4 * PER_PIXEL;
/// Length of a port's arrow; length and half width of its head.
const ARROW: f64 = 16.0 * PER_PIXEL as f64;
const HEAD: f64 = 7.0 * PER_PIXEL as f64;
const HEAD_HALF: f64 = 3.0 * PER_PIXEL as f64;
/// Between an arrow and its name, and between the device and the scale.
const GAP: i64 = 3 * PER_PIXEL;
const SCALE_GAP: i64 = 16 * PER_PIXEL;
/// Half the height of the ends of the scale's bar.
const TICK: i64 = 3 * PER_PIXEL;
/// The scale's bar is at most this part of the device's width, or of this many steps where that is more.
const BAR_PART: f64 = 0.3;
const BAR_LEAST: f64 = 40.0 * PER_PIXEL as f64;

/// A box in a figure, in steps.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    min: Step,
    max: Step,
}

impl Reach {
    fn take_in(&mut self, (x, y): Step) {
        self.min = (self.min.0.min(x), self.min.1.min(y));
        self.max = (self.max.0.max(x), self.max.1.max(y));
    }

    /// Left, top, right and bottom, further out by a margin, and each a whole pixel.
    pub(super) fn grown(&self, margin: i64) -> (i64, i64, i64, i64) {
        let down = |v: i64| (v - margin).div_euclid(PER_PIXEL) * PER_PIXEL;
        let up = |v: i64| -down(-v);
        (down(self.min.0), down(self.min.1), up(self.max.0), up(self.max.1))
    }
}

/// The notes of a figure, and how far they reach.
pub(super) struct Notes<'a> {
    view: &'a View,
    pub(super) reach: Reach,
    pub(super) text: String,
}

impl<'a> Notes<'a> {
    /// None yet; what is drawn lies within the view.
    pub(super) fn new(view: &'a View) -> Self {
        Self { view, reach: Reach { min: (0, 0), max: view.end }, text: String::new() }
    }

    /// The labels of the whole hierarchy that are placed once, in the middle of where they are.
    pub(super) fn labels(&mut self, device: &Device) {
        for label in device.labels() {
            let at = self.view.step(label.position());
            self.line(format_args!("<g font-family=\"sans-serif\" font-size=\"{LETTER}\" fill=\"currentColor\">"));
            self.word(at, &label.text);
            self.line(format_args!("</g>"));
        }
    }

    /// An arrow out of every port, across its opening a line, and its name at the tip.
    pub(super) fn ports(&mut self, device: &Device) {
        if device.ports().len() == 0 {
            return;
        }
        self.line(format_args!(
            "<g font-family=\"sans-serif\" font-size=\"{LETTER}\" fill=\"currentColor\" stroke-width=\"15\">"
        ));
        for port in device.ports() {
            self.port(port);
        }
        self.line(format_args!("</g>"));
    }

    fn port(&mut self, port: &Port) {
        let (left, right) = port.endpoints();
        let (left, right) = (self.view.step(left), self.view.step(right));
        let foot = self.view.step(port.midpoint());
        let out = Point::new(port.normal().x, -port.normal().y);
        let across = Point::new(-out.y, out.x);
        let from_foot = |p: Point| (foot.0 + step(p.x), foot.1 + step(p.y));
        let neck = from_foot(out * (ARROW - HEAD));
        let [tip, a, b] =
            [out * ARROW, out * (ARROW - HEAD) + across * HEAD_HALF, out * (ARROW - HEAD) - across * HEAD_HALF]
                .map(from_foot);
        let opening = format!("M{} {}L{} {}", left.0, left.1, right.0, right.1);
        let shaft = format!("M{} {}L{} {}", foot.0, foot.1, neck.0, neck.1);
        self.line(format_args!("<path stroke=\"currentColor\" d=\"{opening}{shaft}\"/>"));
        self.line(format_args!("<path d=\"M{} {}L{} {} {} {}z\"/>", tip.0, tip.1, a.0, a.1, b.0, b.1));
        for p in [left, right, tip] {
            self.reach.take_in(p);
        }
        // The name's box touches the tip, on whatever side that is.
        let half = Point::new((width(port.name()) / 2 + GAP) as f64, (LETTER / 2 + GAP) as f64);
        let beyond = Point::new(out.x * half.x, out.y * half.y);
        self.word((tip.0 + step(beyond.x), tip.1 + step(beyond.y)), port.name());
    }

    /// A word with its middle at a place.
    fn word(&mut self, (x, y): Step, word: &str) {
        let half = width(word) / 2;
        self.reach.take_in((x - half, y - LETTER / 2));
        self.reach.take_in((x + half, y + LETTER / 2));
        let word = escaped(word);
        self.line(format_args!("<text x=\"{x}\" y=\"{}\" text-anchor=\"middle\">{word}</text>", y + TO_BASELINE));
    }

    /// The bar below everything, with its length at its right.
    pub(super) fn scale_bar(&mut self) {
        let room = (BAR_PART * self.view.end.0 as f64).max(BAR_LEAST);
        let Some(ScaleBar { um, label }) = ScaleBar::within(room / self.view.scale) else { return };
        let (length, y) = (step(um * self.view.scale), self.reach.max.1 + SCALE_GAP);
        let (top, bottom) = (y - TICK, y + TICK);
        let x = length + 2 * GAP;
        self.line(format_args!(
            "<path fill=\"none\" stroke=\"currentColor\" stroke-width=\"12\" d=\"M0 {top}V{bottom}M0 {y}H{length}M{length} {top}V{bottom}\"/>"
        ));
        self.line(format_args!(
            "<text font-family=\"sans-serif\" font-size=\"{LETTER}\" fill=\"currentColor\" x=\"{x}\" y=\"{}\">{label}</text>",
            y + TO_BASELINE
        ));
        self.reach.take_in((x + width(&label), y + LETTER / 2));
    }

    fn line(&mut self, line: std::fmt::Arguments<'_>) {
        // Writing into a String cannot fail.
        let _ = writeln!(self.text, "{line}");
    }
}

/// About how wide a word is, in steps.
fn width(word: &str) -> i64 {
    i64::try_from(word.chars().count()).unwrap_or(i64::MAX / LETTER_WIDTH) * LETTER_WIDTH
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reach_ends_at_whole_pixels() {
        let reach = Reach { min: (-3, 0), max: (101, 99) };
        assert_eq!(reach.grown(4), (-10, -10, 110, 110));
    }
}
