//! [`FlatCounts`]: the size of a hierarchy's flat geometry, counted without flattening it.
//!
//! Counts go through the distinct cells from the leaves up and saturate: eight levels of arrays of 60,000 × 60,000 cells
//! have more polygons than any integer holds. Whatever takes memory for flat geometry compares them with a limit first.

use std::collections::HashMap;

use super::Device;
use crate::error::{Error, Result};

/// The largest number of points (and of polygons, and of labels) that flattening accepts unless the caller sets another
/// limit: 2²⁸, which is 4 GiB of coordinates.
pub const FLAT_LIMIT: u64 = 1 << 28;

/// What is in a cell and below it. All numbers saturate.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct FlatCounts {
    pub(super) polygons: u64,
    pub(super) points: u64,
    pub(super) labels: u64,
    pub(super) ports: u64,
}

impl FlatCounts {
    /// What is in a cell itself.
    pub(super) fn own(device: &Device) -> Self {
        let cell = device.cell();
        Self {
            polygons: cell.polygons.len() as u64,
            points: cell.polygons.point_count() as u64,
            labels: cell.labels.len() as u64,
            ports: cell.ports.len() as u64,
        }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            polygons: self.polygons.saturating_add(other.polygons),
            points: self.points.saturating_add(other.points),
            labels: self.labels.saturating_add(other.labels),
            ports: self.ports.saturating_add(other.ports),
        }
    }

    pub(super) fn times(self, count: usize) -> Self {
        let count = count as u64;
        Self {
            polygons: self.polygons.saturating_mul(count),
            points: self.points.saturating_mul(count),
            labels: self.labels.saturating_mul(count),
            ports: self.ports.saturating_mul(count),
        }
    }

    /// The counts of every cell of a hierarchy, by [`Device::ptr_id`].
    pub(super) fn of_cells(device: &Device) -> HashMap<usize, Self> {
        let mut counts: HashMap<usize, Self> = HashMap::new();
        for cell in device.cells().iter().rev() {
            let below = cell.references().iter().map(|r| counts[&r.device().ptr_id()].times(r.count()));
            let all = below.fold(Self::own(cell), Self::plus);
            counts.insert(cell.ptr_id(), all);
        }
        counts
    }

    /// Refuses flat geometry beyond a limit, in the name of a cell.
    pub(super) fn check(&self, device: &str, limit: u64) -> Result<()> {
        check_count(device, "polygons", self.polygons, limit)?;
        check_count(device, "points", self.points, limit)?;
        check_count(device, "labels", self.labels, limit)
    }
}

/// Refuses a count beyond a limit. A saturated count is beyond every limit.
pub(super) fn check_count(device: &str, what: &'static str, count: u64, limit: u64) -> Result<()> {
    if count <= limit && count < u64::MAX {
        return Ok(());
    }
    let count = (count < u64::MAX).then_some(count);
    Err(Error::TooLarge { device: device.into(), what, count, limit })
}

impl Device {
    /// The numbers of polygons and of points in this cell and below it. Every count goes by distinct cells, so this is
    /// fast for any hierarchy.
    ///
    /// # Errors
    /// [`Error::TooLarge`] if a number does not fit into a `usize`.
    pub fn flat_counts(&self) -> Result<(usize, usize)> {
        let counts = FlatCounts::of_cells(self)[&self.ptr_id()];
        counts.check(self.name(), usize::MAX as u64)?;
        let narrow = |count: u64| usize::try_from(count).unwrap_or(usize::MAX);
        Ok((narrow(counts.polygons), narrow(counts.points)))
    }

    /// Refuses a hierarchy with more than `limit` flat polygons, points or labels: to be asked before memory is taken
    /// for them.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    pub fn check_flat_size(&self, limit: u64) -> Result<()> {
        FlatCounts::of_cells(self)[&self.ptr_id()].check(self.name(), limit)
    }
}
