//! A file into devices: the second half of reading, which follows the names of references.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use phidl_core::scene::{Device, Reference};

use super::library::{self, Library, OpenCell};
use super::problem::Problem;
use super::single::Placement;
use crate::error::{IoError, Result};

/// Cells are not nested deeper than this; real layouts have some ten levels. Whoever walks a device may then do so level
/// by level on the stack.
const MOST_LEVELS: usize = 256;

/// What the reader can be told.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ReadOptions {
    /// The cell to read, whether or not others place it. Without a name, the only top cell of the file.
    pub cellname: Option<String>,
}

/// What a file holds.
#[derive(Debug, Clone)]
pub struct Import {
    /// The chosen cell with all that it places. Cells keep their names; one that is placed often is one device.
    pub device: Device,
    /// What was left out or read as something else, in the order of the file.
    pub problems: Vec<Problem>,
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
/// ports and no generator.
///
/// # Errors
/// [`IoError::File`]; [`IoError::Malformed`] with byte and cell; [`IoError::NoTopCell`] and
/// [`IoError::SeveralTopCells`] if a name is needed, [`IoError::UnknownCell`] if it is not there;
/// [`IoError::DuplicateCell`], [`IoError::MissingCell`], [`IoError::Circle`], [`IoError::TooDeep`].
pub fn read(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Import> {
    let path = path.as_ref();
    let bytes = fs::read(path).map_err(|error| IoError::file(path, "read it", error))?;
    import(&bytes, &path.display().to_string(), options)
}

/// Reads the bytes of a GDSII file, as [`read()`] does.
///
/// # Errors
/// As for [`read()`], in the name of "these bytes".
pub fn read_bytes(bytes: &[u8], options: &ReadOptions) -> Result<Import> {
    import(bytes, "these bytes", options)
}

fn import(bytes: &[u8], file: &str, options: &ReadOptions) -> Result<Import> {
    let Library { name, grid, user_unit, cells, problems } = library::parse(bytes, file)?;
    let children = children(&cells);
    let top = choose(&cells, &children, file, options)?;
    let order = Order { file, cells: &cells, children: &children }.below(top)?;
    let device = build(cells, &children, &order, file)?;
    Ok(Import { device, problems, library_name: name, grid: grid.step(), user_unit })
}

/// For each cell, the places of the cells that its references name; `None` for names that are not in the file.
fn children(cells: &[OpenCell]) -> Vec<Vec<Option<usize>>> {
    let names: HashMap<&str, usize> = cells.iter().enumerate().map(|(i, cell)| (cell.name.as_str(), i)).collect();
    let of = |cell: &OpenCell| cell.references.iter().map(|p| names.get(p.child.as_str()).copied()).collect();
    cells.iter().map(of).collect()
}

/// The cell that was asked for, or the only one that no other places.
fn choose(cells: &[OpenCell], children: &[Vec<Option<usize>>], file: &str, options: &ReadOptions) -> Result<usize> {
    let known = || cells.iter().map(|cell| cell.name.clone()).collect();
    if let Some(name) = &options.cellname {
        let unknown = || IoError::UnknownCell { file: file.into(), name: name.as_str().into(), cells: known() };
        return cells.iter().position(|cell| cell.name == *name).ok_or_else(unknown);
    }
    let mut placed = vec![false; cells.len()];
    for child in children.iter().flatten().flatten() {
        placed[*child] = true;
    }
    let tops: Vec<usize> = (0..cells.len()).filter(|cell| !placed[*cell]).collect();
    match tops[..] {
        [top] => Ok(top),
        [] => Err(IoError::NoTopCell { file: file.into(), cells: known() }),
        _ => {
            let cells = tops.iter().map(|top| cells[*top].name.clone()).collect();
            Err(IoError::SeveralTopCells { file: file.into(), cells })
        }
    }
}

/// Finds the order in which cells can be finished.
struct Order<'a> {
    file: &'a str,
    cells: &'a [OpenCell],
    children: &'a [Vec<Option<usize>>],
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    /// Its children are being looked at.
    Open,
    /// Finished, with so many levels below it.
    Done(usize),
}

impl Order<'_> {
    /// The cells below a cell and itself, children first. An explicit stack: a file may nest cells as deep as it likes.
    fn below(&self, top: usize) -> Result<Vec<usize>> {
        let mut states = vec![State::New; self.cells.len()];
        let mut order = Vec::new();
        let mut stack = vec![(top, 0)];
        states[top] = State::Open;
        while let Some((cell, next)) = stack.pop() {
            let Some(child) = self.children[cell].get(next) else {
                states[cell] = State::Done(self.levels(cell, &states)?);
                order.push(cell);
                continue;
            };
            stack.push((cell, next + 1));
            let child = child.ok_or_else(|| self.missing(cell, &self.cells[cell].references[next]))?;
            match states[child] {
                State::Done(_) => {}
                State::Open => return Err(self.circle(child, &stack)),
                State::New => {
                    states[child] = State::Open;
                    stack.push((child, 0));
                }
            }
        }
        Ok(order)
    }

    fn missing(&self, cell: usize, placement: &Placement) -> IoError {
        IoError::MissingCell {
            file: self.file.into(),
            cell: self.cells[cell].name.as_str().into(),
            missing: placement.child.as_str().into(),
            offset: placement.offset,
        }
    }

    fn levels(&self, cell: usize, states: &[State]) -> Result<usize> {
        let below = self.children[cell]
            .iter()
            .flatten()
            .map(|child| if let State::Done(levels) = states[*child] { levels + 1 } else { 0 });
        match below.max().unwrap_or(0) {
            levels if levels < MOST_LEVELS => Ok(levels),
            _ => Err(IoError::TooDeep {
                file: self.file.into(),
                cell: self.cells[cell].name.as_str().into(),
                most: MOST_LEVELS,
            }),
        }
    }

    fn circle(&self, child: usize, stack: &[(usize, usize)]) -> IoError {
        let way = stack.iter().map(|(cell, _)| *cell).skip_while(|cell| *cell != child);
        let chain = way.chain([child]).map(|cell| self.cells[cell].name.clone()).collect();
        IoError::Circle { file: self.file.into(), chain }
    }
}

/// Builds the cells in their order; the last is the one that was asked for.
fn build(cells: Vec<OpenCell>, children: &[Vec<Option<usize>>], order: &[usize], file: &str) -> Result<Device> {
    let mut open: Vec<Option<OpenCell>> = cells.into_iter().map(Some).collect();
    let mut devices: Vec<Option<Device>> = vec![None; open.len()];
    let mut last = None;
    for place in order {
        let cell = open[*place].take().expect("invariant: a cell comes once in the order");
        let OpenCell { name, mut builder, outlines, references } = cell;
        for polygon in outlines {
            builder.add(polygon);
        }
        for (placement, child) in references.into_iter().zip(&children[*place]) {
            let child = child.and_then(|child| devices[child].as_ref());
            builder.add(reference(child.expect("invariant: children come first in the order"), placement));
        }
        let device = builder.build().map_err(|source| IoError::Device {
            place: format!("{file}: cell \"{name}\"").into(),
            source: Box::new(source),
        })?;
        last = Some(device.clone());
        devices[*place] = Some(device);
    }
    Ok(last.expect("invariant: the order ends with the cell that was asked for"))
}

fn reference(child: &Device, placement: Placement) -> Reference {
    let Placement { transform, array, properties, .. } = placement;
    let mut reference = Reference::new(child.clone(), transform);
    if let Some(array) = array {
        reference = reference.with_array(array);
    }
    reference.properties = properties;
    reference
}
