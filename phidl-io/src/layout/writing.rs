//! Devices and layouts into files.

use std::path::Path;

use super::format::{Format, for_name};
use crate::atomic;
use crate::error::{IoError, Result};
use crate::gds::{self, GdsOptions};
use crate::model::{Content, Layout};

/// How a layout file is written. The options of the format that is written count.
#[derive(Debug, Clone, PartialEq)]
pub struct WriteOptions {
    /// The format; by default the one that the ending of the name stands for.
    pub format: Option<Format>,
    /// How GDSII files are written. Grid, names and limits count for all formats.
    pub gds: GdsOptions,
    /// How OASIS files are encoded.
    #[cfg(feature = "oasis")]
    pub oasis: crate::oasis::EncodeOptions,
    /// How hard files that end in `.gz` are compressed, from 1 (quick) to 9 (short); 6 by default.
    pub gzip_level: u32,
}

impl Default for WriteOptions {
    fn default() -> Self {
        Self {
            format: None,
            gds: GdsOptions::default(),
            #[cfg(feature = "oasis")]
            oasis: Default::default(),
            gzip_level: 6,
        }
    }
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WriteReport {
    /// The format of the file.
    pub format: Format,
    /// Whether it is compressed with gzip.
    pub gzip: bool,
    /// Length of the file (bytes).
    pub bytes: u64,
    /// What the file does not keep, as sentences.
    pub losses: Vec<String>,
}

/// Writes a device, or several, with all that they place.
///
/// # Errors
/// [`IoError::Option`] also for a name whose ending is unknown; those of [`gds::write`].
pub fn write<'a>(
    content: impl Into<Content<'a>>,
    path: impl AsRef<Path>,
    options: &WriteOptions,
) -> Result<WriteReport> {
    let path = path.as_ref();
    let (format, gzip) = for_name(path, options.format)?;
    let (bytes, losses) = devices_to_bytes(content.into(), format, options)?;
    put(path, &bytes, (format, gzip), options, losses)
}

/// The bytes of a device, or of several, in a format.
///
/// # Errors
/// As for [`write()`], files aside.
pub fn to_bytes<'a>(content: impl Into<Content<'a>>, format: Format, options: &WriteOptions) -> Result<Vec<u8>> {
    Ok(devices_to_bytes(content.into(), format, options)?.0)
}

/// Writes a layout as it stands.
///
/// # Errors
/// As for [`encode`]; [`IoError::Option`] also for a name whose ending is unknown; [`IoError::File`].
pub fn write_layout(layout: &Layout, path: impl AsRef<Path>, options: &WriteOptions) -> Result<WriteReport> {
    let path = path.as_ref();
    let (format, gzip) = for_name(path, options.format)?;
    let (bytes, losses) = encode(layout, format, options)?;
    put(path, &bytes, (format, gzip), options, losses)
}

/// The bytes of a layout in a format, and what they do not keep of it, as sentences.
///
/// # Errors
/// [`IoError::Option`]; [`IoError::NotCompiledIn`]; what the format cannot state.
pub fn encode(layout: &Layout, format: Format, options: &WriteOptions) -> Result<(Vec<u8>, Vec<String>)> {
    match format {
        Format::Gds => Ok((gds::encode_layout(layout)?, Vec::new())),
        #[cfg(feature = "oasis")]
        Format::Oasis => {
            let (bytes, report) = crate::oasis::encode(layout, &options.oasis)?;
            Ok((bytes, report.losses()))
        }
        #[cfg(not(feature = "oasis"))]
        Format::Oasis => {
            let _ = options;
            Err(not_compiled_in())
        }
    }
}

fn devices_to_bytes(content: Content<'_>, format: Format, options: &WriteOptions) -> Result<(Vec<u8>, Vec<String>)> {
    match format {
        Format::Gds => Ok((gds::to_bytes(content, &options.gds)?, Vec::new())),
        #[cfg(feature = "oasis")]
        Format::Oasis => {
            let layout = gds::to_layout(content, &options.gds)?;
            encode(&layout, format, options)
        }
        #[cfg(not(feature = "oasis"))]
        Format::Oasis => Err(not_compiled_in()),
    }
}

#[cfg(not(feature = "oasis"))]
fn not_compiled_in() -> IoError {
    IoError::NotCompiledIn { file: "the file to be written".into(), format: "OASIS", feature: "oasis" }
}

pub(super) fn put(
    path: &Path,
    bytes: &[u8],
    (format, gzip): (Format, bool),
    options: &WriteOptions,
    losses: Vec<String>,
) -> Result<WriteReport> {
    if !(1..=9).contains(&options.gzip_level) {
        return Err(IoError::option("gzip_level", options.gzip_level, "be from 1 to 9"));
    }
    let bytes = if gzip { write_gzip(path, bytes, options.gzip_level)? } else { atomic::write(path, bytes)? };
    Ok(WriteReport { format, gzip, bytes, losses })
}

#[cfg(feature = "gzip")]
fn write_gzip(path: &Path, bytes: &[u8], level: u32) -> Result<u64> {
    atomic::write(path, &super::gzip::deflate(bytes, level))
}

#[cfg(not(feature = "gzip"))]
fn write_gzip(path: &Path, _: &[u8], _: u32) -> Result<u64> {
    Err(IoError::NotCompiledIn { file: path.display().to_string().into(), format: "gzip", feature: "gzip" })
}
