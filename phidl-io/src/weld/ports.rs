//! Free ports of a cell: its own, and those of its references that no joint has used.
//!
//! An array is not unrolled. Its ports are one port and a lattice; where a port meets a lattice, two linear equations say
//! which element it meets.

use phidl_core::geom::{Point, Transform};
use phidl_core::port::Port;
use phidl_core::scene::{Device, Reference};

/// Arrays of arrays are unrolled up to this many elements of the outer one; beyond it, inner ports are not followed.
const MOST_UNROLLED: usize = 1 << 16;

/// A port that can still meet another one, in the frame of a cell.
#[derive(Debug, Clone)]
pub(super) struct FreePort {
    pub(super) midpoint: Point,
    pub(super) width: f64,
    /// Degrees.
    pub(super) orientation: f64,
    /// The port repeats on a lattice.
    pub(super) lattice: Option<Lattice>,
    /// The reference whose port it is, with the index of the port among the free ones of the placed cell; none for the
    /// cell's own ports, whose index counts on.
    pub(super) owner: Owner,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    Own(usize),
    Reference { reference: usize, free: usize },
}

/// A regular set of positions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lattice {
    pub(super) steps: [Point; 2],
    pub(super) counts: [u32; 2],
    /// Whether its elements are those of the reference itself, and not of an array below it.
    pub(super) of_reference: bool,
}

impl Lattice {
    pub(super) fn count(&self) -> u64 {
        u64::from(self.counts[0]) * u64::from(self.counts[1])
    }

    pub(super) fn shift(&self, (i, j): (u32, u32)) -> Point {
        self.steps[0] * f64::from(i) + self.steps[1] * f64::from(j)
    }

    /// The whole-numbered differences `(i, j)` of elements that lie a displacement apart, within `reach` µm.
    pub(super) fn solve(&self, displacement: Point, reach: f64) -> Option<(i64, i64)> {
        let [a, b] = self.steps;
        let (i, j) = match self.counts {
            [1, 1] => (0.0, 0.0),
            [_, 1] => (displacement.dot(a) / a.dot(a), 0.0),
            [1, _] => (0.0, displacement.dot(b) / b.dot(b)),
            _ => {
                let det = a.cross(b);
                (displacement.cross(b) / det, a.cross(displacement) / det)
            }
        };
        let (i, j) = (i.round(), j.round());
        let near = (a * i + b * j).distance(displacement) <= reach;
        #[expect(clippy::cast_possible_truncation, reason = "checked by the distance; counts have 32 bits")]
        let solved = (i as i64, j as i64);
        near.then_some(solved)
    }

    /// The element at a displacement from the first one.
    pub(super) fn element_at(&self, displacement: Point, reach: f64) -> Option<(u32, u32)> {
        let (i, j) = self.solve(displacement, reach)?;
        let inside = |index: i64, count: u32| u32::try_from(index).ok().filter(|index| *index < count);
        Some((inside(i, self.counts[0])?, inside(j, self.counts[1])?))
    }

    pub(super) fn elements(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let [columns, rows] = self.counts;
        (0..columns).flat_map(move |column| (0..rows).map(move |row| (column, row)))
    }

    fn placed(self, by: &Transform) -> Self {
        let steps = self.steps.map(|step| by.apply_vector(step));
        Self { steps, of_reference: false, ..self }
    }
}

impl FreePort {
    fn own(index: usize, port: &Port) -> Self {
        Self {
            midpoint: port.midpoint(),
            width: port.width(),
            orientation: port.orientation(),
            lattice: None,
            owner: Owner::Own(index),
        }
    }

    fn placed(&self, by: &Transform, reference: usize, free: usize) -> Self {
        Self {
            midpoint: by.apply(self.midpoint),
            width: self.width * by.magnification,
            orientation: by.apply_direction(self.orientation),
            lattice: self.lattice.map(|lattice| lattice.placed(by)),
            owner: Owner::Reference { reference, free },
        }
    }
}

/// The ports of a cell and of what it places: own ports first, then those of each reference.
pub(super) fn placed_ports<'f>(cell: &Device, free_of: impl Fn(&Reference) -> &'f [FreePort]) -> Vec<FreePort> {
    let mut ports: Vec<FreePort> = cell.ports().enumerate().map(|(index, port)| FreePort::own(index, port)).collect();
    for (index, reference) in cell.references().iter().enumerate() {
        for (free, port) in free_of(reference).iter().enumerate() {
            match (reference.array(), port.lattice) {
                (None, _) => ports.push(port.placed(reference.transform(), index, free)),
                (Some(array), None) => {
                    let lattice = Lattice {
                        steps: [array.column_step, array.row_step].map(|step| reference.placed_step(step)),
                        counts: [array.columns, array.rows],
                        of_reference: true,
                    };
                    let first = port.placed(reference.transform(), index, free);
                    ports.push(FreePort { lattice: Some(lattice), ..first });
                }
                (Some(array), Some(_)) if array.count() <= MOST_UNROLLED => {
                    ports.extend(reference.elements().map(|element| port.placed(&element, index, free)));
                }
                (Some(_), Some(_)) => {}
            }
        }
    }
    ports
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lattice_finds_the_element_at_a_place() {
        let lattice =
            Lattice { steps: [Point::new(3.0, 1.0), Point::new(-1.0, 2.0)], counts: [5, 4], of_reference: true };
        for element in lattice.elements() {
            assert_eq!(lattice.element_at(lattice.shift(element), 1e-6), Some(element));
            assert_eq!(lattice.element_at(lattice.shift(element) + Point::new(0.1, 0.0), 1e-6), None);
        }
        assert_eq!(lattice.element_at(Point::new(15.0, 5.0), 1e-6), None, "beyond the last column");
        let row = Lattice { counts: [9, 1], ..lattice };
        assert_eq!(row.element_at(Point::new(6.0, 2.0), 1e-6), Some((2, 0)));
        assert_eq!(row.element_at(Point::new(-1.0, 2.0), 1e-6), None);
    }
}
