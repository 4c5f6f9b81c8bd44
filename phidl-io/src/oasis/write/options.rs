//! How an OASIS file is encoded, and what the writer did.

use phidl_core::layer::LayerSet;

use crate::error::{IoError, Result};

/// How an OASIS file is encoded.
///
/// ```
/// use phidl_io::oasis::{EncodeOptions, Validation};
/// let quick = EncodeOptions { level: 1, validation: Validation::None, ..Default::default() };
/// # assert!(quick.compress);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct EncodeOptions {
    /// The checksum in the last record; CRC-32 by default.
    pub validation: Validation,
    /// Whether cells are deflated where that makes them shorter; true by default.
    pub compress: bool,
    /// How hard to deflate, from 1 (quick) to 9 (short); 6 by default.
    pub level: u32,
    /// What rectangles become; rectangles by default.
    pub shapes: Shapes,
    /// Whether elements that are equal up to a shift become one record with a repetition; true by default. The drawing is
    /// the same, the order of elements is not.
    pub merge_repeats: bool,
    /// Whether each cell name states the bounding box of its cell, where that is exact; false by default: it costs about
    /// twenty bytes for each cell, and KLayout, gdstk and gdspy make no use of it.
    pub bounding_boxes: bool,
    /// Names of layers for the file.
    pub layers: Option<LayerSet>,
}

impl Default for EncodeOptions {
    fn default() -> Self {
        Self {
            validation: Validation::Crc32,
            compress: true,
            level: 6,
            shapes: Shapes::Rectangles,
            merge_repeats: true,
            bounding_boxes: false,
            layers: None,
        }
    }
}

/// The checksum in the last record of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Validation {
    /// CRC-32 of all bytes.
    #[default]
    Crc32,
    /// The sum of all bytes.
    Sum,
    /// None.
    None,
}

/// What polygons that are rectangles become.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Shapes {
    /// Rectangles, which are a third as long.
    #[default]
    Rectangles,
    /// Polygons, which keep their first corner and their direction.
    Polygons,
}

/// What the writer did.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct OasisReport {
    /// The names of the cells in the file, in its order.
    pub cells: Vec<String>,
    /// Records of elements.
    pub records: u64,
    /// Elements that share the record of another one.
    pub repeats_merged: u64,
    /// Texts that say less in the format than in the layout. The rest is in a property that phidl reads.
    pub labels_simplified: u64,
    /// Paths whose ends or odd widths the format does not have, and which became polygons.
    pub paths_outlined: u64,
    /// Elements without a counterpart, which were left out: nodes, and polygons and paths that enclose nothing.
    pub left_out: u64,
    /// Cells whose names the format does not allow, and which got others.
    pub renamed: u64,
    /// Compressed blocks.
    pub blocks: u64,
    /// Length of the file (bytes).
    pub bytes: u64,
}

impl OasisReport {
    /// What the file does not keep, as sentences.
    #[must_use]
    pub fn losses(&self) -> Vec<String> {
        let counts = [
            (self.left_out, "elements have no counterpart in OASIS and are left out"),
            (self.labels_simplified, "labels have an anchor, angle, size or line break that only phidl reads"),
            (self.paths_outlined, "paths have round ends or an odd width and are polygons"),
            (self.renamed, "cells have names that OASIS does not allow and are renamed"),
        ];
        counts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect()
    }
}

impl EncodeOptions {
    /// Refuses options that no file can have.
    pub(super) fn check(&self) -> Result<()> {
        if !(1..=9).contains(&self.level) {
            return Err(IoError::option("level", self.level, "be from 1 to 9"));
        }
        let names = self.layers.iter().flat_map(LayerSet::iter).map(|layer| layer.name.as_str());
        for name in names {
            if !is_name(name) {
                let rule = "be the name of a layer in visible ASCII characters without spaces";
                return Err(IoError::option("layers", format_args!("{name:?}"), rule));
            }
        }
        Ok(())
    }
}

/// Whether the format allows a text as a name: visible ASCII characters.
pub(super) fn is_name(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_graphic())
}
