//! [`Outline`]: the spellings that are taken for the points of a polygon.

use super::{Point, Rect};

/// What is taken for the points of an outline, in order: pairs, or two coordinate lists.
///
/// ```
/// # use phidl_core::geom::Outline;
/// let pairs = [(8, 6), (6, 8), (7, 9), (9, 5)].into_points();
/// let rows = ([8, 6, 7, 9], [6, 8, 9, 5]).into_points();
/// assert_eq!(pairs, rows);
/// ```
///
/// Rows of different lengths keep what is missing as NaN, so that whoever takes the outline refuses it.
pub trait Outline: Sized {
    /// Appends the points to a buffer. (Cells hold all their outlines in one; nothing is allocated on the way there.)
    fn append_to(self, buffer: &mut Vec<Point>);

    /// The points on their own.
    fn into_points(self) -> Vec<Point> {
        let mut points = Vec::new();
        self.append_to(&mut points);
        points
    }
}

impl<P: Into<Point>> Outline for Vec<P> {
    /// A list of points becomes the buffer if that has no room yet: the first outline of a cell is not copied.
    fn append_to(self, buffer: &mut Vec<Point>) {
        let points = self.into_iter().map(Into::into);
        if buffer.capacity() == 0 {
            *buffer = points.collect(); // which keeps the memory of the list
        } else {
            buffer.extend(points);
        }
    }
}

impl<P: Into<Point>, const N: usize> Outline for [P; N] {
    fn append_to(self, buffer: &mut Vec<Point>) {
        buffer.extend(self.map(Into::into));
    }
}

impl<P: Into<Point> + Clone> Outline for &[P] {
    fn append_to(self, buffer: &mut Vec<Point>) {
        buffer.extend(self.iter().cloned().map(Into::into));
    }
}

impl<P: Into<Point> + Clone, const N: usize> Outline for &[P; N] {
    fn append_to(self, buffer: &mut Vec<Point>) {
        self.as_slice().append_to(buffer);
    }
}

impl<P: Into<Point> + Clone> Outline for &Vec<P> {
    fn append_to(self, buffer: &mut Vec<Point>) {
        self.as_slice().append_to(buffer);
    }
}

impl Outline for Rect {
    fn append_to(self, buffer: &mut Vec<Point>) {
        buffer.extend(self.corners());
    }
}

impl<X: Into<f64>, Y: Into<f64>, const N: usize, const M: usize> Outline for ([X; N], [Y; M]) {
    fn append_to(self, buffer: &mut Vec<Point>) {
        append_rows(self.0.map(Into::into), self.1.map(Into::into), buffer);
    }
}

impl<X: Into<f64>, Y: Into<f64>> Outline for (Vec<X>, Vec<Y>) {
    fn append_to(self, buffer: &mut Vec<Point>) {
        append_rows(self.0.into_iter().map(Into::into), self.1.into_iter().map(Into::into), buffer);
    }
}

impl Outline for (&[f64], &[f64]) {
    fn append_to(self, buffer: &mut Vec<Point>) {
        append_rows(self.0.iter().copied(), self.1.iter().copied(), buffer);
    }
}

fn append_rows(xs: impl IntoIterator<Item = f64>, ys: impl IntoIterator<Item = f64>, buffer: &mut Vec<Point>) {
    let (mut xs, mut ys) = (xs.into_iter(), ys.into_iter());
    loop {
        match (xs.next(), ys.next()) {
            (None, None) => return,
            (x, y) => buffer.push(Point::new(x.unwrap_or(f64::NAN), y.unwrap_or(f64::NAN))),
        }
    }
}

/// Area inside an outline (µm²), positive if it runs counter-clockwise.
#[must_use]
pub fn signed_area(outline: &[Point]) -> f64 {
    let Some(&first) = outline.first() else { return 0.0 };
    // Measured from the first point: far from the origin the products would eat up the digits.
    let twice: f64 = outline.windows(2).map(|edge| (edge[0] - first).cross(edge[1] - first)).sum();
    twice / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_different_lengths_cannot_pass_for_points() {
        let outline = ([1, 2, 3], [1, 2]).into_points();
        assert!(!outline[2].is_finite());
    }

    #[test]
    fn area_is_signed_and_survives_a_far_place() {
        let square = [(0, 0), (1, 0), (1, 1), (0, 1)].map(Point::from);
        assert_eq!(signed_area(&square), 1.0);
        let far: Vec<Point> = square.iter().rev().map(|p| *p + Point::new(1e6, 1e6)).collect();
        assert_eq!(signed_area(&far), -1.0);
        assert_eq!(signed_area(&[]), 0.0);
    }
}
