//! Curves to corners.

use harfrust::GlyphId;
use harfrust::font::Font;
use harfrust::font::glyph::outline::{DrawMemory, DrawOptions, PathSink};
use phidl_core::geom::{Point, signed_area};
use phidl_core::num::count;

/// The contours of a glyph as corners, in font units.
pub(super) struct Flattened {
    contours: Vec<Vec<Point>>,
    tolerance: f64,
}

impl Flattened {
    /// The contours of a glyph that enclose something; none if its outline cannot be read. Chords stay within the
    /// tolerance (font units) of their curve.
    pub(super) fn glyph(font: &Font, glyph: u32, tolerance: f64) -> Option<Vec<Vec<Point>>> {
        let mut flattened = Self { contours: Vec::new(), tolerance };
        // A glyph without an outline, such as a space.
        let Some(outline) = font.outline_glyphs().get(GlyphId::new(glyph)) else {
            return Some(Vec::new());
        };
        outline.draw(&DrawOptions::new(), DrawMemory::Scratch, &mut flattened).ok()?;
        Some(flattened.contours.into_iter().map(without_repeats).filter(|c| signed_area(c) != 0.0).collect())
    }

    fn last(&self) -> Point {
        self.contours.last().and_then(|contour| contour.last()).copied().unwrap_or_default()
    }

    fn push(&mut self, point: Point) {
        if let Some(contour) = self.contours.last_mut() {
            contour.push(point);
        }
    }

    /// Cuts a curve into equal steps of its parameter. Where the second derivative is at most `bend`, a chord over a step
    /// `h` leaves the curve by at most `bend · h² / 8`.
    fn curve(&mut self, bend: f64, at: impl Fn(f64) -> Point) {
        let steps = count::up((bend / (8.0 * self.tolerance)).sqrt()).max(1);
        for step in 1..=steps {
            self.push(at(step as f64 / steps as f64));
        }
    }
}

/// The contour without points that repeat the one before, the first one at the end included.
fn without_repeats(mut contour: Vec<Point>) -> Vec<Point> {
    contour.dedup();
    while contour.len() > 1 && contour.first() == contour.last() {
        contour.pop();
    }
    contour
}

fn point(x: f32, y: f32) -> Point {
    Point::new(x.into(), y.into())
}

impl PathSink for Flattened {
    fn move_to(&mut self, x: f32, y: f32) {
        self.contours.push(vec![point(x, y)]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.push(point(x, y));
    }

    fn quad_to(&mut self, cx0: f32, cy0: f32, x: f32, y: f32) {
        let (a, b, c) = (self.last(), point(cx0, cy0), point(x, y));
        let bend = 2.0 * (a - 2.0 * b + c).norm();
        self.curve(bend, |t| (1.0 - t) * (1.0 - t) * a + 2.0 * t * (1.0 - t) * b + t * t * c);
    }

    fn curve_to(&mut self, cx0: f32, cy0: f32, cx1: f32, cy1: f32, x: f32, y: f32) {
        let (a, b, c, d) = (self.last(), point(cx0, cy0), point(cx1, cy1), point(x, y));
        // The second derivative runs straight from one of these to the other.
        let bend = 6.0 * (a - 2.0 * b + c).norm().max((b - 2.0 * c + d).norm());
        self.curve(bend, |t| {
            let s = 1.0 - t;
            s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d
        });
    }

    fn close(&mut self) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of one curve from the origin, cut to a tolerance.
    fn cut(tolerance: f64, draw: impl Fn(&mut Flattened)) -> Vec<Point> {
        let mut flattened = Flattened { contours: vec![vec![Point::ORIGIN]], tolerance };
        draw(&mut flattened);
        flattened.contours.remove(0)
    }

    #[test]
    fn chords_of_a_parabola_keep_the_tolerance_and_no_step_is_wasted() {
        // y = x² / 400 over 200 units, as a quadratic curve; a chord of length h leaves it by h² / 1600.
        let tolerance = 0.1;
        let points = cut(tolerance, |f| f.quad_to(100.0, 0.0, 200.0, 100.0));
        let off = |p: &[Point]| (p[1].x - p[0].x).powi(2) / 1600.0;
        assert!(points.iter().all(|p| (p.y - p.x * p.x / 400.0).abs() < 1e-9));
        assert!(points.windows(2).all(|pair| off(pair) <= tolerance));
        let coarser = 200.0 / (points.len() - 2) as f64;
        assert!(coarser * coarser / 1600.0 > tolerance);
    }

    #[test]
    fn a_cubic_quarter_circle_stays_near_the_circle() {
        // The usual approximation of a quarter of the unit circle is itself off by 2.7e-4 of the radius.
        const K: f32 = 552.285;
        let points = cut(0.5, |f| f.curve_to(0.0, K, 1000.0 - K, 1000.0, 1000.0, 1000.0));
        let center = Point::new(1000.0, 0.0);
        let middles = points.windows(2).map(|pair| (pair[0] + pair[1]) / 2.0);
        assert!(middles.chain(points.iter().copied()).all(|p| (p.distance(center) - 1000.0).abs() < 0.5 + 0.28));
    }

    #[test]
    fn repeated_points_are_dropped() {
        let square = [(0, 0), (0, 0), (1, 0), (1, 1), (1, 1), (0, 0)].map(Point::from);
        assert_eq!(without_repeats(square.to_vec()).len(), 3);
    }
}
