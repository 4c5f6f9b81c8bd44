//! How much a device holds with all levels below it, added up cell by cell: nothing is flattened.

use std::collections::{BTreeMap, HashMap};

use phidl_core::layer::Layer;
use phidl_core::scene::Device;

use crate::error::{IoError, Result};
use crate::summary::LayerSummary;

/// What a cell holds, all levels below it included. Counts that do not fit 64 bits stay at the largest number.
#[derive(Debug, Clone, Default)]
pub(crate) struct Counts {
    /// How often cells are placed.
    pub(crate) instances: u64,
    pub(crate) layers: BTreeMap<Layer, LayerSummary>,
}

impl Counts {
    pub(crate) fn of(top: &Device) -> Self {
        let mut sums: HashMap<usize, Self> = HashMap::new();
        // Cells come before the cells that they place; backwards, every child is known.
        for cell in top.cells().iter().rev() {
            let mut sum = Self::own(cell);
            for reference in cell.references() {
                let child = &sums[&reference.device().ptr_id()];
                sum.add(child, reference.count() as u64, reference.transform().magnification);
            }
            sums.insert(cell.ptr_id(), sum);
        }
        sums.remove(&top.ptr_id()).unwrap_or_default()
    }

    /// Refuses a device that cannot be walked element by element: with more instances or corners than `most`.
    pub(crate) fn check_flat(top: &Device, most: u64) -> Result<()> {
        let counts = Self::of(top);
        let corners = counts.layers.values().fold(0_u64, |sum, layer| sum.saturating_add(layer.vertices));
        for (what, size) in [("instances", counts.instances), ("corners", corners)] {
            if size > most {
                return Err(IoError::TooLarge { cell: top.name().into(), what, size, most });
            }
        }
        Ok(())
    }

    fn own(cell: &Device) -> Self {
        let mut sum = Self::default();
        for polygon in cell.polygons() {
            let layer = sum.layer(polygon.layer);
            layer.polygons += 1;
            layer.vertices += polygon.points.len() as u64;
            layer.area += polygon.area();
        }
        for label in cell.labels() {
            sum.layer(label.layer).labels += 1;
        }
        sum
    }

    fn layer(&mut self, layer: Layer) -> &mut LayerSummary {
        let nothing = LayerSummary { layer, polygons: 0, vertices: 0, area: 0.0, labels: 0 };
        self.layers.entry(layer).or_insert(nothing)
    }

    fn add(&mut self, child: &Self, count: u64, magnification: f64) {
        let add = |sum: &mut u64, more: u64| *sum = sum.saturating_add(more.saturating_mul(count));
        add(&mut self.instances, child.instances.saturating_add(1));
        for (layer, more) in &child.layers {
            let sum = self.layer(*layer);
            add(&mut sum.polygons, more.polygons);
            add(&mut sum.vertices, more.vertices);
            add(&mut sum.labels, more.labels);
            sum.area += more.area * magnification * magnification * count as f64;
        }
    }
}
