//! A file in numbers: what is in it, cell by cell and layer by layer.
//!
//! Figures of a layer count over the whole hierarchy, but nothing is expanded: counts are added up cell by cell.

use std::collections::BTreeMap;
use std::path::Path;

use phidl_core::geom::Rect;
use phidl_core::layer::Layer;
use phidl_core::place::Bounded;
use phidl_core::scene::Device;
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};

use super::format::{Detected, Format, detect};
use super::reading::{ReadOptions, decode};
use crate::counts::Counts;
use crate::error::Result;
use crate::input;
use crate::json::corners;
use crate::model::{Cell, Date, Layout, Problem, choose, devices};

/// Merged areas are measured up to this number of corners: they cost a boolean operation.
const MOST_MERGED: u64 = 1 << 24;

/// A layout file in numbers.
#[derive(Debug, Clone)]
pub struct Inspection {
    /// Length of the file (bytes).
    pub bytes: u64,
    /// SHA-256 of the file, in hexadecimal digits.
    pub sha256: String,
    /// Whether the file is compressed with gzip.
    pub gzip: bool,
    /// The format.
    pub format: Format,
    /// The name of the library; OASIS has none.
    pub library: String,
    /// The grid (µm).
    pub grid: f64,
    /// The user unit (µm).
    pub user_unit: f64,
    /// When the library was last modified, as a GDSII file states it.
    pub modified: Option<Date>,
    /// The top cells.
    pub tops: Vec<String>,
    /// The cells, in the order of the file.
    pub cells: Vec<CellFigures>,
    /// What is drawn on each layer, all levels below the top cells included.
    pub layers: BTreeMap<Layer, LayerFigures>,
    /// What the reader left out or read as something else; at most 10,000 are listed.
    pub problems: Vec<Problem>,
    /// How many further problems there are.
    pub unlisted_problems: usize,
}

/// A cell in numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct CellFigures {
    /// Its name.
    pub name: String,
    /// When it was last modified, as a GDSII file states it.
    pub modified: Option<Date>,
    /// The box around everything that it draws (µm), all levels included.
    pub bbox: Option<Rect>,
    /// Its own polygons.
    pub polygons: u64,
    /// Their corners.
    pub vertices: u64,
    /// Its own paths.
    pub paths: u64,
    /// Its own BOX elements.
    pub boxes: u64,
    /// Its own labels.
    pub labels: u64,
    /// Its single references.
    pub references: u64,
    /// Its arrays.
    pub arrays: u64,
    /// How many references and arrays place it.
    pub placed: u64,
    /// Its elements that have properties.
    pub with_properties: u64,
}

/// A layer in numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LayerFigures {
    /// Polygons, paths and boxes.
    pub polygons: u64,
    /// The corners of their outlines.
    pub vertices: u64,
    /// The sum of their areas (µm²); where they overlap, it counts twice.
    pub area: f64,
    /// The area of their union (µm²), if it was measured.
    pub merged_area: Option<f64>,
    /// Labels.
    pub labels: u64,
}

/// Reads a layout file and counts. `merged`: whether the area of the union is measured for each layer.
///
/// [`ReadOptions::cellname`] limits it to a cell and what is below it.
///
/// # Errors
/// As for [`read_layout`](super::read_layout); [`IoError::UnknownCell`](crate::IoError::UnknownCell);
/// [`IoError::CyclicCells`](crate::IoError::CyclicCells).
pub fn inspect(path: impl AsRef<Path>, options: &ReadOptions, merged: bool) -> Result<Inspection> {
    let path = path.as_ref();
    inspect_named(&input::read(path)?, &path.display().to_string(), options, merged)
}

/// Counts in the bytes of a layout file, as [`inspect()`] does.
///
/// # Errors
/// As for [`inspect()`], in the name of "these bytes".
pub fn inspect_bytes(bytes: &[u8], options: &ReadOptions, merged: bool) -> Result<Inspection> {
    inspect_named(bytes, "these bytes", options, merged)
}

fn inspect_named(bytes: &[u8], file: &str, options: &ReadOptions, merged: bool) -> Result<Inspection> {
    let (format, mut layout) = decode(bytes, file, options)?;
    if let Some(name) = &options.cellname {
        let top = choose(&layout, file, Some(name))?;
        super::layers::keep_below(&mut layout, top);
    }
    let mut cells = figures(&layout);
    let tops = layout.tops();
    let top_names = tops.iter().map(|top| cells[*top].name.clone()).collect();
    let all: Vec<usize> = (0..layout.cells.len()).collect();
    let devices = devices(&mut layout, file, &all, options.layers.as_ref())?.tops;
    for (cell, device) in cells.iter_mut().zip(&devices) {
        cell.bbox = device.bbox();
    }
    let layers = layers(tops.iter().map(|top| &devices[*top]), merged);
    let unlisted_problems = layout.problems.unlisted();
    Ok(Inspection {
        bytes: bytes.len() as u64,
        sha256: Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect(),
        gzip: detect(bytes) == Some(Detected::Gzip),
        format,
        library: layout.name,
        grid: layout.grid.step(),
        user_unit: layout.user_unit,
        modified: layout.modified,
        tops: top_names,
        cells,
        layers,
        problems: layout.problems.into_sorted(),
        unlisted_problems,
    })
}

/// The figures of all cells, boxes aside.
fn figures(layout: &Layout) -> Vec<CellFigures> {
    let mut placed = vec![0_u64; layout.names.len()];
    for placement in layout.cells.iter().flat_map(|cell| &cell.placements) {
        placed[placement.child.index()] += 1;
    }
    let figures = |cell: &Cell| CellFigures {
        name: layout.names.name(cell.name).to_owned(),
        modified: cell.modified,
        bbox: None,
        polygons: cell.polygons.len() as u64,
        vertices: cell.polygons.corner_count() as u64,
        paths: cell.paths.len() as u64,
        boxes: cell.boxes.len() as u64,
        labels: cell.texts.len() as u64,
        references: cell.placements.iter().filter(|placement| placement.lattice.is_none()).count() as u64,
        arrays: cell.placements.iter().filter(|placement| placement.lattice.is_some()).count() as u64,
        placed: placed[cell.name.index()],
        with_properties: with_properties(cell),
    };
    layout.cells.iter().map(figures).collect()
}

fn with_properties(cell: &Cell) -> u64 {
    let polygons = cell.polygons.iter().filter(|polygon| polygon.properties.is_some()).count();
    let paths = cell.paths.iter().filter(|path| !path.properties.is_empty()).count();
    let boxes = cell.boxes.iter().filter(|element| !element.properties.is_empty()).count();
    let texts = cell.texts.iter().filter(|text| !text.properties.is_empty()).count();
    let placements = cell.placements.iter().filter(|placement| placement.properties.is_some()).count();
    (polygons + paths + boxes + texts + placements) as u64
}

fn layers<'a>(tops: impl Iterator<Item = &'a Device>, merged: bool) -> BTreeMap<Layer, LayerFigures> {
    let nothing = LayerFigures { polygons: 0, vertices: 0, area: 0.0, merged_area: None, labels: 0 };
    let mut layers = BTreeMap::new();
    for top in tops {
        let counts = Counts::of(top);
        for (layer, more) in &counts.layers {
            let sum: &mut LayerFigures = layers.entry(*layer).or_insert(nothing);
            sum.polygons = sum.polygons.saturating_add(more.polygons);
            sum.vertices = sum.vertices.saturating_add(more.vertices);
            sum.labels = sum.labels.saturating_add(more.labels);
            sum.area += more.area;
        }
        let corners = counts.layers.values().fold(0_u64, |sum, layer| sum.saturating_add(layer.vertices));
        if !merged || corners > MOST_MERGED {
            continue;
        }
        for (layer, area) in phidl_boolean::merged_areas(top).unwrap_or_default() {
            if let Some(sum) = layers.get_mut(&layer) {
                *sum.merged_area.get_or_insert(0.0) += area;
            }
        }
    }
    layers
}

impl Inspection {
    /// The same as JSON, numbers unrounded.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let date = |date: Option<Date>| date.map(|date| date.to_string());
        let layers = self.layers.iter().map(|(layer, figures)| {
            let LayerFigures { polygons, vertices, area, merged_area, labels } = *figures;
            let figures = json!({
                "polygons": polygons, "vertices": vertices, "area": area, "merged_area": merged_area, "labels": labels,
            });
            (layer.to_string(), figures)
        });
        let cells = self.cells.iter().map(|cell| {
            json!({
                "name": cell.name,
                "date": date(cell.modified),
                "bbox": cell.bbox.map(corners),
                "polygons": cell.polygons,
                "vertices": cell.vertices,
                "paths": cell.paths,
                "boxes": cell.boxes,
                "labels": cell.labels,
                "references": cell.references,
                "arrays": cell.arrays,
                "placed": cell.placed,
                "with_properties": cell.with_properties,
            })
        });
        let problems = self.problems.iter().map(ToString::to_string);
        json!({
            "file": { "bytes": self.bytes, "sha256": self.sha256, "gzip": self.gzip },
            "format": { "name": self.format.to_string() },
            "library": {
                "name": self.library,
                "grid": self.grid,
                "user_unit": self.user_unit,
                "date": date(self.modified),
            },
            "tops": self.tops,
            "cells": cells.collect::<Vec<_>>(),
            "layers": layers.collect::<Map<_, _>>(),
            "problems": problems.collect::<Vec<_>>(),
            "unlisted_problems": self.unlisted_problems,
        })
    }
}

impl std::fmt::Display for Inspection {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let gzip = if self.gzip { ", compressed with gzip" } else { "" };
        writeln!(f, "format     {}{gzip}", self.format)?;
        writeln!(f, "file       {} bytes", self.bytes)?;
        writeln!(f, "sha256     {}", self.sha256)?;
        if !self.library.is_empty() {
            writeln!(f, "library    {:?}", self.library)?;
        }
        writeln!(f, "grid       {} µm", self.grid)?;
        writeln!(f, "user unit  {} µm", self.user_unit)?;
        if let Some(date) = self.modified {
            writeln!(f, "modified   {date}")?;
        }
        let tops: Vec<String> = self.tops.iter().map(|top| format!("{top:?}")).collect();
        writeln!(f, "top cells  {}", if tops.is_empty() { "none".to_owned() } else { tops.join(", ") })?;
        writeln!(f, "cells      {}", self.cells.len())?;
        let heads = ["polygons", "vertices", "paths", "labels", "references", "arrays", "placed"];
        write!(f, "\n{:<32}", "cell")?;
        heads.iter().try_for_each(|head| write!(f, " {head:>10}"))?;
        for cell in &self.cells {
            write!(f, "\n{:<32}", format!("{:?}", cell.name))?;
            let CellFigures { polygons, vertices, paths, labels, references, arrays, placed, .. } = cell;
            let figures = [polygons, vertices, paths, labels, references, arrays, placed];
            figures.iter().try_for_each(|figure| write!(f, " {figure:>10}"))?;
        }
        let heads = ["polygons", "vertices", "area (µm²)", "merged (µm²)", "labels"];
        write!(f, "\n\n{:<12}", "layer")?;
        heads.iter().try_for_each(|head| write!(f, " {head:>16}"))?;
        for (layer, figures) in &self.layers {
            let LayerFigures { polygons, vertices, area, merged_area, labels } = figures;
            let merged = merged_area.map_or_else(|| "-".to_owned(), |area| format!("{area:.6}"));
            let layer = layer.to_string();
            write!(f, "\n{layer:<12} {polygons:>16} {vertices:>16} {area:>16.6} {merged:>16} {labels:>16}")?;
        }
        Ok(())
    }
}
