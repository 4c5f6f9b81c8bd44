//! Bounding boxes of cells, where they are exact: a cell with something at an odd angle below it has none.

use super::super::encode;
use crate::model::{Cell, Layout};

/// A bounding box, or none for a cell that draws nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Extent(Option<[[i64; 2]; 2]>);

impl Extent {
    fn add(&mut self, at: [i64; 2]) {
        let [min, max] = self.0.get_or_insert([at, at]);
        for ((min, max), at) in min.iter_mut().zip(max).zip(at) {
            (*min, *max) = ((*min).min(at), (*max).max(at));
        }
    }

    /// The five values of the property S_BOUNDING_BOX, each with its type.
    pub(super) fn write(self, out: &mut Vec<u8>) {
        let [min, max] = self.0.unwrap_or([[0, 0], [0, 0]]);
        out.extend_from_slice(&[8, if self.0.is_none() { 2 } else { 0 }]);
        for value in min {
            out.push(9);
            encode::signed(value, out);
        }
        for (min, max) in min.into_iter().zip(max) {
            out.push(8);
            encode::unsigned(max.abs_diff(min), out);
        }
    }
}

/// The boxes of all cells, in their order; `None` where one is not exact.
pub(super) fn of(layout: &Layout) -> Vec<Option<Extent>> {
    let definitions = layout.definitions();
    let mut boxes: Vec<Option<Extent>> = vec![None; layout.cells.len()];
    let mut done = vec![false; layout.cells.len()];
    // Cells mostly stand after those that they place; what does not is looked at again, and cycles are left.
    loop {
        let mut changed = false;
        for (index, cell) in layout.cells.iter().enumerate() {
            let child = |placement: &crate::model::Placement| definitions[placement.child.index()];
            let ready = cell.placements.iter().all(|placement| child(placement).is_none_or(|child| done[child]));
            if !done[index] && ready {
                boxes[index] = extent(cell, &definitions, &boxes);
                (done[index], changed) = (true, true);
            }
        }
        if !changed {
            return boxes;
        }
    }
}

fn extent(cell: &Cell, definitions: &[Option<usize>], boxes: &[Option<Extent>]) -> Option<Extent> {
    let mut extent = Extent(None);
    let whole = |corner: &[i32; 2]| corner.map(i64::from);
    cell.polygons.iter().flat_map(|polygon| polygon.corners).for_each(|corner| extent.add(whole(corner)));
    cell.boxes.iter().flat_map(|element| &element.corners).for_each(|corner| extent.add(whole(corner)));
    cell.texts.iter().for_each(|text| extent.add(whole(&text.origin)));
    if !cell.paths.is_empty() {
        return None;
    }
    for placement in &cell.placements {
        let Some(child) = definitions[placement.child.index()] else { continue };
        let quarters = [0.0, 90.0, 180.0, 270.0].iter().position(|quarter| *quarter == placement.rotation)?;
        if placement.magnification != 1.0 {
            return None;
        }
        let Some(corners) = boxes[child]?.0 else { continue };
        let (columns, rows) = placement.lattice.as_ref().map_or((1, 1), |l| (i64::from(l.columns), i64::from(l.rows)));
        for corner in corners {
            let [x, mut y] = corner;
            if placement.x_reflection {
                y = -y;
            }
            let turned = match quarters {
                0 => [x, y],
                1 => [-y, x],
                2 => [-x, -y],
                _ => [y, -x],
            };
            for (column, row) in [(0, 0), (columns - 1, 0), (0, rows - 1), (columns - 1, rows - 1)] {
                let at = [0, 1].map(|axis| {
                    let along = |extent: [i64; 2], number: i64, count: i64| extent[axis] / count * number;
                    let moved = placement
                        .lattice
                        .as_ref()
                        .map_or(0, |l| along(l.column_extent, column, columns) + along(l.row_extent, row, rows));
                    i64::from(placement.origin[axis]) + turned[axis] + moved
                });
                extent.add(at);
            }
        }
    }
    Some(extent)
}
