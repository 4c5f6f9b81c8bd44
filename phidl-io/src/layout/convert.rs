//! A layout file into another one.
//!
//! Where neither the grid changes nor the hierarchy is opened, a file goes through the layout model alone: paths stay
//! paths, dates stay dates. Otherwise it goes through devices, whose outlines are rounded once.

use std::path::Path;

use super::format::{Format, for_name};
use super::layers::{LayerMap, keep_below, keep_layers};
use super::reading::{ReadOptions, flattened, read_layout};
use super::writing::{WriteOptions, WriteReport, encode, put, to_bytes};
use crate::error::{IoError, Result};
use crate::model::{CellNames, Layout, Problem, choose, devices};

/// What is made of a file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ConvertOptions {
    /// How the file is read: one cell with what is below it, flat, within limits.
    pub read: ReadOptions,
    /// Which layers are kept, and under which numbers; all of them by default.
    pub layers: Option<LayerMap>,
    /// The grid of the result (µm); that of the file by default.
    pub grid: Option<f64>,
    /// The user unit of the result (µm); that of the file by default.
    pub user_unit: Option<f64>,
    /// The name of the top cell in the result, if there is only one.
    pub top_name: Option<String>,
    /// How the result is written. Its grid and names do not count here.
    pub write: WriteOptions,
}

/// A result that is not written yet.
#[derive(Debug, Clone)]
pub struct Conversion {
    /// What the reader left out or read as something else; at most 10,000 are listed.
    pub problems: Vec<Problem>,
    /// How many further problems there are.
    pub unlisted_problems: usize,
    /// What the result does not keep of the layout, as sentences.
    pub losses: Vec<String>,
    /// The bytes of the result, before gzip.
    bytes: Vec<u8>,
    format: (Format, bool),
    write: WriteOptions,
}

impl Conversion {
    /// Whether anything of the file is not in the result.
    #[must_use]
    pub fn is_lossless(&self) -> bool {
        self.problems.is_empty() && self.losses.is_empty()
    }

    /// Writes the result.
    ///
    /// # Errors
    /// [`IoError::File`].
    pub fn write(self, path: impl AsRef<Path>) -> Result<WriteReport> {
        put(path.as_ref(), &self.bytes, self.format, &self.write, self.losses)
    }
}

/// Makes a file of another one, in the format that the ending of its name stands for. Nothing is written before
/// [`Conversion::write`].
///
/// # Errors
/// Those of reading and writing; [`IoError::Option`] if both names lead to one file.
pub fn convert(input: impl AsRef<Path>, output: impl AsRef<Path>, options: &ConvertOptions) -> Result<Conversion> {
    let (input, output) = (input.as_ref(), output.as_ref());
    let format = for_name(output, options.write.format)?;
    let same = |a: &Path, b: &Path| a.canonicalize().ok().zip(b.canonicalize().ok()).is_some_and(|(a, b)| a == b);
    if same(input, output) {
        let value = format_args!("{:?}", output.display().to_string()).to_string();
        return Err(IoError::option("output", value, "be another file than the input"));
    }
    let file = input.display().to_string();
    let (_, mut layout) = read_layout(input, &options.read)?;
    if let Some(name) = &options.read.cellname {
        let top = choose(&layout, &file, Some(name))?;
        keep_below(&mut layout, top);
    }
    let mut losses = Vec::new();
    if let Some(map) = &options.layers {
        keep_layers(&mut layout, map);
    }
    if let Some(user_unit) = options.user_unit {
        layout.user_unit = user_unit;
    }
    let bytes = if options.grid.is_some() || options.read.flatten {
        through_devices(&mut layout, &file, format.0, options)?
    } else {
        if let Some(name) = &options.top_name {
            rename_top(&mut layout, name)?;
        }
        let (bytes, lost) = encode(&layout, format.0, &options.write)?;
        losses.extend(lost);
        bytes
    };
    let unlisted_problems = layout.problems.unlisted();
    let problems = layout.problems.into_sorted();
    Ok(Conversion { problems, unlisted_problems, losses, bytes, format, write: options.write.clone() })
}

fn through_devices(layout: &mut Layout, file: &str, format: Format, options: &ConvertOptions) -> Result<Vec<u8>> {
    let tops = layout.tops();
    let mut devices = devices(layout, file, &tops, options.read.layers.as_ref())?.tops;
    if options.read.flatten {
        devices = devices.iter().map(flattened).collect::<Result<_>>()?;
    }
    let mut write = options.write.clone();
    write.gds.grid = options.grid.unwrap_or(layout.grid.step());
    write.gds.user_unit = layout.user_unit;
    write.gds.top_name.clone_from(&options.top_name);
    write.gds.allow_empty = true;
    if !layout.name.is_empty() {
        write.gds.library_name.clone_from(&layout.name);
    }
    to_bytes(&devices, format, &write)
}

/// Gives another name to the only top cell.
fn rename_top(layout: &mut Layout, name: &str) -> Result<()> {
    let [top] = layout.tops()[..] else {
        return Err(IoError::option(
            "top_name",
            format_args!("{name:?}"),
            "be left out where there are several top cells",
        ));
    };
    let old = layout.cells[top].name;
    if layout.names.find(name).is_some_and(|id| id != old) {
        return Err(IoError::option(
            "top_name",
            format_args!("{name:?}"),
            "be another name than those of the other cells",
        ));
    }
    // Names keep their numbers, so that placements need not be looked at.
    let mut names = CellNames::default();
    for (index, known) in layout.names.iter().enumerate() {
        names.intern(if index == old.index() { name } else { known });
    }
    layout.names = names;
    Ok(())
}
