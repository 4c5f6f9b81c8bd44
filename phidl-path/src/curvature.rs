//! Curvature along a path, from its points.

use std::f64::consts::{PI, TAU};

use phidl_core::geom::Point;
use phidl_core::{Error, Result};

use crate::Path;
use crate::normals::REPEATED;

impl Path {
    /// Curvature along the path: the length (µm) up to the end of each segment, and the curvature there (1/µm, positive
    /// to the left), by finite differences of second order over the directions of the segments.
    ///
    /// A curvature needs many points: at the end of a straight piece of two points there is a corner, which has none.
    /// Repeated points count once.
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let (s, curvature) = Path::arc(10, 90)?.curvature()?;
    /// assert!(s.len() == 179 && curvature.iter().all(|k| (k - 0.1).abs() < 1e-6));
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Custom`] if the path has fewer than four distinct points; and the deferred error.
    pub fn curvature(&self) -> Result<(Vec<f64>, Vec<f64>)> {
        self.check()?;
        let mut points = self.points().to_vec();
        points.dedup_by(|next, before| next.distance(*before) <= REPEATED);
        if points.len() < 4 {
            let message = format!("the path needs at least 4 distinct points, but has {}", points.len());
            return Err(Error::custom("curvature", message));
        }
        let (s, headings) = directions(&points);
        let curvature = gradient(&s, &headings);
        Ok((s, curvature))
    }
}

/// The length up to the end of each segment, and its direction (radians) without jumps by a full turn.
fn directions(points: &[Point]) -> (Vec<f64>, Vec<f64>) {
    let (mut length, mut heading, mut before) = (0.0, 0.0, 0.0);
    let segments = points.windows(2).enumerate().map(|(i, segment)| {
        let along = segment[1] - segment[0];
        let raw = along.y.atan2(along.x);
        let turn: f64 = raw - before;
        let turn = if turn > PI && i > 0 {
            turn - TAU
        } else if turn < -PI && i > 0 {
            turn + TAU
        } else {
            turn
        };
        (length, heading, before) = (length + along.norm(), heading + turn, raw);
        (length, heading)
    });
    segments.unzip()
}

/// The derivative dy/dx at every x: that of the parabola through a point and its two neighbors.
fn gradient(x: &[f64], y: &[f64]) -> Vec<f64> {
    let last = x.len() - 1;
    let inner = |i: usize| {
        let (h1, h2) = (x[i] - x[i - 1], x[i + 1] - x[i]);
        (h1 * h1 * y[i + 1] + (h2 * h2 - h1 * h1) * y[i] - h2 * h2 * y[i - 1]) / (h1 * h2 * (h1 + h2))
    };
    // At an end, with the neighbors `b` and `c` on the same side.
    let end = |a: usize, b: usize, c: usize| {
        let (h1, h2) = (x[b] - x[a], x[c] - x[b]);
        -(2.0 * h1 + h2) / (h1 * (h1 + h2)) * y[a] + (h1 + h2) / (h1 * h2) * y[b] - h1 / (h2 * (h1 + h2)) * y[c]
    };
    let value = |i: usize| match i {
        0 => end(0, 1, 2),
        i if i == last => end(last, last - 1, last - 2),
        i => inner(i),
    };
    (0..x.len()).map(value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_has_the_curvature_of_the_reference() {
        let (s, curvature) = Path::arc(10, 90).unwrap().curvature().unwrap();
        assert_eq!(s.len(), 179);
        assert!(curvature.iter().all(|k| (k - 0.100_000_320_9).abs() < 1e-9));
    }

    #[test]
    fn the_curvature_of_a_clothoid_rises_with_its_length() {
        let path = Path::euler(3, 90).unwrap();
        let (s, curvature) = path.curvature().unwrap();
        let half = path.length() / 2.0;
        for (s, k) in s.iter().zip(&curvature).filter(|(s, _)| **s < 0.9 * half) {
            // The direction of a segment is that of its middle, half a step before its end.
            let middle = s - path.length() / 358.0 / 2.0;
            assert!((k - middle / half / 3.0).abs() < 1e-4, "{k} at {s}");
        }
    }

    #[test]
    fn directions_pass_through_the_half_turn_without_a_jump() {
        let (_, curvature) = Path::arc(10, -400).unwrap().curvature().unwrap();
        assert!(curvature.iter().all(|k| (k + 0.1).abs() < 1e-5));
    }

    #[test]
    fn derivatives_of_parabolas_are_exact_on_uneven_steps() {
        let x = [0.0, 1.0, 1.5, 4.0, 5.0];
        let y = x.map(|x| 3.0 * x * x - 2.0 * x);
        for (x, dy) in x.iter().zip(gradient(&x, &y)) {
            assert!((dy - (6.0 * x - 2.0)).abs() < 1e-12);
        }
    }

    #[test]
    fn repeated_points_count_once_and_too_few_are_refused() {
        let path = Path::from_points([(0, 0), (1, 0), (1, 0), (2, 0), (3, 0)]).unwrap();
        assert_eq!(path.curvature().unwrap().1, [0.0; 3]);
        assert!(Path::from_points([(0, 0), (1, 0), (2, 0)]).unwrap().curvature().is_err());
    }
}
