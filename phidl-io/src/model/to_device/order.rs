//! The order in which cells can be built: children before parents.

use crate::error::{IoError, Result};
use crate::model::{CellId, Layout};

/// Cells are not nested deeper than this. Real layouts have some ten levels.
const MOST_LEVELS: usize = 256;

/// The cell of a name, or the only top cell.
///
/// # Errors
/// [`IoError::UnknownCell`], [`IoError::NoTopCell`], [`IoError::SeveralTopCells`].
pub(crate) fn choose(layout: &Layout, file: &str, cellname: Option<&str>) -> Result<usize> {
    let names = |cells: &[usize]| cells.iter().map(|cell| name_of(layout, *cell)).collect();
    let all: Vec<usize> = (0..layout.cells.len()).collect();
    if let Some(name) = cellname {
        let cell = layout.names.find(name).and_then(|id| layout.definitions()[id.index()]);
        return cell.ok_or_else(|| IoError::UnknownCell { file: file.into(), name: name.into(), cells: names(&all) });
    }
    match layout.tops()[..] {
        [top] => Ok(top),
        [] => Err(IoError::NoTopCell { file: file.into(), cells: names(&all) }),
        ref tops => Err(IoError::SeveralTopCells { file: file.into(), cells: names(tops) }),
    }
}

fn name_of(layout: &Layout, cell: usize) -> String {
    layout.names.name(layout.cells[cell].name).to_owned()
}

/// Finds the order of the cells of a layout.
pub(crate) struct Order<'a> {
    pub(crate) file: &'a str,
    pub(crate) layout: &'a Layout,
    /// The index of the cell of each name.
    definitions: Vec<Option<usize>>,
    states: Vec<State>,
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    /// Its children are being looked at.
    Open,
    /// Finished, with this many levels below it.
    Done(usize),
}

impl<'a> Order<'a> {
    pub(crate) fn new(layout: &'a Layout, file: &'a str) -> Self {
        Self { file, layout, definitions: layout.definitions(), states: vec![State::New; layout.cells.len()] }
    }

    /// The cells below a cell and itself that are not in the order yet, children first. An explicit stack: a file may nest
    /// cells as deep as it likes.
    pub(crate) fn below(&mut self, top: usize) -> Result<Vec<usize>> {
        let mut order = Vec::new();
        if self.states[top] != State::New {
            return Ok(order);
        }
        let mut stack = vec![(top, 0)];
        self.states[top] = State::Open;
        while let Some((cell, next)) = stack.pop() {
            let Some(placement) = self.layout.cells[cell].placements.get(next) else {
                self.states[cell] = State::Done(self.levels(cell)?);
                order.push(cell);
                continue;
            };
            stack.push((cell, next + 1));
            let Some(child) = self.definition(placement.child) else { continue };
            match self.states[child] {
                State::Done(_) => {}
                State::Open => return Err(self.cycle(child, &stack)),
                State::New => {
                    self.states[child] = State::Open;
                    stack.push((child, 0));
                }
            }
        }
        Ok(order)
    }

    fn definition(&self, name: CellId) -> Option<usize> {
        self.definitions[name.index()]
    }

    fn levels(&self, cell: usize) -> Result<usize> {
        let children = self.layout.cells[cell].placements.iter().filter_map(|p| self.definition(p.child));
        let below = children.map(|child| if let State::Done(levels) = self.states[child] { levels + 1 } else { 0 });
        match below.max().unwrap_or(0) {
            levels if levels < MOST_LEVELS => Ok(levels),
            _ => Err(IoError::TooDeep {
                file: self.file.into(),
                cell: name_of(self.layout, cell).into(),
                most: MOST_LEVELS,
            }),
        }
    }

    fn cycle(&self, child: usize, stack: &[(usize, usize)]) -> IoError {
        let chain = stack.iter().map(|(cell, _)| *cell).skip_while(|cell| *cell != child);
        let chain = chain.chain([child]).map(|cell| name_of(self.layout, cell)).collect();
        IoError::CyclicCells { file: self.file.into(), chain }
    }
}
