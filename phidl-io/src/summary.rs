//! [`Summary`]: a mask in a few numbers, to be laid beside what another program counts.

use std::path::Path;

use phidl_core::geom::Rect;
use phidl_core::layer::Layer;
use phidl_core::place::Bounded;
use phidl_core::scene::Device;
use serde_json::{Map, json};
use sha2::{Digest, Sha256};

use crate::counts::Counts;
use crate::error::Result;
use crate::gds::GdsOptions;
use crate::json::corners;
use crate::model::CellTable;

/// What is drawn on one layer, over all levels of a mask.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LayerSummary {
    /// The layer; for labels, its datatype is the texttype.
    pub layer: Layer,
    /// Polygons of the devices. (Very large ones are several outlines in the file.)
    pub polygons: u64,
    /// Their corners.
    pub vertices: u64,
    /// The sum of their areas (µm²); where they overlap, it counts twice.
    pub area: f64,
    /// Labels.
    pub labels: u64,
}

/// A mask in numbers. Its `Display` is a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// The name of the top cell in the file.
    pub top: String,
    /// Different cells in the file.
    pub cells: usize,
    /// How often cells are placed in all, every element of every array counted, the top cell not.
    pub instances: u64,
    /// What is drawn, by layer, ascending.
    pub layers: Vec<LayerSummary>,
    /// The box around everything drawn.
    pub bbox: Option<Rect>,
    /// Length of the file (bytes).
    pub bytes: u64,
    /// SHA-256 of the file, in hexadecimal digits.
    pub sha256: String,
}

impl Summary {
    /// Sums up a device and the bytes that were written of it with these options.
    ///
    /// Nothing is flattened: counts are added up cell by cell. Those that do not fit 64 bits stop at the largest number.
    ///
    /// # Errors
    /// [`IoError::Option`](crate::IoError::Option) as for writing.
    pub fn new(device: &Device, options: &GdsOptions, bytes: &[u8]) -> Result<Self> {
        options.check()?;
        let table = CellTable::of(device.into(), &options.naming());
        let counts = Counts::of(device);
        Ok(Self {
            top: table.name_of(device).to_owned(),
            cells: table.iter().len(),
            instances: counts.instances,
            layers: counts.layers.into_values().collect(),
            bbox: device.bbox(),
            bytes: bytes.len() as u64,
            sha256: Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect(),
        })
    }

    /// Sums up a device and the file that was written of it with these options.
    ///
    /// # Errors
    /// [`IoError::File`](crate::IoError::File) if it cannot be read; [`IoError::Option`](crate::IoError::Option) as for writing.
    pub fn of_file(device: &Device, options: &GdsOptions, path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        Self::new(device, options, &crate::input::read(path)?)
    }
}

impl Summary {
    /// The same as JSON, layers by their names.
    #[must_use]
    pub fn to_json(&self) -> serde_json::Value {
        let layers = self.layers.iter().map(|layer| {
            let LayerSummary { polygons, vertices, area, labels, .. } = *layer;
            let figures = json!({ "polygons": polygons, "vertices": vertices, "area": area, "labels": labels });
            (layer.layer.to_string(), figures)
        });
        json!({
            "top": self.top,
            "cells": self.cells,
            "instances": self.instances,
            "layers": layers.collect::<Map<_, _>>(),
            "bbox": self.bbox.map(corners),
            "bytes": self.bytes,
            "sha256": self.sha256,
        })
    }
}

impl std::fmt::Display for Summary {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "top cell   {}", self.top)?;
        writeln!(f, "cells      {}", self.cells)?;
        writeln!(f, "instances  {}", self.instances)?;
        match self.bbox {
            Some(bbox) => writeln!(f, "box        {bbox} µm")?,
            None => writeln!(f, "box        none")?,
        }
        writeln!(f, "file       {} bytes", self.bytes)?;
        writeln!(f, "sha256     {}", self.sha256)?;
        write!(f, "{:>11} {:>12} {:>14} {:>20} {:>10}", "layer", "polygons", "vertices", "area (µm²)", "labels")?;
        for LayerSummary { layer, polygons, vertices, area, labels } in &self.layers {
            let layer = layer.to_string();
            write!(f, "\n{layer:>11} {polygons:>12} {vertices:>14} {area:>20.6} {labels:>10}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use phidl_core::geom::Transform;
    use phidl_core::scene::Reference;

    use super::*;
    use crate::gds;

    fn mask() -> Device {
        let mut d = Device::builder("dot");
        d.add_polygon([(0, 0), (2, 0), (2, 2), (0, 2)], 1).unwrap();
        d.add_label("dot", (0, 0), (10, 2)).unwrap();
        let dot = d.build().unwrap();
        let mut d = Device::builder("field");
        d.add(dot.array(100, 10, (5, 5)));
        d.add_polygon([(0, 0), (9, 0), (0, 9)], 2).unwrap();
        let field = d.build().unwrap();
        let mut d = Device::builder("mask");
        d.add(&field);
        d.add(Reference::new(field, Transform::scaling(3.0)));
        d.build().unwrap()
    }

    #[test]
    fn counts_and_areas_are_those_of_the_flat_drawing() {
        let mask = mask();
        let options = GdsOptions::default();
        let summary = Summary::new(&mask, &options, b"").unwrap();
        let flat: Vec<_> = mask.flat_polygons().collect();
        assert_eq!(summary.layers.iter().map(|l| l.polygons).sum::<u64>(), flat.len() as u64);
        let vertices: u64 = flat.iter().map(|p| p.len() as u64).sum();
        assert_eq!(summary.layers.iter().map(|l| l.vertices).sum::<u64>(), vertices);
        let area: f64 = flat.iter().map(|p| p.area()).sum();
        assert!((summary.layers.iter().map(|l| l.area).sum::<f64>() / area - 1.0).abs() < 1e-12);
        assert_eq!(summary.instances, mask.instances().count() as u64 - 1);
        assert_eq!(summary.layers.iter().map(|l| l.labels).sum::<u64>(), 2000);
        // SHA-256 of nothing, from its definition.
        assert_eq!(summary.sha256, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    }

    #[test]
    fn the_table_is_easy_to_read() {
        let summary =
            Summary { sha256: "…".into(), ..Summary::new(&mask(), &GdsOptions::default(), b"gds").unwrap() };
        expect![[r#"
            top cell   mask
            cells      3
            instances  2002
            box        (0, 0) to (1491, 141) µm
            file       3 bytes
            sha256     …
                  layer     polygons       vertices           area (µm²)     labels
                    1/0         2000           8000         40000.000000          0
                    2/0            2              6           405.000000          0
                   10/2            0              0             0.000000       2000"#]]
        .assert_eq(&summary.to_string());
    }

    #[test]
    fn numbers_that_are_too_large_stop_at_the_largest() {
        let mut cell = mask();
        for level in 0..8 {
            let mut d = Device::builder(format!("level{level}"));
            d.add(cell.array(60_000, 60_000, (0, 0)));
            cell = d.build().unwrap();
        }
        let counts = Counts::of(&cell);
        assert_eq!((counts.instances, counts.layers[&Layer::new(1, 0)].polygons), (u64::MAX, u64::MAX));
    }

    #[test]
    fn a_file_is_summed_up_as_it_lies_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("mask.gds");
        let options = GdsOptions::default();
        let report = gds::write(&mask(), &path, &options).unwrap();
        let summary = Summary::of_file(&mask(), &options, &path).unwrap();
        assert_eq!((summary.bytes, summary.cells), (report.bytes, report.cells.len()));
        assert!(Summary::of_file(&mask(), &options, folder.path().join("none")).is_err());
    }
}
