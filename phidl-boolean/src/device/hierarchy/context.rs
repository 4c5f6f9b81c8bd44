//! [`Key`] and [`Context`]: placements seen together, wherever on the grid they stand.

use phidl_core::hash::Digest;
use phidl_core::num;
use phidl_core::num::grid::Grid;

use super::{
    item::{Bounds, Item},
    rounding::Rounding,
};
use crate::point::GridPoint;

/// Parts of a step in which keys compare places; what rounds differently within a part is told apart by [`Rounding`].
const PARTS: f64 = 1024.0;

/// The same for placements that may be each other's shifts.
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
    /// From the anchor, in parts of a step.
    place: [i64; 2],
}

/// Columns, rows and whole steps between the elements of arrays that run side by side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Pitch {
    pub(super) count: [u32; 2],
    pub(super) steps: [GridPoint; 2],
}

/// A cluster where it stands.
#[derive(Debug)]
pub(super) struct Placed {
    /// The grid point that its places are counted from.
    pub(super) anchor: GridPoint,
    pub(super) pitch: Option<Pitch>,
    /// From the anchor to each item (steps).
    offsets: Vec<[f64; 2]>,
    /// How far the last element of an array is off a whole number of steps (steps).
    error: f64,
    sides: [i8; 2],
    reach: f64,
}

impl Placed {
    /// `None` if items are arrays that cannot be placed as one.
    pub(super) fn new(items: &[&Item], grid: &Grid, margin: f64) -> Option<Self> {
        let first = items.first()?;
        let anchor = nearest(first.place(grid))?;
        let from = real(anchor);
        let offsets = items.iter().map(|item| item.place(grid)).map(|p| [p[0] - from[0], p[1] - from[1]]).collect();
        let (pitch, error) = match items.iter().any(|item| item.lattice().is_some()) {
            true => common_pitch(items, grid, margin)?,
            false => (None, 0.0),
        };
        let bounds = items.iter().map(|item| item.bounds).reduce(Bounds::around)?;
        Some(Self { anchor, pitch, offsets, error, sides: bounds.sides(), reach: bounds.reach() })
    }

    #[expect(clippy::cast_possible_truncation, reason = "parts of steps within 2^40")]
    pub(super) fn key(&self, items: &[&Item]) -> Key {
        let part = |(item, offset): (&&Item, &[f64; 2])| Part {
            side: item.side,
            cell: item.cell.drawing_hash(),
            x_reflection: item.transform.x_reflection,
            magnification: item.transform.magnification.to_bits(),
            rotation: item.transform.rotation.to_bits(),
            place: offset.map(|v| (v * PARTS).round() as i64),
        };
        Key { parts: items.iter().zip(&self.offsets).map(part).collect(), lattice: self.pitch }
    }

    pub(super) fn count(&self) -> usize {
        self.pitch.map_or(1, |pitch| pitch.count[0] as usize * pitch.count[1] as usize)
    }
}

/// Placements that have been seen and the way they round.
#[derive(Debug)]
pub(super) struct Context {
    /// Without arrays: their first elements.
    pub(super) items: Vec<Item>,
    pub(super) anchor: GridPoint,
    placed: Placed,
    rounding: Rounding,
}

impl Context {
    pub(super) fn new(items: &[&Item], placed: Placed, grid: &Grid) -> Self {
        let items: Vec<Item> = items.iter().filter_map(|item| item.first(grid)).collect();
        let rounding = Rounding::of(&items, grid);
        Self { items, anchor: placed.anchor, placed, rounding }
    }

    /// Whether its own elements are shifts of each other; of a single cluster, that it can have any.
    pub(super) fn holds_itself(&self) -> bool {
        self.holds(&self.placed)
    }

    /// Whether a cluster of the same key draws the same, shifted by whole steps.
    pub(super) fn holds(&self, other: &Placed) -> bool {
        let off = |(p, q): (&[f64; 2], &[f64; 2])| (p[0] - q[0]).abs().max((p[1] - q[1]).abs());
        let error = self.placed.offsets.iter().zip(&other.offsets).map(off).fold(other.error, f64::max);
        self.rounding.allows(error, self.placed.reach.max(other.reach), [self.placed.sides, other.sides])
    }
}

/// The pitch of arrays of the same pitch, if whole steps hold for the last element too and elements of different index
/// are not near each other; with how far the last element is off (steps).
fn common_pitch(items: &[&Item], grid: &Grid, margin: f64) -> Option<(Option<Pitch>, f64)> {
    let mut found: Option<(Pitch, f64)> = None;
    let mut element: Option<Bounds> = None;
    for item in items {
        let (count, steps) = item.lattice()?;
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
        let first = item.first(grid)?.bounds;
        element = Some(element.map_or(first, |all| all.around(first)));
    }
    let (pitch, error) = found?;
    elements_are_apart(element?.grown(margin), pitch).then_some((Some(pitch), error))
}

/// Whether the elements of an upright array do not touch.
fn elements_are_apart(element: Bounds, pitch: Pitch) -> bool {
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

/// The grid point nearest to a place in steps; `None` if that is beyond the range.
#[expect(clippy::cast_possible_truncation, reason = "the range is checked")]
fn nearest(place: [f64; 2]) -> Option<GridPoint> {
    let whole = place.map(|v| num::grid::whole(v) as i64);
    let p = GridPoint::new(whole[0], whole[1]);
    (place.iter().all(|v| v.is_finite()) && p.is_in_range()).then_some(p)
}
