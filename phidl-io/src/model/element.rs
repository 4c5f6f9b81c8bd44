//! The elements of a cell, polygons aside.

use phidl_core::layer::Layer;
use phidl_core::scene::{Anchor, Properties};

use super::{CellId, Corner};

/// A centerline with a width.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// Layer and datatype.
    pub layer: Layer,
    /// The points of the centerline.
    pub points: Vec<Corner>,
    /// The width in grid steps, not negative.
    pub width: i64,
    /// Whether the width is not magnified with the cell (a negative WIDTH of GDSII).
    pub fixed_width: bool,
    /// How the path begins.
    pub start: PathEnd,
    /// How the path ends.
    pub end: PathEnd,
    /// Attributes and texts.
    pub properties: Properties,
    /// Where it begins in the file (bytes).
    pub offset: usize,
}

/// The shape of a path's end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PathEnd {
    /// Straight across the end point.
    #[default]
    Flush,
    /// A half circle about the end point.
    Round,
    /// Straight, half the width beyond the end point.
    Square,
    /// Straight, this many grid steps beyond the end point; negative: before it.
    Extended(i64),
}

/// A BOX element of GDSII: a rectangle that some tools use for regions instead of drawings.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxElement {
    /// Layer and boxtype.
    pub layer: Layer,
    /// The corners, the first one not repeated.
    pub corners: Vec<Corner>,
    /// Attributes and texts.
    pub properties: Properties,
    /// Where it begins in the file (bytes).
    pub offset: usize,
}

/// A NODE element of GDSII: an electrical net. It is not drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Layer and nodetype.
    pub layer: Layer,
    /// Its points.
    pub points: Vec<Corner>,
    /// Attributes and texts.
    pub properties: Properties,
    /// Where it begins in the file (bytes).
    pub offset: usize,
}

/// A text.
#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    /// Layer and texttype.
    pub layer: Layer,
    /// What it says.
    pub string: String,
    /// Its position.
    pub origin: Corner,
    /// Whether it is mirrored about the x axis first.
    pub x_reflection: bool,
    /// The magnification, if the file states one.
    pub magnification: Option<f64>,
    /// The rotation (degrees, counter-clockwise).
    pub rotation: f64,
    /// The point of the text that stands at the position, if the file states one. The default of GDSII is north-west.
    pub anchor: Option<Anchor>,
    /// The font, 0 to 3.
    pub font: u8,
    /// PATHTYPE of GDSII, which texts may have.
    pub path_type: Option<i16>,
    /// WIDTH of GDSII, the width of the strokes (steps; negative: not magnified with the cell).
    pub width: Option<i32>,
    /// Attributes and texts.
    pub properties: Properties,
    /// Where it begins in the file (bytes).
    pub offset: usize,
}

/// A reference to a cell: one, or a regular array.
#[derive(Debug, Clone, PartialEq)]
pub struct Placement {
    /// The cell.
    pub child: CellId,
    /// The position of the cell's origin; of an array, that of the first element.
    pub origin: Corner,
    /// Whether the cell is mirrored about the x axis first.
    pub x_reflection: bool,
    /// The magnification, greater than 0.
    pub magnification: f64,
    /// The rotation (degrees, counter-clockwise).
    pub rotation: f64,
    /// The lattice of an array.
    pub lattice: Option<Box<Lattice>>,
    /// Attributes and texts; few references have any.
    pub properties: Option<Box<Properties>>,
    /// Where it begins in the file (bytes).
    pub offset: usize,
}

impl Placement {
    /// A placement at the origin.
    #[must_use]
    pub fn new(child: CellId) -> Self {
        Self {
            child,
            origin: [0, 0],
            x_reflection: false,
            magnification: 1.0,
            rotation: 0.0,
            lattice: None,
            properties: None,
            offset: 0,
        }
    }
}

/// The lattice of an array, in the frame of the parent: it is neither turned nor magnified with the cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lattice {
    /// How many columns, at least 1.
    pub columns: u32,
    /// How many rows, at least 1.
    pub rows: u32,
    /// `columns` column steps, from the first element (grid steps). One step need not be whole.
    pub column_extent: [i64; 2],
    /// `rows` row steps, from the first element (grid steps). One step need not be whole.
    pub row_extent: [i64; 2],
}
