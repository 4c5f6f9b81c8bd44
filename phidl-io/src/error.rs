//! The one error of reading and writing.
//!
//! Every variant says which file or cell, which element of it, and which rule. Errors are `Clone`, as those of phidl-core
//! are, so a mask build can hand one failure to everything that waited for it; the system's own error is kept behind an
//! `Arc` for that.

use std::path::Path;
use std::sync::Arc;

use phidl_core::layer::Layer;
use phidl_core::num::grid::GridError;

/// The result of reading and writing.
pub type Result<T, E = IoError> = std::result::Result<T, E>;

/// Why a file could not be written or read.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum IoError {
    /// The system refused: no such file, no permission, no space left.
    #[error("{path}: could not {action}")]
    File {
        /// The file.
        path: Box<str>,
        /// What was tried, as the end of "could not …".
        action: &'static str,
        /// What the system said.
        source: Arc<std::io::Error>,
    },
    /// A path leads to something that is no regular file: a device, a pipe, a socket.
    #[error("{path}: it is not a regular file")]
    NotRegular {
        /// The path.
        path: Box<str>,
    },
    /// A file of a folder of results would be written outside of it.
    #[error("{path}: it leads out of the folder {folder}")]
    OutsideFolder {
        /// The path.
        path: Box<str>,
        /// The folder.
        folder: Box<str>,
    },
    /// A device is too large to be walked element by element.
    #[error("cell {cell:?}: it has {} {what} with all levels below, but at most {most} are described or drawn one by one", number(*.size))]
    TooLarge {
        /// The cell.
        cell: Box<str>,
        /// What there is too much of.
        what: &'static str,
        /// How much there is; the largest 64-bit number stands for more.
        size: u64,
        /// How much is allowed.
        most: u64,
    },
    /// The area of a device could not be measured.
    #[error("cell {cell:?}: its area cannot be measured")]
    Area {
        /// The cell.
        cell: Box<str>,
        /// What the boolean engine reports.
        source: Box<phidl_boolean::BooleanError>,
    },
    /// Nothing would be in the file. See [`GdsOptions::allow_empty`](crate::gds::GdsOptions::allow_empty).
    #[error("cell {cell:?}: the mask is empty{}", collapsed_polygons(*.collapsed))]
    EmptyMask {
        /// The top cell.
        cell: Box<str>,
        /// Polygons that enclose nothing on the grid.
        collapsed: u64,
    },
    /// The bytes are no layout file of a known format.
    #[error("{file}: it is no layout file that phidl reads: {found}")]
    UnknownFormat {
        /// The file.
        file: Box<str>,
        /// What was found instead, as a sentence.
        found: Box<str>,
    },
    /// The format of a file was left out when the program was compiled.
    #[error("{file}: {format} needs the feature {feature:?} of phidl-io, which this program is compiled without")]
    NotCompiledIn {
        /// The file.
        file: Box<str>,
        /// The format.
        format: &'static str,
        /// The feature of phidl-io.
        feature: &'static str,
    },
    /// An option of the writer breaks its rule.
    #[error("the option {option} is {value}, but it must {rule}")]
    Option {
        /// The option.
        option: &'static str,
        /// What was given.
        value: Box<str>,
        /// What it must do, as the end of "it must …".
        rule: Box<str>,
    },
    /// An element of a cell has a value that the file cannot state.
    #[error("cell {cell:?}, {item}: the {what} is {value}, but it must {rule}")]
    Refused {
        /// The cell.
        cell: Box<str>,
        /// The element of the cell.
        item: Box<Item>,
        /// What the value is.
        what: &'static str,
        /// The value.
        value: Box<str>,
        /// What it must do, as the end of "it must …".
        rule: Box<str>,
    },
    /// A joint cannot be welded, and the options say that this is an error.
    #[error("cell \"{cell}\": the joint of {} and {} at {position} is {status} and cannot be welded", .sides[0], .sides[1])]
    Unwelded {
        /// The cell that holds both sides.
        cell: Box<str>,
        /// The two sides.
        sides: [Box<str>; 2],
        /// Why it stays open.
        status: Box<str>,
        /// Where it is (µm).
        position: Box<str>,
    },
    /// A coordinate is further out than the file's integers reach.
    #[error("cell {cell:?}, {item}: {source}")]
    OutOfRange {
        /// The cell.
        cell: Box<str>,
        /// The element of the cell.
        item: Box<Item>,
        /// The coordinate and the reach.
        source: GridError,
    },
    /// A placement brings something further out than the file's integers reach.
    #[error("{0}")]
    Extent(Box<phidl_core::scene::ExtentError>),
    /// The file breaks the rules of its format.
    #[error("{file}: malformed at byte {offset}{}: {problem}", in_cell(.cell.as_deref()))]
    Malformed {
        /// The file.
        file: Box<str>,
        /// Where, in bytes from the start.
        offset: usize,
        /// The cell that was being read.
        cell: Option<Box<str>>,
        /// What is wrong.
        problem: Box<str>,
    },
    /// A file of layer properties breaks the rules of XML or of its format.
    #[error("{file}, line {line}, column {column}: {problem}")]
    Xml {
        /// The file.
        file: Box<str>,
        /// The line, from 1.
        line: u32,
        /// The column, from 1.
        column: u32,
        /// What is wrong.
        problem: Box<str>,
    },
    /// Every cell of the file is placed by another one, or there is none; a cell must be named.
    #[error("{file}: there is no top cell; {}", known(.cells))]
    NoTopCell {
        /// The file.
        file: Box<str>,
        /// The cells of the file.
        cells: Vec<String>,
    },
    /// Several cells are placed by no other; one must be named.
    #[error("{file}: there are several top cells, one must be chosen by name: {}", quoted(.cells, ", "))]
    SeveralTopCells {
        /// The file.
        file: Box<str>,
        /// The top cells, in the order of the file.
        cells: Vec<String>,
    },
    /// The cell that was asked for is not in the file.
    #[error("{file}: there is no cell {name:?}; {}", known(.cells))]
    UnknownCell {
        /// The file.
        file: Box<str>,
        /// The name that was asked for.
        name: Box<str>,
        /// The cells of the file.
        cells: Vec<String>,
    },
    /// Two cells of a file have one name.
    #[error("{file}: a second cell {name:?} begins at byte {offset}")]
    DuplicateCell {
        /// The file.
        file: Box<str>,
        /// The name.
        name: Box<str>,
        /// Where the second one begins.
        offset: usize,
    },
    /// A cell contains itself, by way of other cells.
    #[error("{file}: cells place each other in a cycle: {}", quoted(.chain, " → "))]
    CyclicCells {
        /// The file.
        file: Box<str>,
        /// The cells, the first one repeated at the end.
        chain: Vec<String>,
    },
    /// Cells are nested deeper than any layout is.
    #[error("{file}: cell {cell:?} is nested deeper than {most} levels")]
    TooDeep {
        /// The file.
        file: Box<str>,
        /// The cell.
        cell: Box<str>,
        /// The limit.
        most: usize,
    },
    /// The scene graph refused what was to be built or described.
    #[error("{place}")]
    Device {
        /// The file, or the cell.
        place: Box<str>,
        /// What it said.
        source: Box<phidl_core::Error>,
    },
}

/// An element of a cell, as errors name it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum Item {
    /// A polygon.
    Polygon {
        /// Its place among the polygons of the cell, from 0.
        index: usize,
        /// Where it is drawn.
        layer: Layer,
    },
    /// A reference or an array.
    Reference {
        /// Its place among the references of the cell, from 0.
        index: usize,
        /// The cell that it places.
        child: String,
    },
    /// A path.
    Path {
        /// Its index among the paths of the cell, from 0.
        index: usize,
        /// Layer and datatype.
        layer: Layer,
    },
    /// A label.
    Label {
        /// Its place among the labels of the cell, from 0.
        index: usize,
        /// What it says.
        text: String,
    },
}

impl std::fmt::Display for Item {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Polygon { index, layer } => write!(f, "polygon {index} on {layer}"),
            Self::Path { index, layer } => write!(f, "path {index} on {layer}"),
            Self::Reference { index, child } => write!(f, "reference {index} to {child:?}"),
            Self::Label { index, text } => write!(f, "label {index} {:?}", shortened(text)),
        }
    }
}

impl IoError {
    /// The whole chain in one line: the file or cell first, the cause last.
    #[must_use]
    pub fn report(&self) -> String {
        match self {
            Self::File { source, .. } => format!("{self}: {source}"),
            Self::Device { source, .. } => format!("{self}: {}", source.report()),
            Self::Area { source, .. } => format!("{self}: {source}"),
            other => other.to_string(),
        }
    }

    pub(crate) fn file(path: &Path, action: &'static str, source: std::io::Error) -> Self {
        Self::File { path: path.display().to_string().into(), action, source: Arc::new(source) }
    }

    pub(crate) fn option(option: &'static str, value: impl std::fmt::Display, rule: impl Into<Box<str>>) -> Self {
        Self::Option { option, value: value.to_string().into(), rule: rule.into() }
    }
}

/// The beginning of a text, as much as an error shows.
fn shortened(text: &str) -> String {
    const SHOWN: usize = 40;
    let start: String = text.chars().take(SHOWN).collect();
    if start.len() < text.len() { start + "…" } else { start }
}

/// A real number as people write it: without an exponent where that is short.
pub(crate) fn real(v: f64) -> String {
    let is_short = v == 0.0 || (1e-4..1e9).contains(&v.abs()) || !v.is_finite();
    if is_short { v.to_string() } else { format!("{v:e}") }
}

/// A count; the largest number stands for all that are larger.
fn number(count: u64) -> String {
    if count == u64::MAX { "more than 10¹⁹".to_owned() } else { count.to_string() }
}

fn collapsed_polygons(count: u64) -> String {
    match count {
        0 => String::new(),
        1 => ": its only polygon encloses nothing on the grid".to_owned(),
        _ => format!(": its {count} polygons enclose nothing on the grid"),
    }
}

fn in_cell(cell: Option<&str>) -> String {
    cell.map_or_else(String::new, |cell| format!(" in cell {cell:?}"))
}

/// The most names that an error lists.
const MOST_NAMES: usize = 20;

/// Names in quotes, so that control characters of a file do not reach a terminal.
fn quoted(names: &[String], separator: &str) -> String {
    let mut list: Vec<String> = names.iter().take(MOST_NAMES).map(|name| format!("{name:?}")).collect();
    if names.len() > MOST_NAMES {
        list.push(format!("… ({} in all)", names.len()));
    }
    list.join(separator)
}

fn known(cells: &[String]) -> String {
    if cells.is_empty() { "the file has no cells".to_owned() } else { format!("its cells are {}", quoted(cells, ", ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_can_be_shared() {
        fn assert_shared<T: Clone + Send + Sync + std::error::Error>() {}
        assert_shared::<IoError>();
    }
}
