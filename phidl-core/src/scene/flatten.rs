//! Expanding a hierarchy into one cell.

use std::collections::HashSet;
use std::sync::Arc;

use super::flat_counts::{FLAT_LIMIT, FlatCounts};
use super::polygon_store::PolygonStore;
use super::{Device, Label};
use crate::error::Result;
use crate::place::Transformable;

impl Device {
    /// The same drawing in one cell without references: polygons and labels of the whole hierarchy, the ports and info of
    /// this cell. With the feature `parallel`, large hierarchies are expanded on all cores, with the same result.
    ///
    /// Aliases are removed with the references that they name.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge) beyond [`FLAT_LIMIT`], before memory is taken.
    pub fn flattened(&self) -> Result<Self> {
        self.flattened_within(FLAT_LIMIT)
    }

    /// As [`Device::flattened`], with another limit on polygons, points and labels.
    ///
    /// # Errors
    /// [`Error::TooLarge`](crate::Error::TooLarge) beyond the limit.
    pub fn flattened_within(&self, limit: u64) -> Result<Self> {
        let mut cell = self.edit();
        cell.flatten_within(limit)?;
        Ok(cell.cell.finish())
    }
}

/// The flat geometry of a hierarchy, in the order of [`Device::flat_polygons`] and [`Device::instances`].
pub(super) struct Flat {
    pub(super) polygons: PolygonStore,
    pub(super) labels: Vec<Label>,
}

impl Flat {
    /// Flattens a hierarchy, if it is within a limit. Errors name `cell`.
    pub(super) fn of(device: &Device, cell: &str, limit: u64) -> Result<Self> {
        let counts = FlatCounts::of_cells(device);
        let total = counts[&device.ptr_id()];
        total.check(cell, limit)?;
        #[cfg(feature = "parallel")]
        if super::parallel::is_worth_it(total) {
            let polygons = with_properties(super::parallel::all_polygons(device, &counts), device);
            return Ok(Self { polygons, labels: all_labels(device, &counts) });
        }
        let polygons = with_properties(all_polygons(device, total), device);
        Ok(Self { polygons, labels: all_labels(device, &counts) })
    }
}

/// All polygons, without their properties.
fn all_polygons(device: &Device, total: FlatCounts) -> PolygonStore {
    let narrow = |count: u64| usize::try_from(count).unwrap_or(usize::MAX);
    let mut flat = PolygonStore::default();
    flat.reserve(narrow(total.polygons), narrow(total.points));
    for instance in device.instances().drawn() {
        let matrix = instance.transform.matrix();
        for polygon in instance.device.polygons() {
            flat.push_mapped(polygon.points, polygon.layer, |p| matrix.apply(p));
        }
    }
    flat
}

/// All labels. Only cells with labels below are visited.
fn all_labels(device: &Device, counts: &std::collections::HashMap<usize, FlatCounts>) -> Vec<Label> {
    let labeled: HashSet<usize> = counts.iter().filter(|(_, count)| count.labels > 0).map(|(id, _)| *id).collect();
    let placed = device.instances().only(Arc::new(labeled)).flat_map(|instance| {
        instance.device.labels().iter().map(move |label| {
            let mut label = label.clone();
            label.transform_mut(&instance.transform);
            label
        })
    });
    placed.collect()
}

/// Properties are rare. They are added afterwards, and only if some cell has any.
fn with_properties(mut flat: PolygonStore, device: &Device) -> PolygonStore {
    let any = device.cells().iter().any(|cell| cell.polygons().any(|p| p.property_map().is_some()));
    if any {
        let polygons = device.instances().drawn().flat_map(|instance| instance.device.polygons());
        for (index, polygon) in polygons.enumerate() {
            if let Some(properties) = polygon.property_map() {
                flat.set_properties(index, properties.clone());
            }
        }
    }
    flat
}
