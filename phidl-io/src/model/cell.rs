//! [`Cell`]: the elements of one cell, by kind.

use super::element::{BoxElement, Node, Path, Placement, Text};
use super::{CellId, Date, Polygons};

/// A cell of a [`Layout`](super::Layout).
#[derive(Debug, Clone)]
pub struct Cell {
    /// Its name.
    pub name: CellId,
    /// When it was last modified, as the file states it.
    pub modified: Option<Date>,
    /// Where it begins in the file (bytes).
    pub offset: usize,
    /// Polygons: BOUNDARY elements of GDSII; RECTANGLE, POLYGON and the like of OASIS.
    pub polygons: Polygons,
    /// Paths.
    pub paths: Vec<Path>,
    /// BOX elements of GDSII.
    pub boxes: Vec<BoxElement>,
    /// NODE elements of GDSII: electrical nets, which are not drawn.
    pub nodes: Vec<Node>,
    /// Texts.
    pub texts: Vec<Text>,
    /// References to cells, single and arrays.
    pub placements: Vec<Placement>,
}

impl Cell {
    /// A cell without elements.
    #[must_use]
    pub fn new(name: CellId) -> Self {
        Self {
            name,
            modified: None,
            offset: 0,
            polygons: Polygons::default(),
            paths: Vec::new(),
            boxes: Vec::new(),
            nodes: Vec::new(),
            texts: Vec::new(),
            placements: Vec::new(),
        }
    }

    /// Removes all elements and keeps their memory, so that one buffer serves all cells of a file in turn.
    pub(crate) fn reset(&mut self, name: CellId) {
        let Self { polygons, paths, boxes, nodes, texts, placements, .. } = self;
        polygons.clear();
        paths.clear();
        boxes.clear();
        nodes.clear();
        texts.clear();
        placements.clear();
        (self.name, self.modified, self.offset) = (name, None, 0);
    }
}
