//! Paths that overlap themselves: found, and united from their segments.

use phidl_boolean::grid::{Contours, GridPoint};
use phidl_boolean::{Region, RunOptions};

use super::wire::{Step, Wire};

/// Outlines of up to this many corners are tested edge by edge.
const FEW_CORNERS: usize = 64;

/// The most pairs of pieces that are united: a path of 65 kB can cross itself 30 million times.
const MOST_PAIRS: usize = 1 << 20;

/// Whether an outline does not cross or touch itself.
pub(super) fn is_simple(outline: &[Step], wire: &Wire) -> bool {
    // A path that turns by less than a half turn in all goes forward everywhere.
    if wire.total_turn() < 179.0 {
        return true;
    }
    if outline.len() <= FEW_CORNERS {
        return !touches_itself(outline);
    }
    let Some(region) = merged(std::slice::from_ref(&outline.to_vec())) else { return false };
    let area2 = phidl_boolean::grid::signed_area2(&grid_points(outline));
    let mut polygons = region.polygons();
    polygons.len() == 1 && polygons.all(|polygon| polygon.holes().len() == 0) && region.area2() == area2.abs()
}

/// The outlines of a wire that overlaps itself. If that is too often, its pieces, which cover the same.
pub(super) fn united(wire: &Wire) -> Vec<Vec<Step>> {
    let pieces = wire.pieces();
    let region = merged(&pieces);
    region.map_or(pieces, |region| {
        region.without_holes().iter().map(|outline| outline.iter().map(|p| [p.x, p.y]).collect()).collect()
    })
}

/// The union of some outlines; `None` if their overlaps are too many for the union to fit in memory.
fn merged(outlines: &[Vec<Step>]) -> Option<Region> {
    if overlapping_pairs(outlines) > MOST_PAIRS {
        return None;
    }
    let contours: Contours = outlines.iter().map(|outline| grid_points(outline)).collect();
    Region::merged(&contours, &RunOptions::default()).ok()
}

fn grid_points(outline: &[Step]) -> Vec<GridPoint> {
    outline.iter().map(|[x, y]| GridPoint::new(*x, *y)).collect()
}

/// How many pairs of outlines overlap in x, counted up to the limit.
fn overlapping_pairs(outlines: &[Vec<Step>]) -> usize {
    let range = |outline: &Vec<Step>| {
        outline.iter().fold((i64::MAX, i64::MIN), |(left, right), [x, _]| (left.min(*x), right.max(*x)))
    };
    let mut ranges: Vec<(i64, i64)> = outlines.iter().map(range).collect();
    ranges.sort_unstable();
    let mut pairs = 0;
    for (index, (_, right)) in ranges.iter().enumerate() {
        pairs += ranges[index + 1..].partition_point(|(left, _)| left <= right);
        if pairs > MOST_PAIRS {
            break;
        }
    }
    pairs
}

/// Whether two edges of an outline that are not neighbors meet, or neighbors run back onto each other.
fn touches_itself(outline: &[Step]) -> bool {
    let count = outline.len();
    let edge = |index: usize| (outline[index], outline[(index + 1) % count]);
    (0..count).any(|i| {
        (i + 1..count).any(|j| {
            let neighbors = j == i + 1 || (i == 0 && j == count - 1);
            !neighbors && meet(edge(i), edge(j))
        })
    })
}

fn meet((a, b): (Step, Step), (c, d): (Step, Step)) -> bool {
    let disjoint =
        |axis: usize| a[axis].max(b[axis]) < c[axis].min(d[axis]) || c[axis].max(d[axis]) < a[axis].min(b[axis]);
    if disjoint(0) || disjoint(1) {
        return false;
    }
    let side = |p: Step, q: Step, r: Step| {
        let wide = |v: i64| i128::from(v);
        ((wide(q[0]) - wide(p[0])) * (wide(r[1]) - wide(p[1])) - (wide(q[1]) - wide(p[1])) * (wide(r[0]) - wide(p[0])))
            .signum()
    };
    side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0
}
