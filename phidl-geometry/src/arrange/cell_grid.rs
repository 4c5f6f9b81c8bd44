//! Rows and columns: the geometry under [`grid`](fn@super::grid) and [`gridsweep`](fn@super::gridsweep).
//!
//! All positions follow from bounding boxes. A position without a cell, or with an empty one, has no box: it takes no room
//! and is ignored by alignment. (PHIDL gives it a box at the origin, which distorts grids that do not contain the origin.)

use phidl_core::prelude::*;
use phidl_macros::Choice;

use super::GridCells;

/// A vertical line of a box, to align columns or to space them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum EdgeX {
    /// The middle.
    #[default]
    X,
    /// The left edge.
    #[choice("xmin")]
    XMin,
    /// The right edge.
    #[choice("xmax")]
    XMax,
}

/// A horizontal line of a box, to align rows or to space them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum EdgeY {
    /// The middle.
    #[default]
    Y,
    /// The lower edge.
    #[choice("ymin")]
    YMin,
    /// The upper edge.
    #[choice("ymax")]
    YMax,
}

impl From<EdgeX> for Edge {
    fn from(edge: EdgeX) -> Self {
        match edge {
            EdgeX::X => Self::X,
            EdgeX::XMin => Self::XMin,
            EdgeX::XMax => Self::XMax,
        }
    }
}

impl From<EdgeY> for Edge {
    fn from(edge: EdgeY) -> Self {
        match edge {
            EdgeY::Y => Self::Y,
            EdgeY::YMin => Self::YMin,
            EdgeY::YMax => Self::YMax,
        }
    }
}

/// How the lines (rows or columns) of a lattice follow each other.
#[derive(Debug, Clone, Copy)]
pub(super) enum LineSpacing {
    /// The gap between the boxes of neighboring lines (µm).
    Gap(f64),
    /// The distance between the same edges of neighboring lines (µm).
    Pitch(Edge, f64),
}

/// Cells in rows and columns, row by row from the top left.
#[derive(Debug)]
pub(super) struct CellGrid {
    pub(super) columns: usize,
    cells: Vec<Reference>,
}

impl CellGrid {
    /// The cells at their own positions; missing cells become references to an empty cell.
    pub(super) fn new(list: GridCells, columns: usize, rows: usize) -> Result<Self> {
        let empty = Device::builder("free").build()?;
        let slots = match list {
            GridCells::Flat(slots) => slots,
            GridCells::Rows(rows) => rows.into_iter().flatten().collect(),
        };
        let mut cells: Vec<Reference> =
            slots.into_iter().map(|slot| slot.0.as_ref().unwrap_or(&empty).place()).collect();
        cells.resize(columns * rows, empty.place());
        Ok(Self { columns, cells })
    }

    /// Lines the cells of each row up, then those of each column.
    pub(super) fn align(&mut self, rows: Edge, columns: Edge) {
        for row in self.rows() {
            self.align_line(&row, rows);
        }
        for column in self.columns() {
            self.align_line(&column, columns);
        }
    }

    /// Spaces the columns out to the right, then the rows upwards from the bottom one.
    pub(super) fn distribute(&mut self, columns: LineSpacing, rows: LineSpacing) {
        self.distribute_lines(&self.columns(), Direction::X, columns);
        let upwards: Vec<_> = self.rows().into_iter().rev().collect();
        self.distribute_lines(&upwards, Direction::Y, rows);
    }

    /// The placed cells, row by row from the top left.
    pub(super) fn into_references(self) -> Vec<Reference> {
        self.cells
    }

    fn rows(&self) -> Vec<Vec<usize>> {
        let all: Vec<usize> = (0..self.cells.len()).collect();
        all.chunks(self.columns).map(<[usize]>::to_vec).collect()
    }

    fn columns(&self) -> Vec<Vec<usize>> {
        (0..self.columns).map(|column| (column..self.cells.len()).step_by(self.columns).collect()).collect()
    }

    fn line_box(&self, line: &[usize]) -> Option<Rect> {
        Rect::union_all(line.iter().map(|cell| self.cells[*cell].bbox()))
    }

    fn align_line(&mut self, line: &[usize], edge: Edge) {
        let Some(all) = self.line_box(line) else { return };
        for cell in line {
            if let Some(own) = self.cells[*cell].bbox() {
                self.cells[*cell].move_by(along(edge, edge.of(all) - edge.of(own)));
            }
        }
    }

    /// The first line that draws something stays where it is.
    fn distribute_lines(&mut self, lines: &[Vec<usize>], direction: Direction, follow: LineSpacing) {
        let lower = lower_edge(direction);
        let mut next = None;
        for (number, line) in lines.iter().enumerate() {
            let Some(own) = self.line_box(line) else { continue };
            let (edge, step) = match follow {
                LineSpacing::Gap(_) => (lower, 0.0),
                LineSpacing::Pitch(edge, pitch) => (edge, pitch * number as f64),
            };
            // A pitch counts from line 0, be it empty or not; gaps only count lines that draw something.
            let start = *next.get_or_insert(edge.of(own) - step);
            let by = start + step - edge.of(own);
            for cell in line.iter().filter(|cell| self.cells[**cell].bbox().is_some()).collect::<Vec<_>>() {
                self.cells[*cell].move_by(along(edge, by));
            }
            if let LineSpacing::Gap(gap) = follow {
                let extent = match direction {
                    Direction::X => own.size().width,
                    Direction::Y => own.size().height,
                };
                next = Some(start + extent + gap);
            }
        }
    }
}

fn lower_edge(direction: Direction) -> Edge {
    match direction {
        Direction::X => Edge::XMin,
        Direction::Y => Edge::YMin,
    }
}

/// A displacement in the direction in which an edge is measured.
fn along(edge: Edge, length: f64) -> Point {
    match edge {
        Edge::X | Edge::XMin | Edge::XMax => Point::new(length, 0.0),
        Edge::Y | Edge::YMin | Edge::YMax => Point::new(0.0, length),
    }
}
