//! [`Key`] and [`CongruenceClass`]: clusters that are equal up to a shift by whole grid steps.

use phidl_core::hash::Digest;
use phidl_core::num;
use phidl_core::num::grid::Grid;

use super::{
    placement::{Bounds, Placement},
    rounding::Rounding,
};
use crate::point::GridPoint;

/// Fractions of a step in which keys compare positions; [`Rounding`] distinguishes different rounding within a fraction.
const PARTS: f64 = 1024.0;

/// Equal for clusters that may be shifts of each other.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct Key {
    parts: Vec<Part>,
    lattice: Option<Pitch>,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Part {
    side: usize,
    cell: Digest,
    x_reflection: bool,
    magnification: u64,
    rotation: u64,
    /// From the anchor, in fractions of a step.
    position: [i64; 2],
}

/// Columns, rows and whole steps between the elements of arrays of the same pitch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Pitch {
    pub(super) count: [u32; 2],
    pub(super) steps: [GridPoint; 2],
}

/// A cluster at its position.
#[derive(Debug)]
pub(super) struct Placed {
    /// The grid point that its offsets refer to.
    pub(super) anchor: GridPoint,
    pub(super) pitch: Option<Pitch>,
    /// From the anchor to each placement (steps).
    offsets: Vec<[f64; 2]>,
    /// The distance of the last element of an array from a whole number of steps (steps).
    error: f64,
    sides: [i8; 2],
    reach: f64,
}

impl Placed {
    /// `None` if placements are arrays that cannot be referenced as one.
    pub(super) fn new(placements: &[&Placement], grid: &Grid, distance: f64) -> Option<Self> {
        let first = placements.first()?;
        let anchor = nearest(first.position(grid))?;
        let from = real(anchor);
        let offsets = placements
            .iter()
            .map(|placement| placement.position(grid))
            .map(|p| [p[0] - from[0], p[1] - from[1]])
            .collect();
        let (pitch, error) = match placements.iter().any(|placement| placement.lattice().is_some()) {
            true => common_pitch(placements, grid, distance)?,
            false => (None, 0.0),
        };
        let bounds = placements.iter().map(|placement| placement.bounds).reduce(Bounds::around)?;
        Some(Self { anchor, pitch, offsets, error, sides: bounds.sides(), reach: bounds.reach() })
    }

    #[expect(clippy::cast_possible_truncation, reason = "parts of steps within 2^40")]
    pub(super) fn key(&self, placements: &[&Placement]) -> Key {
        let part = |(placement, offset): (&&Placement, &[f64; 2])| Part {
            side: placement.side,
            cell: placement.cell.drawing_hash(),
            x_reflection: placement.transform.x_reflection,
            magnification: placement.transform.magnification.to_bits(),
            rotation: placement.transform.rotation.to_bits(),
            position: offset.map(|v| (v * PARTS).round() as i64),
        };
        Key { parts: placements.iter().zip(&self.offsets).map(part).collect(), lattice: self.pitch }
    }

    pub(super) fn count(&self) -> usize {
        self.pitch.map_or(1, |pitch| pitch.count[0] as usize * pitch.count[1] as usize)
    }
}

/// A known cluster and how its corners round.
#[derive(Debug)]
pub(super) struct CongruenceClass {
    /// Without arrays: their first elements.
    pub(super) placements: Vec<Placement>,
    pub(super) anchor: GridPoint,
    placed: Placed,
    rounding: Rounding,
}

impl CongruenceClass {
    pub(super) fn new(placements: &[&Placement], placed: Placed, grid: &Grid) -> Self {
        let placements: Vec<Placement> = placements.iter().filter_map(|placement| placement.first(grid)).collect();
        let rounding = Rounding::of(&placements, grid);
        Self { placements, anchor: placed.anchor, placed, rounding }
    }

    /// Whether its own elements are shifts of each other; for a single cluster, whether it can have shifts.
    pub(super) fn contains_itself(&self) -> bool {
        self.contains(&self.placed)
    }

    /// Whether a cluster of the same key has the same result, shifted by whole steps.
    pub(super) fn contains(&self, other: &Placed) -> bool {
        let off = |(p, q): (&[f64; 2], &[f64; 2])| (p[0] - q[0]).abs().max((p[1] - q[1]).abs());
        let error = self.placed.offsets.iter().zip(&other.offsets).map(off).fold(other.error, f64::max);
        self.rounding.allows(error, self.placed.reach.max(other.reach), [self.placed.sides, other.sides])
    }
}

/// The pitch of arrays of the same pitch, if it is whole up to the last element and elements of different index do not
/// interact; with the distance of the last element from a whole number of steps.
fn common_pitch(placements: &[&Placement], grid: &Grid, distance: f64) -> Option<(Option<Pitch>, f64)> {
    let mut found: Option<(Pitch, f64)> = None;
    let mut element: Option<Bounds> = None;
    for placement in placements {
        let (count, steps) = placement.lattice()?;
        let pitch = Pitch { count, steps: [nearest(steps[0])?, nearest(steps[1])?] };
        let off = |axis: usize| {
            let whole = real(pitch.steps[axis]);
            (steps[axis][0] - whole[0]).abs().max((steps[axis][1] - whole[1]).abs()) * f64::from(count[axis])
        };
        let error = off(0) + off(1);
        match &mut found {
            None => found = Some((pitch, error)),
            Some((common, most)) if *common == pitch => *most = most.max(error),
            Some(_) => return None,
        }
        let first = placement.first(grid)?.bounds;
        element = Some(element.map_or(first, |all| all.around(first)));
    }
    let (pitch, error) = found?;
    elements_are_separate(element?.grown(distance), pitch).then_some((Some(pitch), error))
}

/// Whether the elements of an axis-parallel array do not touch.
fn elements_are_separate(element: Bounds, pitch: Pitch) -> bool {
    let size = [element.high[0] - element.low[0], element.high[1] - element.low[1]];
    let along = |step: GridPoint| match (step.x, step.y) {
        (0, _) => Some(1),
        (_, 0) => Some(0),
        _ => None,
    };
    let clear = |direction: usize, axis: usize| real(pitch.steps[direction])[axis].abs() > size[axis];
    match (pitch.count, along(pitch.steps[0]), along(pitch.steps[1])) {
        ([1, _], _, Some(axis)) => clear(1, axis),
        ([_, 1], Some(axis), _) => clear(0, axis),
        (_, Some(columns), Some(rows)) => columns != rows && clear(0, columns) && clear(1, rows),
        _ => false,
    }
}

#[expect(clippy::cast_precision_loss, reason = "steps within 2^40")]
fn real(p: GridPoint) -> [f64; 2] {
    [p.x as f64, p.y as f64]
}

/// The grid point nearest to a position in steps; `None` if that is beyond the range.
#[expect(clippy::cast_possible_truncation, reason = "the range is checked")]
fn nearest(position: [f64; 2]) -> Option<GridPoint> {
    let whole = position.map(|v| num::grid::whole(v) as i64);
    let p = GridPoint::new(whole[0], whole[1]);
    (position.iter().all(|v| v.is_finite()) && p.is_in_range()).then_some(p)
}
