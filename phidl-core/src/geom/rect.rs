//! [`Rect`]: an axis-parallel box.

use super::{Point, Size};

/// An axis-parallel box from `min` to `max`, in micrometers. An empty element has none: functions pass `Option<Rect>`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rect {
    /// Lower left corner.
    pub min: Point,
    /// Upper right corner.
    pub max: Point,
}

impl Rect {
    /// The box of two opposite corners, in any order.
    #[must_use]
    pub fn new(a: impl Into<Point>, b: impl Into<Point>) -> Self {
        let (a, b) = (a.into(), b.into());
        Self { min: Point::new(a.x.min(b.x), a.y.min(b.y)), max: Point::new(a.x.max(b.x), a.y.max(b.y)) }
    }

    /// The tight box around some points, or `None` if there are none.
    #[must_use]
    pub fn around(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = points.next()?;
        let mut rect = Self { min: first, max: first };
        for p in points {
            // Comparisons instead of `min` and `max`: they compile to vector code, and NaN was refused before.
            rect.min.x = if p.x < rect.min.x { p.x } else { rect.min.x };
            rect.min.y = if p.y < rect.min.y { p.y } else { rect.min.y };
            rect.max.x = if p.x > rect.max.x { p.x } else { rect.max.x };
            rect.max.y = if p.y > rect.max.y { p.y } else { rect.max.y };
        }
        Some(rect)
    }

    /// The box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: Point::new(self.min.x.min(other.min.x), self.min.y.min(other.min.y)),
            max: Point::new(self.max.x.max(other.max.x), self.max.y.max(other.max.y)),
        }
    }

    /// The box around all boxes that are not `None`.
    #[must_use]
    pub fn union_all(rects: impl IntoIterator<Item = Option<Self>>) -> Option<Self> {
        rects.into_iter().flatten().reduce(Self::union)
    }

    /// The center.
    #[must_use]
    pub fn center(&self) -> Point {
        (self.min + self.max) / 2.0
    }

    /// Width and height (µm).
    #[must_use]
    pub fn size(&self) -> Size {
        Size::new(self.max.x - self.min.x, self.max.y - self.min.y)
    }

    /// Area (µm²).
    #[must_use]
    pub fn area(&self) -> f64 {
        self.size().width * self.size().height
    }

    /// The corners: lower left, upper left, upper right, lower right.
    #[must_use]
    pub fn corners(&self) -> [Point; 4] {
        let (min, max) = (self.min, self.max);
        [min, Point::new(min.x, max.y), max, Point::new(max.x, min.y)]
    }

    /// Whether a point lies inside or on the edge.
    #[must_use]
    pub fn contains(&self, point: impl Into<Point>) -> bool {
        let p = point.into();
        self.min.x <= p.x && p.x <= self.max.x && self.min.y <= p.y && p.y <= self.max.y
    }

    /// Whether the two boxes share at least a point.
    #[must_use]
    pub fn touches(&self, other: &Self) -> bool {
        self.min.x <= other.max.x && other.min.x <= self.max.x && self.min.y <= other.max.y && other.min.y <= self.max.y
    }

    /// The box moved by a vector.
    #[must_use]
    pub fn shifted(self, by: Point) -> Self {
        Self { min: self.min + by, max: self.max + by }
    }

    /// The box with every edge moved outwards by `margin` (µm); inwards if it is negative.
    #[must_use]
    pub fn grown(self, margin: f64) -> Self {
        let m = Point::new(margin, margin);
        Self { min: self.min - m, max: self.max + m }
    }
}

impl std::fmt::Display for Rect {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} to {}", self.min, self.max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_points_have_no_box() {
        assert_eq!(Rect::around([]), None);
        assert_eq!(Rect::union_all([None, None]), None);
    }

    #[test]
    fn corners_span_the_same_box_in_any_order() {
        let rect = Rect::new((4, -1), (0, 3));
        assert_eq!((rect.min, rect.max), (Point::new(0.0, -1.0), Point::new(4.0, 3.0)));
        assert_eq!(Rect::around(rect.corners()), Some(rect));
        assert_eq!((rect.area(), rect.center()), (16.0, Point::new(2.0, 1.0)));
    }
}
