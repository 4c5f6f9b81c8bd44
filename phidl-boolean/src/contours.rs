//! Closed contours in flat storage: one buffer of points and the index of the end of each contour.
//!
//! A `Vec<Vec<GridPoint>>` costs one allocation for each polygon; layouts have millions of four-point polygons.

use crate::{error::BooleanError, point::GridPoint};

/// Closed contours on the grid. The edge from the last point back to the first is implied.
///
/// # Examples
/// ```
/// use phidl_boolean::grid::{Contours, GridPoint};
/// let mut contours = Contours::new();
/// contours.push([(0, 0), (10, 0), (0, 10)].map(GridPoint::from));
/// assert_eq!(contours.len(), 1);
/// assert_eq!(contours.get(0).map(<[_]>::len), Some(3));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Contours {
    points: Vec<GridPoint>,
    ends: Vec<usize>,
}

impl Contours {
    /// No contours.
    pub fn new() -> Self {
        Self::default()
    }

    /// No contours, with capacity for `contours` contours of `points` points together.
    pub fn with_capacity(contours: usize, points: usize) -> Self {
        Self { points: Vec::with_capacity(points), ends: Vec::with_capacity(contours) }
    }

    /// Appends one contour.
    pub fn push(&mut self, contour: impl IntoIterator<Item = GridPoint>) {
        self.points.extend(contour);
        self.ends.push(self.points.len());
    }

    /// Appends one contour, or nothing if one of its points is an error.
    pub(crate) fn try_push<E>(&mut self, contour: impl IntoIterator<Item = Result<GridPoint, E>>) -> Result<(), E> {
        let start = self.points.len();
        let contour = contour.into_iter();
        self.points.reserve(contour.size_hint().0);
        for point in contour {
            match point {
                Ok(point) => self.points.push(point),
                Err(error) => {
                    self.points.truncate(start);
                    return Err(error);
                }
            }
        }
        self.ends.push(self.points.len());
        Ok(())
    }

    /// Appends all contours of `other`.
    pub fn append(&mut self, other: &Self) {
        self.push_part(&other.points, &other.ends);
    }

    /// Appends points and the ends of contours, counted from the first of these points. Points after the last end belong
    /// to a contour that the next part ends.
    pub(crate) fn push_part(&mut self, points: &[GridPoint], ends: &[usize]) {
        let base = self.points.len();
        self.points.extend_from_slice(points);
        self.ends.extend(ends.iter().map(|end| base + end));
    }

    /// Number of contours.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// True if there is no contour.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// Number of points of all contours together.
    pub fn point_count(&self) -> usize {
        self.points.len()
    }

    /// The points of contour `index`, or `None` if there is no such contour.
    pub fn get(&self, index: usize) -> Option<&[GridPoint]> {
        let end = *self.ends.get(index)?;
        Some(&self.points[self.start(index)..end])
    }

    /// The contours in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[GridPoint]> + Clone {
        self.ends.iter().enumerate().map(|(index, &end)| &self.points[self.start(index)..end])
    }

    /// All points, contour after contour.
    pub fn points(&self) -> &[GridPoint] {
        &self.points
    }

    /// Checks that every coordinate is within ±[`MAX_COORDINATE`](crate::grid::MAX_COORDINATE).
    ///
    /// # Errors
    /// [`BooleanError::OutOfRange`] names the first contour with a point outside.
    pub fn check_range(&self) -> Result<(), BooleanError> {
        if self.points.iter().all(|p| p.is_in_range()) {
            return Ok(());
        }
        for (shape, contour) in self.iter().enumerate() {
            if let Some(&GridPoint { x, y }) = contour.iter().find(|p| !p.is_in_range()) {
                return Err(BooleanError::OutOfRange { shape, x, y });
            }
        }
        Ok(())
    }

    fn start(&self, index: usize) -> usize {
        if index == 0 { 0 } else { self.ends[index - 1] }
    }
}

impl<C: IntoIterator<Item = GridPoint>> FromIterator<C> for Contours {
    fn from_iter<I: IntoIterator<Item = C>>(contours: I) -> Self {
        let mut all = Self::new();
        contours.into_iter().for_each(|contour| all.push(contour));
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::MAX_COORDINATE;

    #[test]
    fn appending_keeps_the_borders_between_contours() {
        let mut a: Contours = [vec![GridPoint::new(0, 0)], vec![]].into_iter().collect();
        let b: Contours = [vec![GridPoint::new(1, 1), GridPoint::new(2, 2)]].into_iter().collect();
        a.append(&b);
        let sizes: Vec<_> = a.iter().map(<[_]>::len).collect();
        assert_eq!(sizes, [1, 0, 2]);
        assert_eq!(a.get(3), None);
    }

    #[test]
    fn a_point_out_of_range_is_reported_with_its_contour() {
        let far = GridPoint::new(0, -MAX_COORDINATE - 1);
        let contours: Contours = [vec![GridPoint::new(0, MAX_COORDINATE)], vec![far]].into_iter().collect();
        assert_eq!(contours.check_range(), Err(BooleanError::OutOfRange { shape: 1, x: far.x, y: far.y }));
    }
}
