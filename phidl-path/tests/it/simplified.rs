//! Whether fewer points are a result of Ramer, Douglas and Peucker, whichever of several farthest points was taken.
//!
//! On an arc, two neighboring points are often equally far from a chord but for the last bit, and the last bit of a sine
//! differs from machine to machine. So the reference's points cannot be expected; that they are a right answer can.

use phidl_core::prelude::*;

/// Distances closer together than this (µm) are equal.
const TIE: f64 = 1e-9;

/// Checks `few`, an outline of two edges, against the outline with all points, whose edges are equally long.
pub(crate) fn check(all: &[Point], few: &[Point], tolerance: f64) -> Result<(), String> {
    let kept = places(all, few)?;
    let half = all.len() / 2;
    let (right, left): (Vec<usize>, Vec<usize>) = kept.into_iter().partition(|place| *place < half);
    for edge in [&right, &left] {
        if !is_result(all, edge, tolerance) {
            return Err(format!("points {edge:?} are no result of the algorithm"));
        }
    }
    Ok(())
}

/// Where the few points are among all.
fn places(all: &[Point], few: &[Point]) -> Result<Vec<usize>, String> {
    let mut from = 0;
    let mut place = |p: &Point| {
        let found = all[from..].iter().position(|q| q.distance(*p) < 1e-6);
        let found = found.ok_or_else(|| format!("{p} is no point of the edge"))?;
        from += found;
        Ok(from)
    };
    few.iter().map(&mut place).collect()
}

/// Whether the algorithm may keep these points of the stretch from the first to the last of them.
fn is_result(all: &[Point], kept: &[usize], tolerance: f64) -> bool {
    let (first, last) = (kept[0], kept[kept.len() - 1]);
    let line = all[last] - all[first];
    let distance = |i: usize| line.cross(all[first] - all[i]).abs() / line.norm();
    let most = (first + 1..last).map(distance).fold(0.0, f64::max);
    if kept.len() == 2 {
        return most <= tolerance + TIE;
    }
    let mut splits = (1..kept.len() - 1).filter(|i| distance(kept[*i]) >= most - TIE);
    most > tolerance - TIE
        && splits.any(|i| is_result(all, &kept[..=i], tolerance) && is_result(all, &kept[i..], tolerance))
}
