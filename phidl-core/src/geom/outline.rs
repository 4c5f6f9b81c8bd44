//! [`Outline`]: the types that are accepted as the points of a polygon.

use super::{Point, Rect};

/// A type that is accepted as the points of an outline, in order: pairs, or two coordinate lists.
///
/// ```
/// # use phidl_core::geom::Outline;
/// let pairs = [(8, 6), (6, 8), (7, 9), (9, 5)].into_points();
/// let rows = ([8, 6, 7, 9], [6, 8, 9, 5]).into_points();
/// assert_eq!(pairs, rows);
/// ```
///
/// Rows of different lengths are filled up with NaN, which every cell refuses.
pub trait Outline: Sized {
    /// Appends the points to a buffer. A cell holds all its outlines in one, so nothing else is allocated.
    fn append_to(self, buffer: &mut Vec<Point>);

    /// The points on their own.
    fn into_points(self) -> Vec<Point> {
        let mut points = Vec::new();
        self.append_to(&mut points);
        points
    }
}

impl<P: Into<Point>> Outline for Vec<P> {
    /// The list itself becomes an empty buffer, so the first outline of a cell is not copied.
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
    // Relative to the first point: far from the origin the products would lose digits.
    let twice: f64 = outline.windows(2).map(|edge| (edge[0] - first).cross(edge[1] - first)).sum();
    twice / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_of_different_lengths_are_not_finite() {
        let outline = ([1, 2, 3], [1, 2]).into_points();
        assert!(!outline[2].is_finite());
    }

    #[test]
    fn area_is_signed_and_exact_far_from_the_origin() {
        let square = [(0, 0), (1, 0), (1, 1), (0, 1)].map(Point::from);
        assert_eq!(signed_area(&square), 1.0);
        let far: Vec<Point> = square.iter().rev().map(|p| *p + Point::new(1e6, 1e6)).collect();
        assert_eq!(signed_area(&far), -1.0);
        assert_eq!(signed_area(&[]), 0.0);
    }
}
