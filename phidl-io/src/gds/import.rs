//! A file into devices.

use std::path::Path;

use phidl_core::layer::Layers;
use phidl_core::scene::Device;

use super::reader;
use crate::error::{IoError, Result};
use crate::input;
use crate::model::{Problem, choose, devices};

/// Options of the reader.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadOptions {
    /// The cell to read, whether or not others place it. Without a name, the only top cell of the file.
    pub cellname: Option<String>,
    /// The layers to read; polygons and labels on others are left out and counted. Without layers, everything.
    pub layers: Option<Layers>,
    /// Whether the polygons and labels of all levels are put into the chosen cell, without references.
    pub flatten: bool,
}

/// What a file holds.
#[derive(Debug, Clone)]
pub struct Import {
    /// The chosen cell with all that it places. Cells keep their names; one that is placed often is one device.
    pub device: Device,
    /// What was left out or read as something else, in the order of the file; at most 10,000 are listed.
    pub problems: Vec<Problem>,
    /// How many further problems there are.
    pub unlisted_problems: usize,
    /// Polygons, paths, boxes and texts on layers that were not asked for.
    pub left_out: u64,
    /// The name of the library.
    pub library_name: String,
    /// The grid of the file (µm).
    pub grid: f64,
    /// The user unit of the file (µm). Coordinates are micrometers, whatever it is.
    pub user_unit: f64,
}

/// Reads a GDSII file.
///
/// Boundaries, boxes and paths become polygons (boxes and paths after the boundaries of their cell), texts labels,
/// references and arrays references; properties stay. Lengths are converted to micrometers. An imported cell has no
/// ports and no generator. [`read_layout`](super::read_layout) keeps paths, boxes, nodes and dates.
///
/// # Errors
/// [`IoError::File`]; [`IoError::Malformed`] with byte and cell;
/// [`IoError::NoTopCell`] and [`IoError::SeveralTopCells`] if a
/// name is needed, [`IoError::UnknownCell`] if it is not there;
/// [`IoError::DuplicateCell`](crate::IoError::DuplicateCell), [`IoError::CyclicCells`](crate::IoError::CyclicCells),
/// [`IoError::TooDeep`](crate::IoError::TooDeep).
pub fn read(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Import> {
    let path = path.as_ref();
    let bytes = input::read(path)?;
    import(bytes, &path.display().to_string(), options)
}

/// Reads the bytes of a GDSII file, as [`read()`] does.
///
/// # Errors
/// As for [`read()`], in the name of "these bytes".
pub fn read_bytes(bytes: &[u8], options: &ReadOptions) -> Result<Import> {
    import(bytes, "these bytes", options)
}

fn import(bytes: impl AsRef<[u8]>, file: &str, options: &ReadOptions) -> Result<Import> {
    let mut layout = reader::parse(bytes.as_ref(), file)?;
    // The bytes of a file are not needed while its devices are built.
    drop(bytes);
    let top = choose(&layout, file, options.cellname.as_deref())?;
    let mut built = devices(&mut layout, file, &[top], options.layers.as_ref())?;
    let mut device = built.tops.swap_remove(0);
    if options.flatten {
        let failed = |source| IoError::Device { place: file.into(), source: Box::new(source) };
        device = device.flattened().map_err(failed)?;
    }
    let unlisted_problems = layout.problems.unlisted();
    Ok(Import {
        device,
        problems: layout.problems.into_sorted(),
        unlisted_problems,
        left_out: built.left_out,
        library_name: layout.name,
        grid: layout.grid.step(),
        user_unit: layout.user_unit,
    })
}
