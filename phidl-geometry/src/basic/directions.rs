//! Unit vectors at equal angles: the base of circles, ellipses and rings.

use phidl_core::num::angle::directions;
use phidl_core::prelude::*;

/// The directions of the corners of a regular polygon, counter-clockwise from the x axis; the last repeats the first.
///
/// If the number of chords is a multiple of four, the first quarter is computed and turned exactly: such a circle is
/// symmetric to the last bit and takes a quarter of the time.
pub(super) fn around(chords: usize) -> Vec<Point> {
    let computed = if chords.is_multiple_of(4) { chords / 4 } else { chords };
    let mut directions = directions((0..computed).map(|i| 360.0 * i as f64 / chords as f64));
    directions.reserve_exact(chords + 1 - computed);
    while directions.len() < chords {
        let quarter = directions.len() - computed..directions.len();
        directions.extend_from_within(quarter.clone());
        directions[quarter.end..].iter_mut().for_each(|p| *p = Point::new(0.0 - p.y, p.x));
    }
    directions.push(Point::new(1.0, 0.0));
    directions
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_direction_is_at_its_angle_whether_it_is_computed_or_turned() {
        for chords in [1, 3, 4, 7, 8, 12, 144, 150] {
            let directions = around(chords);
            assert_eq!(directions.len(), chords + 1);
            for (i, p) in directions.into_iter().enumerate() {
                let angle = TAU * i as f64 / chords as f64;
                assert!(p.distance(Point::new(angle.cos(), angle.sin())) < 1e-14, "{i} of {chords}: {p}");
            }
        }
    }

    #[test]
    fn circles_of_whole_quarters_lie_exactly_on_the_axes() {
        let directions = around(8);
        assert_eq!((directions[2], directions[4], directions[6]), ((0, 1).into(), (-1, 0).into(), (0, -1).into()));
    }
}
