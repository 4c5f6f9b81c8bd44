//! Files into layouts and devices.

use std::path::Path;

use phidl_core::layer::Layers;
use phidl_core::scene::Device;

use super::format::{Detected, Format, detect, unknown};
use crate::error::{IoError, Result};
use crate::input;
use crate::model::{Date, Layout, Problem, choose, devices};

/// Options of the reader, for all formats.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// The cell to read, whether or not others place it. Without a name, the only top cell of the file.
    pub cellname: Option<String>,
    /// The layers to read; polygons and labels on others are left out and counted. Without layers, everything.
    pub layers: Option<Layers>,
    /// Whether the cell becomes one without references.
    pub flatten: bool,
    /// The most bytes that a compressed file may hold, inflated; 16 GiB by default.
    pub max_bytes: u64,
    /// How OASIS files are decoded.
    #[cfg(feature = "oasis")]
    pub oasis: crate::oasis::DecodeOptions,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self {
            cellname: None,
            layers: None,
            flatten: false,
            max_bytes: 16 << 30,
            #[cfg(feature = "oasis")]
            oasis: Default::default(),
        }
    }
}

/// One cell of a file.
#[derive(Debug, Clone)]
pub struct Import {
    /// The cell with all that it places. Cells keep their names; one that is placed often is one device.
    pub device: Device,
    /// The format of the file.
    pub format: Format,
    /// What was left out or read as something else, in the order of the file; at most 10,000 are listed.
    pub problems: Vec<Problem>,
    /// How many further problems there are.
    pub unlisted_problems: usize,
    /// Polygons, paths, boxes and texts on layers that were not asked for.
    pub left_out: u64,
    /// The name of the library; OASIS has none.
    pub library_name: String,
    /// The grid of the file (µm).
    pub grid: f64,
    /// The user unit of the file (µm). Coordinates are micrometers, whatever it is.
    pub user_unit: f64,
}

/// All cells of a file.
#[derive(Debug, Clone)]
pub struct Library {
    /// The format of the file.
    pub format: Format,
    /// The name of the library; OASIS has none.
    pub name: String,
    /// The grid of the file (µm).
    pub grid: f64,
    /// The user unit of the file (µm).
    pub user_unit: f64,
    /// When the library was last modified, as a GDSII file states it.
    pub modified: Option<Date>,
    /// The cells, in the order of the file.
    pub cells: Vec<Device>,
    /// The indices of the cells that no other cell places.
    pub tops: Vec<usize>,
    /// What was left out or read as something else, in the order of the file; at most 10,000 are listed.
    pub problems: Vec<Problem>,
    /// How many further problems there are.
    pub unlisted_problems: usize,
    /// Polygons, paths, boxes and texts on layers that were not asked for.
    pub left_out: u64,
}

/// Reads one cell of a layout file of any format.
///
/// ```
/// # use phidl_core::prelude::*;
/// use phidl_io::layout::{self, ReadOptions, WriteOptions};
/// let mut d = Device::builder("pad");
/// d.add_polygon([(0, 0), (40, 0), (40, 20), (0, 20)], 1)?;
/// let pad = d.build()?;
///
/// # let folder = tempfile::tempdir()?;
/// for name in ["pad.gds", "pad.oas", "pad.gds.gz"] {
///     # let name = folder.path().join(name);
///     layout::write(&pad, &name, &WriteOptions::default())?;
///     let read = layout::read(&name, &ReadOptions::default())?.device;
///     assert_eq!((read.name(), read.bbox()), ("pad", pad.bbox()));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IoError::File`]; [`IoError::UnknownFormat`]; those of [`gds::read`](crate::gds::read).
pub fn read(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Import> {
    let path = path.as_ref();
    import(&input::read(path)?, &path.display().to_string(), options)
}

/// Reads one cell of the bytes of a layout file, as [`read`] does.
///
/// # Errors
/// As for [`read`], in the name of "these bytes".
pub fn read_bytes(bytes: &[u8], options: &ReadOptions) -> Result<Import> {
    import(bytes, "these bytes", options)
}

fn import(bytes: &[u8], file: &str, options: &ReadOptions) -> Result<Import> {
    let (format, mut layout) = decode(bytes, file, options)?;
    let top = choose(&layout, file, options.cellname.as_deref())?;
    let mut built = devices(&mut layout, file, &[top], options.layers.as_ref())?;
    let mut device = built.tops.swap_remove(0);
    if options.flatten {
        device = flattened(&device)?;
    }
    let unlisted_problems = layout.problems.unlisted();
    Ok(Import {
        device,
        format,
        problems: layout.problems.into_sorted(),
        unlisted_problems,
        left_out: built.left_out,
        library_name: layout.name,
        grid: layout.grid.step(),
        user_unit: layout.user_unit,
    })
}

/// The device without references, if it is one that memory holds.
pub(super) fn flattened(device: &Device) -> Result<Device> {
    let failed = |source| IoError::Device { place: device.name().into(), source: Box::new(source) };
    device.flattened().map_err(failed)
}

/// Reads all cells of a layout file of any format.
///
/// A file without cells is a library without cells. [`ReadOptions::cellname`] limits it to a cell and what is below it;
/// [`ReadOptions::flatten`] makes each cell one without references.
///
/// # Errors
/// As for [`read`], except those about top cells.
pub fn read_library(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Library> {
    let path = path.as_ref();
    let file = path.display().to_string();
    let (format, mut layout) = decode(&input::read(path)?, &file, options)?;
    if let Some(name) = &options.cellname {
        let top = choose(&layout, &file, Some(name))?;
        super::layers::keep_below(&mut layout, top);
    }
    let tops = layout.tops();
    let all: Vec<usize> = (0..layout.cells.len()).collect();
    let built = devices(&mut layout, &file, &all, options.layers.as_ref())?;
    let mut cells = built.tops;
    if options.flatten {
        cells = cells.iter().map(flattened).collect::<Result<_>>()?;
    }
    let unlisted_problems = layout.problems.unlisted();
    Ok(Library {
        format,
        name: layout.name,
        grid: layout.grid.step(),
        user_unit: layout.user_unit,
        modified: layout.modified,
        cells,
        tops,
        problems: layout.problems.into_sorted(),
        unlisted_problems,
        left_out: built.left_out,
    })
}

/// Reads a layout file of any format as it stands. Of the options, only the limits count.
///
/// # Errors
/// [`IoError::File`]; [`IoError::UnknownFormat`]; [`IoError::Malformed`]; [`IoError::DuplicateCell`].
pub fn read_layout(path: impl AsRef<Path>, options: &ReadOptions) -> Result<(Format, Layout)> {
    let path = path.as_ref();
    decode(&input::read(path)?, &path.display().to_string(), options)
}

/// Decodes the bytes of a layout file of any format. `file` is what errors call it.
///
/// # Errors
/// As for [`read_layout`].
pub fn decode(bytes: &[u8], file: &str, options: &ReadOptions) -> Result<(Format, Layout)> {
    match detect(bytes) {
        Some(Detected::Layout(format)) => decode_as(format, bytes, file, options),
        Some(Detected::Gzip) => decode_gzip(bytes, file, options),
        _ => Err(unknown(bytes, file)),
    }
}

fn decode_as(format: Format, bytes: &[u8], file: &str, options: &ReadOptions) -> Result<(Format, Layout)> {
    let layout = match format {
        Format::Gds => crate::gds::parse(bytes, file)?,
        #[cfg(feature = "oasis")]
        Format::Oasis => crate::oasis::decode(bytes, file, &options.oasis)?,
        #[cfg(not(feature = "oasis"))]
        Format::Oasis => {
            let _ = options;
            return Err(IoError::NotCompiledIn { file: file.into(), format: "OASIS", feature: "oasis" });
        }
    };
    Ok((format, layout))
}

#[cfg(feature = "gzip")]
fn decode_gzip(bytes: &[u8], file: &str, options: &ReadOptions) -> Result<(Format, Layout)> {
    let (inflated, trailing) = super::gzip::inflate(bytes, file, options.max_bytes)?;
    let Some(Detected::Layout(format)) = detect(&inflated) else { return Err(unknown(&inflated, file)) };
    let (format, mut layout) = decode_as(format, &inflated, file, options)?;
    if trailing > 0 {
        layout.problems.push("", bytes.len() - trailing, crate::model::ProblemKind::Trailing(trailing));
    }
    Ok((format, layout))
}

#[cfg(not(feature = "gzip"))]
fn decode_gzip(_: &[u8], file: &str, _: &ReadOptions) -> Result<(Format, Layout)> {
    Err(IoError::NotCompiledIn { file: file.into(), format: "gzip", feature: "gzip" })
}
