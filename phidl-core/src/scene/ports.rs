//! [`Device::ports_recursive`]: the ports of a whole hierarchy.

use std::collections::HashMap;

use super::flat_counts::{FlatCounts, check_count};
use super::{Device, Reference};
use crate::error::{Error, Result};
use crate::geom::Transform;
use crate::place::Transformable;
use crate::port::Port;

/// The largest number of ports in one list.
const MOST: u64 = 1 << 20;

impl Device {
    /// The ports of this cell and of what is placed below it, in the coordinates of this cell; `depth` 0 is this cell
    /// only, `None` has no limit.
    ///
    /// Those of an array come row by row, and their info has `array_idx`, row and column, of the outermost array.
    ///
    /// # Errors
    /// [`Error::TooLarge`] beyond 2²⁰ ports.
    pub fn ports_recursive(&self, depth: Option<usize>) -> Result<Vec<Port>> {
        let counts = FlatCounts::of_cells(self);
        if depth.is_none() {
            check_count(self.name(), "ports", counts[&self.ptr_id()].ports, MOST)?;
        }
        let mut ports = Vec::new();
        // One frame per level of the hierarchy, the innermost last.
        let mut frames = vec![Frame::new(self, Transform::IDENTITY, None)];
        frames[0].append_ports(&mut ports);
        if depth == Some(0) {
            return Ok(ports);
        }
        while let Some(frame) = frames.last_mut() {
            let Some(child) = frame.next_child(&counts) else {
                frames.pop();
                continue;
            };
            child.append_ports(&mut ports);
            if ports.len() as u64 > MOST {
                return Err(Error::TooLarge { device: self.name().into(), what: "ports", count: None, limit: MOST });
            }
            if depth.is_none_or(|depth| frames.len() < depth) {
                frames.push(child);
            }
        }
        Ok(ports)
    }
}

struct Frame<'a> {
    device: &'a Device,
    transform: Transform,
    /// Row and column in the outermost array.
    array_index: Option<[u32; 2]>,
    reference: usize,
    /// The next element of the reference, row by row.
    row: u32,
    column: u32,
}

impl<'a> Frame<'a> {
    fn new(device: &'a Device, transform: Transform, array_index: Option<[u32; 2]>) -> Self {
        Self { device, transform, array_index, reference: 0, row: 0, column: 0 }
    }

    /// The next placed cell that has ports in it or below.
    fn next_child(&mut self, counts: &HashMap<usize, FlatCounts>) -> Option<Self> {
        loop {
            let reference: &'a Reference = self.device.references().get(self.reference)?;
            let (columns, rows) = reference.array().map_or((1, 1), |a| (a.columns, a.rows));
            let without_ports = counts[&reference.device().ptr_id()].ports == 0;
            if without_ports || self.row >= rows || columns == 0 {
                (self.reference, self.row, self.column) = (self.reference + 1, 0, 0);
                continue;
            }
            let (row, column) = (self.row, self.column);
            (self.row, self.column) = if column + 1 < columns { (row, column + 1) } else { (row + 1, 0) };
            let own = reference.array().map(|_| [row, column]);
            let transform = reference.element(column, row).then(&self.transform);
            return Some(Self::new(reference.device(), transform, self.array_index.or(own)));
        }
    }

    fn append_ports(&self, ports: &mut Vec<Port>) {
        ports.extend(self.device.ports().map(|port| {
            let mut port = match self.array_index {
                Some(index) => port.clone().with_info("array_idx", index),
                None => port.clone(),
            };
            port.transform_mut(&self.transform);
            port
        }));
    }
}
