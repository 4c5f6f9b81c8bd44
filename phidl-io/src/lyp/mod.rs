//! KLayout's layer properties (LYP), read and written: colors, patterns, groups and visibility of layers.
//!
//! A file is kept whole: what is read is written again with the same meaning. [`Lyp::from_layers`] and
//! [`Lyp::to_layers`] lead to a [`LayerSet`](phidl_core::layer::LayerSet) and back. Two properties of a layer set are not
//! in the format: the opacity (only whether a layer is transparent) and whether a layer is inverted.
//!
//! XML is read by roxmltree, which keeps positions and refuses document types; it is written here, since that is forty
//! lines.

mod parse;
mod print;
mod set;
mod source;
mod style;

use std::fs;
use std::path::Path;

use crate::atomic;
use crate::error::{IoError, Result};

pub use set::{LypLayers, LypNames, LypProblem, parts};
pub use source::{Source, SourceLayer};
pub use style::{LineStyle, Pattern, brightened};

/// Groups are not nested deeper than this.
pub(crate) const MOST_LEVELS: usize = 64;

/// A file of layer properties.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Lyp {
    /// The views of the layer list; most files have one.
    pub tabs: Vec<View>,
    /// Elements of the file that mean nothing here, and were left out.
    pub unknown: Vec<UnknownElement>,
}

/// An element of a file that means nothing here.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnknownElement {
    /// Its line, from 1.
    pub line: u32,
    /// Its column, from 1.
    pub column: u32,
    /// Its name.
    pub name: String,
}

/// One list of layers, with the patterns that it defines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct View {
    /// The name of the tab; most files have none.
    pub name: String,
    /// The layers and groups, in the order of drawing: the first one lowest.
    pub layers: Vec<LayerView>,
    /// Fill patterns, which `C0`, `C1`, … refer to.
    pub patterns: Vec<CustomPattern>,
    /// Line styles, which `C0`, `C1`, … refer to.
    pub lines: Vec<CustomLine>,
}

/// How a layer or a group of layers looks.
#[derive(Debug, Clone, PartialEq)]
pub struct LayerView {
    /// The name; if it is empty, KLayout shows the source.
    pub name: String,
    /// Which layers of a file are shown.
    pub source: Source,
    /// Whether a group is shown open.
    pub expanded: bool,
    /// The color of outlines; without one, that of the group.
    pub frame_color: Option<phidl_core::layer::Color>,
    /// The color of areas; without one, that of the group.
    pub fill_color: Option<phidl_core::layer::Color>,
    /// How much brighter outlines are, from −255 to 255.
    pub frame_brightness: i16,
    /// How much brighter areas are, from −255 to 255.
    pub fill_brightness: i16,
    /// The fill pattern; without one, that of the group.
    pub pattern: Option<Pattern>,
    /// The line style; without one, a solid line.
    pub line_style: Option<LineStyle>,
    /// Whether the layer takes part at all.
    pub valid: bool,
    /// Whether it is shown.
    pub visible: bool,
    /// Whether what lies below shines through.
    pub transparent: bool,
    /// Width of outlines (pixels); 1 if none is given.
    pub width: Option<u32>,
    /// Whether vertices are marked.
    pub marked: bool,
    /// Whether boxes have a cross.
    pub xfill: bool,
    /// 0 none, 1 scrolling, 2 and 3 blinking.
    pub animation: u8,
    /// The layers of a group.
    pub members: Vec<Self>,
}

impl Default for LayerView {
    fn default() -> Self {
        Self {
            name: String::new(),
            source: Source::default(),
            expanded: false,
            frame_color: None,
            fill_color: None,
            frame_brightness: 0,
            fill_brightness: 0,
            pattern: None,
            line_style: None,
            valid: true,
            visible: true,
            transparent: false,
            width: None,
            marked: false,
            xfill: false,
            animation: 0,
            members: Vec::new(),
        }
    }
}

/// A fill pattern of a file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CustomPattern {
    /// Up to 32 rows of up to 32 pixels: `*` is drawn, `.` is not.
    pub rows: Vec<String>,
    /// Its position in lists of patterns.
    pub order: u32,
    /// Its name.
    pub name: String,
}

/// A line style of a file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CustomLine {
    /// Up to 32 pixels along the line: `*` is drawn, `.` is not.
    pub pattern: String,
    /// Its position in lists of line styles.
    pub order: u32,
    /// Its name.
    pub name: String,
}

/// Reads a file of layer properties.
///
/// # Errors
/// [`IoError::File`]; [`IoError::Xml`] with line and column.
pub fn read(path: impl AsRef<Path>) -> Result<Lyp> {
    let path = path.as_ref();
    let bytes = fs::read(path).map_err(|error| IoError::file(path, "read it", error))?;
    let file = path.display().to_string();
    let text = String::from_utf8(bytes).map_err(|_| IoError::Xml {
        file: file.as_str().into(),
        line: 1,
        column: 1,
        problem: "the file is not UTF-8".into(),
    })?;
    parse::parse(&text, &file)
}

/// Reads layer properties from a text, as [`read`] does.
///
/// # Errors
/// As for [`read`], in the name of "this text".
pub fn from_str(text: &str) -> Result<Lyp> {
    parse::parse(text, "this text")
}

/// The text of a file.
#[must_use]
pub fn to_string(lyp: &Lyp) -> String {
    print::print(lyp)
}

/// Writes a file of layer properties.
///
/// ```
/// use phidl_core::layer::{LayerSet, NamedLayer};
/// use phidl_io::lyp::{self, Lyp, LypNames};
///
/// let mut set = LayerSet::new();
/// set.add(NamedLayer::new("nb", 5).color("gold".parse()?))?;
/// let text = lyp::to_string(&Lyp::from_layers(&set, LypNames::Plain)?);
/// assert_eq!(lyp::from_str(&text)?.to_layers().set.get("nb")?.layer, set.get("nb")?.layer);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IoError::File`].
pub fn write(lyp: &Lyp, path: impl AsRef<Path>) -> Result<u64> {
    atomic::write(path, print::print(lyp).as_bytes())
}
