//! Expanding a hierarchy into one cell.

use std::collections::HashMap;

use super::outlines::Outlines;
use super::{Device, Label};
use crate::geom::Transform;
use crate::place::Transformable;

/// How much is drawn in a cell and below it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Amount {
    pub(super) polygons: usize,
    pub(super) points: usize,
}

impl Device {
    /// The same drawing in one cell without references: polygons and labels of the whole hierarchy, this cell's ports
    /// and info. With the feature `parallel`, large hierarchies are expanded on all cores, with the same result.
    ///
    /// Aliases go with the references that they name.
    #[must_use]
    pub fn flattened(&self) -> Self {
        let mut cell = self.edit();
        cell.flatten();
        cell.cell.finish()
    }

    /// How many polygons and points are drawn in this cell and below it.
    #[must_use]
    pub fn flat_counts(&self) -> (usize, usize) {
        let amount = amounts(self)[&self.address()];
        (amount.polygons, amount.points)
    }
}

/// All polygons of a hierarchy, its own first, then those of the references in order.
pub(super) fn all_outlines(device: &Device) -> Outlines {
    let amounts = amounts(device);
    let total = amounts[&device.address()];
    #[cfg(feature = "parallel")]
    if super::parallel::is_worth_it(total) {
        return with_properties(super::parallel::all_outlines(device, &amounts), device);
    }
    let mut flat = Outlines::default();
    flat.reserve(total.polygons, total.points);
    push_outlines(device, &Transform::IDENTITY, &mut flat);
    with_properties(flat, device)
}

/// All labels of a hierarchy, in the same order.
pub(super) fn all_labels(device: &Device) -> Vec<Label> {
    let placed = device.instances().flat_map(|instance| {
        instance.device.labels().iter().map(move |label| {
            let mut label = label.clone();
            label.transform_mut(&instance.transform);
            label
        })
    });
    placed.collect()
}

/// What is drawn in every cell of a hierarchy and below it, by the cell's address. Cells come after what they place.
pub(super) fn amounts(device: &Device) -> HashMap<usize, Amount> {
    let mut amounts: HashMap<usize, Amount> = HashMap::new();
    for cell in device.cells().iter().rev() {
        let outlines = &cell.cell().outlines;
        let mut amount = Amount { polygons: outlines.len(), points: outlines.point_count() };
        for reference in cell.references() {
            let child = amounts[&reference.device().address()];
            amount.polygons += child.polygons * reference.count();
            amount.points += child.points * reference.count();
        }
        amounts.insert(cell.address(), amount);
    }
    amounts
}

fn push_outlines(device: &Device, transform: &Transform, flat: &mut Outlines) {
    let matrix = transform.matrix();
    for polygon in device.polygons() {
        flat.push_mapped(polygon.points, polygon.layer, |p| matrix.apply(p));
    }
    for reference in device.references() {
        for element in reference.elements() {
            push_outlines(reference.device(), &element.then(transform), flat);
        }
    }
}

/// Properties are rare: they are put in afterwards, and only if some cell has any.
fn with_properties(mut flat: Outlines, device: &Device) -> Outlines {
    let any = device.cells().iter().any(|cell| cell.polygons().any(|p| p.property_map().is_some()));
    if any {
        let polygons = device.instances().flat_map(|instance| instance.device.polygons());
        for (place, polygon) in polygons.enumerate() {
            if let Some(properties) = polygon.property_map() {
                flat.set_properties(place, properties.clone());
            }
        }
    }
    flat
}
