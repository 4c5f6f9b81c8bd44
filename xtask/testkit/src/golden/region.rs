//! Areas by a second engine.
//!
//! Booleans here are done by a port of Clipper, on a grid of 1e-6 µm: the engine under test would pass anything.

use clipper2_rust::{
    EndType, FillRule, JoinType, Path64, Paths64, Point64, area_paths, inflate_paths_64, union_subjects_64, xor_64,
};
use phidl_core::prelude::*;

/// Steps of the comparing grid in a micrometer.
const STEPS: f64 = 1e6;

/// Area (µm²) that some outlines cover together.
#[must_use]
pub fn merged_area(outlines: &[Vec<Point>]) -> f64 {
    let origin = first_point(outlines);
    to_um2(&union_subjects_64(&to_paths(outlines, origin), FillRule::NonZero))
}

/// Area (µm²) that only one of two sets of outlines covers.
#[must_use]
pub fn xor_area(a: &[Vec<Point>], b: &[Vec<Point>]) -> f64 {
    let origin = first_point(a);
    to_um2(&xor_64(&to_paths(a, origin), &to_paths(b, origin), FillRule::NonZero))
}

/// Where the engine counts from: far away, its areas lose their last digits.
fn first_point(outlines: &[Vec<Point>]) -> Point {
    outlines.iter().flatten().next().copied().unwrap_or(Point::ORIGIN)
}

/// Whether two results of a set operation on a grid of `step` µm agree as well as two correct engines do, which round
/// crossings their own way: they differ by no more than half a step along the outlines, and nowhere by four steps across.
///
/// # Errors
/// How much they differ.
pub fn agree_on_grid(ours: &[Vec<Point>], expected: &[Vec<Point>], step: f64) -> Result<(), String> {
    let length = |outline: &Vec<Point>| -> f64 {
        (0..outline.len()).map(|i| outline[i].distance(outline[(i + 1) % outline.len()])).sum()
    };
    let origin = first_point(expected);
    let difference = xor_64(&to_paths(ours, origin), &to_paths(expected, origin), FillRule::NonZero);
    let (area, allowed) = (to_um2(&difference), 0.5 * step * expected.iter().map(length).sum::<f64>());
    if area > allowed {
        return Err(format!("regions differ by {area} µm², more than {allowed} µm²"));
    }
    let core = inflate_paths_64(&difference, -2.0 * step * STEPS, JoinType::Miter, EndType::Polygon, 2.0, 0.0);
    let core = to_um2(&core);
    if core > 0.0 { Err(format!("regions differ by more than slivers: by {core} µm² without them")) } else { Ok(()) }
}

/// Every outline turned counter-clockwise, so that overlaps of differently directed ones do not cancel.
fn to_paths(outlines: &[Vec<Point>], origin: Point) -> Paths64 {
    let path = |outline: &Vec<Point>| -> Path64 {
        let points: Path64 = outline.iter().map(|p| *p - origin).map(|p| Point64::new(step(p.x), step(p.y))).collect();
        let backwards = phidl_core::geom::signed_area(outline) < 0.0;
        if backwards { points.into_iter().rev().collect() } else { points }
    };
    outlines.iter().map(path).collect()
}

fn step(um: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "reference results lie within meters of the origin")]
    let step = (um * STEPS).round() as i64;
    step
}

fn to_um2(paths: &Paths64) -> f64 {
    area_paths(paths) / (STEPS * STEPS)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64) -> Vec<Point> {
        Rect::new((x, 0.0), (x + 2.0, 2.0)).corners().to_vec()
    }

    #[test]
    fn overlaps_count_once_in_any_direction() {
        let mut backwards = square(1.0);
        backwards.reverse();
        assert!((merged_area(&[square(0.0), backwards]) - 6.0).abs() < 1e-9);
    }

    #[test]
    fn slivers_of_a_step_agree_and_wider_ones_do_not() {
        let grown = |by: f64| vec![Rect::new((0.0, 0.0), (2.0, 2.0 + by)).corners().to_vec()];
        assert_eq!(agree_on_grid(&grown(1e-4), &[square(0.0)], 1e-4), Ok(()));
        assert!(agree_on_grid(&grown(3e-4), &[square(0.0)], 1e-4).is_err());
        let speck = Rect::new((5.0, 5.0), (5.0005, 5.0005)).corners().to_vec();
        assert!(agree_on_grid(&[square(0.0), speck], &[square(0.0)], 1e-4).unwrap_err().contains("slivers"));
    }

    #[test]
    fn only_what_differs_counts() {
        assert!((xor_area(&[square(0.0)], &[square(0.5)]) - 2.0).abs() < 1e-9);
        assert_eq!(xor_area(&[square(0.0)], &[square(0.0)]), 0.0);
    }
}
