//! The outlines of a device as one path for each layer, with no more points than can be seen.

use std::fmt::Write;

use phidl_core::geom::{Point, signed_area, simplified};
use phidl_core::layer::LayerSet;
use phidl_core::scene::{Device, FlatPolygon};

use super::view::{Step, View};
use crate::svg::looks::looks;

/// How far an outline may be from where it was, in steps: less than a tenth of a pixel. (Not a round number: a distance
/// between whole points that is just this large would be decided by the last bit of a root.)
const TOLERANCE: f64 = 0.7777;

/// One path for each layer: those of the set in its order, the first one lowest, then the others, ascending.
pub(super) fn draw(device: &Device, view: &View, layers: &LayerSet) -> String {
    let mut text = String::new();
    let mut present = device.layers();
    present.sort_by_key(|layer| layers.iter().position(|named| named.layer == *layer).unwrap_or(usize::MAX));
    for layer in present {
        let data = Data::of(device.flat_polygons().on(layer), view);
        let (color, alpha) = looks(layer, layers);
        let opacity = if alpha < 1.0 { format!(" fill-opacity=\"{alpha}\"") } else { String::new() };
        if !data.text.is_empty() {
            // Writing into a String cannot fail.
            let _ = writeln!(text, "<path fill=\"{color}\"{opacity} d=\"{}\"/>", data.text);
        }
    }
    text
}

/// The outlines of some devices as a dashed line in the color of the text.
pub(super) fn dashed(devices: &[Device], view: &View) -> String {
    let data = Data::of(devices.iter().flat_map(Device::flat_polygons), view).text;
    if data.is_empty() {
        return data;
    }
    format!(
        "<path fill=\"none\" stroke=\"currentColor\" stroke-width=\"10\" stroke-dasharray=\"40 30\" d=\"{data}\"/>\n"
    )
}

/// The points of a closed outline that are needed.
fn visible(mut outline: Vec<Step>) -> Vec<Step> {
    outline.dedup();
    let Some(&first) = outline.first() else { return outline };
    // Cut in two, since an open line is what can be simplified: at the first point, and at the one farthest from it.
    let away = |p: &Step| (p.0 - first.0).pow(2) + (p.1 - first.1).pow(2);
    let middle = outline.iter().enumerate().max_by_key(|(_, p)| away(p)).map_or(0, |(i, _)| i);
    outline.push(first);
    let points: Vec<Point> = outline.iter().map(|(x, y)| Point::new(*x as f64, *y as f64)).collect();
    let there = simplified(&points[..=middle], TOLERANCE);
    let back = simplified(&points[middle..], TOLERANCE);
    #[expect(clippy::cast_possible_truncation, reason = "whole numbers that were steps")]
    let mut kept: Vec<Step> = there.iter().chain(&back).map(|p| (p.x as i64, p.y as i64)).collect();
    kept.dedup();
    kept.pop();
    kept
}

/// The data of a path, in relative steps as short as they can be written.
#[derive(Default)]
struct Data {
    text: String,
    start: Step,
}

impl Data {
    fn of<'a>(polygons: impl Iterator<Item = FlatPolygon<'a>>, view: &View) -> Self {
        let mut data = Self::default();
        for polygon in polygons {
            let mut points: Vec<Point> = polygon.points().collect();
            // All the same way round, so that overlaps stay filled and keyholes open.
            if signed_area(&points) < 0.0 {
                points.reverse();
            }
            data.outline(&visible(points.iter().map(|p| view.step(*p)).collect()));
        }
        data
    }

    /// Appends a closed outline; one that has come down to a line is left out.
    fn outline(&mut self, points: &[Step]) {
        if points.len() < 3 {
            return;
        }
        let first = points[0];
        let (command, dx, dy) = match self.text.is_empty() {
            true => ('M', first.0, first.1),
            false => ('m', first.0 - self.start.0, first.1 - self.start.1),
        };
        self.text.push(command);
        self.pair(dx, dy);
        let mut last = first;
        let mut command = ' ';
        for p in &points[1..] {
            let (dx, dy) = (p.0 - last.0, p.1 - last.1);
            let next = match (dx, dy) {
                (_, 0) => 'h',
                (0, _) => 'v',
                _ => 'l',
            };
            match next {
                'l' if command == 'l' => self.pair_after(dx, dy),
                _ => {
                    self.text.push(next);
                    match next {
                        'h' => self.number(dx),
                        'v' => self.number(dy),
                        _ => self.pair(dx, dy),
                    }
                }
            }
            command = next;
            last = *p;
        }
        self.text.push('z');
        self.start = first;
    }

    fn number(&mut self, v: i64) {
        // Writing into a String cannot fail.
        let _ = write!(self.text, "{v}");
    }

    /// Two numbers; a sign parts them as well as a blank.
    fn pair(&mut self, dx: i64, dy: i64) {
        self.number(dx);
        self.blank_before(dy);
        self.number(dy);
    }

    /// Two more numbers after numbers.
    fn pair_after(&mut self, dx: i64, dy: i64) {
        self.blank_before(dx);
        self.pair(dx, dy);
    }

    fn blank_before(&mut self, v: i64) {
        if v >= 0 {
            self.text.push(' ');
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_that_nobody_sees_go() {
        let square = vec![(0, 0), (0, 0), (50, 0), (100, 0), (100, 100), (50, 100), (0, 100)];
        assert_eq!(visible(square), [(0, 0), (100, 0), (100, 100), (0, 100)]);
        let thin = vec![(0, 0), (100, 0), (100, 0), (0, 0)];
        assert!(visible(thin).len() < 3);
        assert!(visible(vec![]).is_empty() && visible(vec![(3, 3)]).len() < 3);
    }

    #[test]
    fn a_circle_of_a_thousand_points_stays_round() {
        let circle = (0..1000).map(|i| Point::polar(500.0, 0.36 * f64::from(i)));
        #[expect(clippy::cast_possible_truncation, reason = "small numbers")]
        let steps: Vec<Step> = circle.map(|p| (p.x.round() as i64, p.y.round() as i64)).collect();
        let kept = visible(steps.clone());
        assert!(kept.len() < 100, "{}", kept.len());
        let line: Vec<Point> = kept.iter().chain(&kept[..1]).map(|p| Point::new(p.0 as f64, p.1 as f64)).collect();
        for (x, y) in steps {
            let p = Point::new(x as f64, y as f64);
            let off = |e: &[Point]| {
                let along = e[1] - e[0];
                p.distance(e[0] + along * ((p - e[0]).dot(along) / along.dot(along)).clamp(0.0, 1.0))
            };
            assert!(line.windows(2).map(off).fold(f64::MAX, f64::min) <= TOLERANCE);
        }
    }

    #[test]
    fn numbers_are_parted_by_what_is_there() {
        let mut data = Data::default();
        data.outline(&[(1, 2), (4, 1), (5, 5), (5, 9)]);
        data.outline(&[(1, 2), (0, 0), (7, 0)]);
        data.outline(&[(1, 2), (0, 0)]);
        assert_eq!(data.text, "M1 2l3-1 1 4v4zm0 0l-1-2h7z");
    }
}
