//! The straight piece.

use phidl_core::Result;
use phidl_core::geom::Point;
use phidl_core::num::count;

use super::{Curve, CurveSegment};
use crate::{Path, rule};

/// Default number of points of a straight piece.
const NUM_PTS: usize = 100;

impl Path {
    /// A straight piece from the origin to the right, with 100 evenly spaced points: enough for a width or an offset that
    /// changes along the path. For a piece of two points see [`Path::line`].
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) unless the length (µm) is at least 0 and finite.
    pub fn straight(length: impl Into<f64>) -> Result<Self> {
        Self::straight_of(length, NUM_PTS)
    }

    /// A straight piece of two points, for paths with corners.
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let mut path = Path::line(10)?;
    /// path.turn(90).append(Path::line(5)?);
    /// assert_eq!(path.points().len(), 3);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Path::straight`].
    pub fn line(length: impl Into<f64>) -> Result<Self> {
        Self::straight_of(length, 2)
    }

    /// A straight piece from the origin to the right, with `num_pts` evenly spaced points.
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) unless the length (µm) is at least 0 and finite, and `num_pts` from
    /// 2 to [`count::MOST`].
    pub fn straight_of(length: impl Into<f64>, num_pts: usize) -> Result<Self> {
        let length = length.into();
        rule::length("straight", "length", length)?;
        if !(2..=count::MOST).contains(&num_pts) {
            return Err(rule::refused("straight", "num_pts", num_pts, format!("be from 2 to {}", count::MOST)));
        }
        let points = count::linspace(0.0, length, num_pts).map(|x| Point::new(x, 0.0)).collect();
        Ok(Self::from_curve(points, vec![CurveSegment::new(Curve::Line, num_pts - 1)], 0.0, 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_piece_has_its_ends_and_even_steps() {
        let path = Path::straight_of(9, 4).unwrap();
        assert_eq!(path.points(), [0.0, 3.0, 6.0, 9.0].map(|x| Point::new(x, 0.0)));
        assert_eq!(Path::straight(15).unwrap().points().len(), 100);
    }

    #[test]
    fn invalid_lengths_and_counts_are_refused() {
        assert!(Path::straight(-1).is_err());
        assert!(Path::straight(f64::NAN).is_err());
        let error = Path::straight_of(1, 1).unwrap_err();
        assert_eq!(error.to_string(), "straight: num_pts is 1, but it must be from 2 to 16777216");
    }
}
