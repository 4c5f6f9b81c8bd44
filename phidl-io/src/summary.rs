//! [`Summary`]: what a mask holds, in figures that other programs can check.

use std::collections::{BTreeMap, HashMap};

use phidl_core::geom::Rect;
use phidl_core::layer::Layer;
use phidl_core::place::Bounded;
use phidl_core::scene::Device;

/// What a device holds with all that it places.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// The box around everything drawn.
    pub bbox: Option<Rect>,
    /// How often cells are placed, at any depth, the top cell aside; every element of an array counts.
    pub instances: u64,
    /// How many labels there are, at any depth.
    pub labels: u64,
    /// What is drawn on each layer.
    pub layers: BTreeMap<Layer, LayerSummary>,
}

/// What is drawn on one layer, every placement counted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LayerSummary {
    /// Polygons.
    pub polygons: u64,
    /// Their corners, as drawn.
    pub vertices: u64,
    /// Sum of their areas (µm²); where they overlap, both count.
    pub area: f64,
}

/// What one cell and everything below it amounts to.
#[derive(Default)]
struct Tally {
    instances: u64,
    labels: u64,
    layers: BTreeMap<Layer, LayerSummary>,
}

impl Summary {
    /// Counts a device, each distinct cell once: the cost does not grow with the number of placements.
    #[must_use]
    pub fn of(device: &Device) -> Self {
        let mut tallies: HashMap<usize, Tally> = HashMap::new();
        for cell in device.cells().iter().rev() {
            let tally = Tally::of(cell, &tallies);
            tallies.insert(cell.address(), tally);
        }
        let Tally { instances, labels, layers } = tallies.remove(&device.address()).unwrap_or_default();
        Self { bbox: device.bbox(), instances, labels, layers }
    }
}

impl Tally {
    fn of(cell: &Device, below: &HashMap<usize, Self>) -> Self {
        let mut tally = Self { labels: cell.labels().len() as u64, ..Self::default() };
        for polygon in cell.polygons() {
            let layer = tally.layers.entry(polygon.layer).or_default();
            layer.polygons += 1;
            layer.vertices += polygon.points.len() as u64;
            layer.area += polygon.area();
        }
        for reference in cell.references() {
            let child = &below[&reference.device().address()];
            tally.add(child, reference.count() as u64, reference.transform().magnification);
        }
        tally
    }

    fn add(&mut self, child: &Self, count: u64, magnification: f64) {
        self.instances += count * (1 + child.instances);
        self.labels += count * child.labels;
        for (layer, drawn) in &child.layers {
            let own = self.layers.entry(*layer).or_default();
            own.polygons += count * drawn.polygons;
            own.vertices += count * drawn.vertices;
            own.area += count as f64 * drawn.area * magnification * magnification;
        }
    }
}

impl std::fmt::Display for Summary {
    /// A line for the whole and a table of the layers.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.bbox {
            Some(bbox) => {
                let size = bbox.size();
                writeln!(f, "box          {bbox} µm  ({:.3} × {:.3})", size.width, size.height)?;
            }
            None => writeln!(f, "box          nothing is drawn")?,
        }
        writeln!(f, "instances    {}", self.instances)?;
        writeln!(f, "labels       {}", self.labels)?;
        write!(f, "{:<12} {:>12} {:>12} {:>18}", "layer", "polygons", "vertices", "area (µm²)")?;
        for (layer, drawn) in &self.layers {
            let name = layer.to_string();
            write!(f, "\n{name:<12} {:>12} {:>12} {:>18.6}", drawn.polygons, drawn.vertices, drawn.area)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::prelude::*;

    #[test]
    fn placements_multiply_and_magnification_squares() {
        let mut d = Device::builder("dot");
        d.add_polygon([(0, 0), (2, 0), (2, 2), (0, 2)], 1).unwrap();
        d.add_label("dot", (0, 0), 9);
        let dot = d.build().unwrap();
        let mut d = Device::builder("row");
        d.add(dot.array(3, 2, (5, 5)));
        let row = d.build().unwrap();
        let mut d = Device::builder("top");
        d.add(&row);
        d.add(row.place().scaled(3));
        d.add_polygon([(0, 0), (1, 0), (0, 1)], (2, 1)).unwrap();
        let summary = Summary::of(&d.build().unwrap());
        assert_eq!((summary.instances, summary.labels), (14, 12));
        assert_eq!(summary.layers[&1.into()], LayerSummary { polygons: 12, vertices: 48, area: 24.0 + 216.0 });
        assert_eq!(summary.layers[&(2, 1).into()], LayerSummary { polygons: 1, vertices: 3, area: 0.5 });
    }
}
