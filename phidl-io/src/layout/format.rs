//! Formats, recognized by content or by the ending of a name.

use std::path::Path;

use crate::error::{IoError, Result};

/// A format of layout files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// GDSII stream files.
    Gds,
    /// OASIS files (SEMI P39).
    Oasis,
}

impl std::fmt::Display for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Gds => "GDSII",
            Self::Oasis => "OASIS",
        })
    }
}

/// What some bytes are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Detected {
    /// A layout file.
    Layout(Format),
    /// A gzip file, of whatever.
    Gzip,
    /// KLayout's layer properties.
    Lyp,
}

/// Recognizes some bytes by their beginning; `None` if they are nothing known.
///
/// ```
/// use phidl_io::layout::{Detected, Format, detect};
/// assert_eq!(detect(b"%SEMI-OASIS\r\n"), Some(Detected::Layout(Format::Oasis)));
/// assert_eq!(detect(b"hello"), None);
/// ```
#[must_use]
pub fn detect(bytes: &[u8]) -> Option<Detected> {
    if bytes.starts_with(&[0x1f, 0x8b]) {
        return Some(Detected::Gzip);
    }
    // A HEADER record of one number.
    if bytes.starts_with(&[0, 6, 0, 2]) {
        return Some(Detected::Layout(Format::Gds));
    }
    if bytes.starts_with(b"%SEMI-OASIS\r\n") {
        return Some(Detected::Layout(Format::Oasis));
    }
    let start = &bytes[..bytes.len().min(1024)];
    let contains = |text: &[u8]| start.windows(text.len()).any(|window| window == text);
    (contains(b"<layer-properties")).then_some(Detected::Lyp)
}

/// The format that the ending of a name stands for, and whether it asks for gzip. Capitals do not matter.
///
/// ```
/// use phidl_io::layout::{Format, of_name};
/// assert_eq!(of_name("chip.OAS".as_ref()), Some((Format::Oasis, false)));
/// assert_eq!(of_name("chip.gds.gz".as_ref()), Some((Format::Gds, true)));
/// assert_eq!(of_name("chip.txt".as_ref()), None);
/// ```
#[must_use]
pub fn of_name(path: &Path) -> Option<(Format, bool)> {
    let name = path.file_name()?.to_string_lossy().to_ascii_lowercase();
    let (stem, gzip) = name.strip_suffix(".gz").map_or((name.as_str(), false), |stem| (stem, true));
    let format = match stem.rsplit_once('.')?.1 {
        "gds" | "gdsii" | "gds2" => Format::Gds,
        "oas" | "oasis" => Format::Oasis,
        _ => return None,
    };
    Some((format, gzip))
}

/// The error that some bytes are no layout file.
pub(super) fn unknown(bytes: &[u8], file: &str) -> IoError {
    let found = match detect(bytes) {
        Some(Detected::Lyp) => "it holds layer properties (LYP)".to_owned(),
        Some(Detected::Gzip) => "it holds another gzip file".to_owned(),
        _ if bytes.is_empty() => "it is empty".to_owned(),
        _ => {
            let start: Vec<String> = bytes.iter().take(16).map(|byte| format!("{byte:02x}")).collect();
            format!("it begins with {}", start.join(" "))
        }
    };
    IoError::UnknownFormat { file: file.into(), found: found.into() }
}

/// The format and compression for a name, or the error that its ending says neither.
pub(super) fn for_name(path: &Path, chosen: Option<Format>) -> Result<(Format, bool)> {
    match (of_name(path), chosen) {
        (Some((format, gzip)), chosen) => Ok((chosen.unwrap_or(format), gzip)),
        (None, Some(format)) => Ok((format, path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("gz")))),
        (None, None) => {
            let rule = "end in .gds, .gdsii, .gds2, .oas or .oasis, or in one of these and .gz";
            Err(IoError::option("path", format_args!("{:?}", path.display().to_string()), rule))
        }
    }
}
