//! The cells of a hierarchy as welding asks for them: found by box, children first.

use std::cell::{Cell, OnceCell};
use std::collections::HashMap;

use phidl_core::geom::{Point, Rect};
use phidl_core::layer::Layer;
use phidl_core::param::Value;
use phidl_core::place::Bounded;
use phidl_core::scene::{Device, Reference};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::options::WeldOptions;

/// A cell with as many elements is looked through this many times before a tree is made of it.
const LOOKS_WITHOUT_A_TREE: u32 = 64;
/// A cell with fewer elements is always looked through.
const ELEMENTS_WITHOUT_A_TREE: usize = 64;

/// All cells of a hierarchy, each after those that it places.
pub(super) struct Cells {
    pub(super) list: Vec<CellIndex>,
    numbers: HashMap<usize, usize>,
}

impl Cells {
    pub(super) fn of(top: &Device, options: &WeldOptions) -> Self {
        let mut cells = top.cells();
        cells.reverse();
        let numbers = cells.iter().enumerate().map(|(number, cell)| (cell.ptr_id(), number)).collect();
        let list = cells.into_iter().map(|cell| CellIndex::new(cell, options)).collect();
        Self { list, numbers }
    }

    /// The index in `list` of the cell that a reference places.
    pub(super) fn number(&self, device: &Device) -> usize {
        self.numbers[&device.ptr_id()]
    }

    pub(super) fn child(&self, reference: &Reference) -> &CellIndex {
        &self.list[self.number(reference.device())]
    }
}

/// One cell, with what is remembered of it.
pub(super) struct CellIndex {
    pub(super) device: Device,
    /// Whether the cell and all below it are never varied.
    pub(super) rigid: bool,
    boxes: OnceCell<Boxes>,
    layers: OnceCell<Vec<Layer>>,
    tree: OnceCell<RTree<GeomWithData<Rectangle<[f64; 2]>, usize>>>,
    looks: Cell<u32>,
}

/// Boxes of the polygons, then of the references; elements that draw nothing have none.
struct Boxes(Vec<Option<Rect>>);

/// An element of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Item {
    Polygon(usize),
    Reference(usize),
}

impl CellIndex {
    fn new(device: Device, options: &WeldOptions) -> Self {
        let marked = device.info().get("rigid") == Some(&Value::Bool(true));
        Self {
            rigid: marked || options.is_rigid(device.name()),
            device,
            boxes: OnceCell::new(),
            layers: OnceCell::new(),
            tree: OnceCell::new(),
            looks: Cell::new(0),
        }
    }

    /// The layers that the cell and all below it draw on, ascending.
    pub(super) fn layers(&self) -> &[Layer] {
        self.layers.get_or_init(|| self.device.layers())
    }

    fn boxes(&self) -> &[Option<Rect>] {
        let polygons = || self.device.polygons().map(|polygon| Rect::around(polygon.points.iter().copied()));
        let references = || self.device.references().iter().map(Bounded::bbox);
        &self.boxes.get_or_init(|| Boxes(polygons().chain(references()).collect())).0
    }

    pub(super) fn reference_box(&self, reference: usize) -> Option<Rect> {
        self.boxes()[self.device.polygons().len() + reference]
    }

    /// The elements whose boxes touch a box, in order.
    pub(super) fn near(&self, rect: &Rect) -> Vec<Item> {
        let polygons = self.device.polygons().len();
        let item = |index: usize| match index.checked_sub(polygons) {
            None => Item::Polygon(index),
            Some(reference) => Item::Reference(reference),
        };
        let boxes = self.boxes();
        self.looks.set(self.looks.get().saturating_add(1));
        if boxes.len() <= ELEMENTS_WITHOUT_A_TREE || self.looks.get() <= LOOKS_WITHOUT_A_TREE {
            let touching = boxes.iter().enumerate().filter(|(_, b)| b.is_some_and(|b| b.touches(rect)));
            return touching.map(|(index, _)| item(index)).collect();
        }
        let tree = self.tree.get_or_init(|| {
            let entry = |(index, b): (usize, &Option<Rect>)| {
                b.map(|b| GeomWithData::new(Rectangle::from_corners(corner(b.min), corner(b.max)), index))
            };
            RTree::bulk_load(boxes.iter().enumerate().filter_map(entry).collect())
        });
        let envelope = AABB::from_corners(corner(rect.min), corner(rect.max));
        let mut found: Vec<usize> = tree.locate_in_envelope_intersecting(&envelope).map(|entry| entry.data).collect();
        found.sort_unstable();
        found.into_iter().map(item).collect()
    }
}

fn corner(p: Point) -> [f64; 2] {
    [p.x, p.y]
}

/// The elements of a reference whose boxes touch a box, columns outside. An array is not walked: the lattice is solved.
pub(super) fn elements_near(reference: &Reference, rect: &Rect) -> Vec<(u32, u32)> {
    let Some(array) = reference.array() else { return vec![(0, 0)] };
    let first = Reference::new(reference.device().clone(), *reference.transform());
    let Some(first) = first.bbox() else { return Vec::new() };
    let (a, b) = (reference.placed_step(array.column_step), reference.placed_step(array.row_step));
    let range = lattice_range([a, b], [array.columns, array.rows], first, rect);
    let touches =
        |(column, row): &(u32, u32)| first.shifted(a * f64::from(*column) + b * f64::from(*row)).touches(rect);
    let columns = range[0].0..range[0].1;
    columns.flat_map(|column| (range[1].0..range[1].1).map(move |row| (column, row))).filter(touches).collect()
}

/// For each direction of a lattice, the indices from and up to which elements can touch a box.
fn lattice_range(steps: [Point; 2], counts: [u32; 2], first: Rect, rect: &Rect) -> [(u32, u32); 2] {
    let across = |v: Point| Point::new(-v.y, v.x);
    let degenerate = |v: Point| v == Point::ORIGIN;
    let [mut a, mut b] = steps;
    // One row has no direction of rows that matters: one at right angles makes the lattice solvable.
    if counts[1] == 1 || degenerate(b) {
        b = across(a);
    }
    if counts[0] == 1 || degenerate(a) {
        a = across(b);
    }
    let det = a.cross(b);
    if det == 0.0 || !det.is_finite() {
        return [(0, counts[0]), (0, counts[1])];
    }
    // Differences of the boxes' corners cover all shifts with which the boxes touch.
    let shifts = Rect::new(rect.min - first.max, rect.max - first.min).corners();
    let solved = shifts.map(|v| [v.cross(b) / det, a.cross(v) / det]);
    [0, 1].map(|axis| {
        let low = solved.iter().map(|s| s[axis]).fold(f64::INFINITY, f64::min).floor();
        let high = solved.iter().map(|s| s[axis]).fold(f64::NEG_INFINITY, f64::max).ceil() + 1.0;
        let most = f64::from(counts[axis]);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a count")]
        let range = (low.clamp(0.0, most) as u32, high.clamp(0.0, most) as u32);
        range
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::place::Movable;

    #[test]
    fn the_elements_near_a_box_are_those_of_a_walk() {
        let mut d = Device::builder("pad");
        d.add_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], 1).unwrap();
        let pad = d.build().unwrap();
        let arrays = [
            pad.array(20, 30, (5, 3)),
            pad.array(20, 30, (5, 3)).rotated(30),
            pad.array(20, 1, (-3, 0)).mirrored((0, 0), (1, 2)),
            pad.array(1, 7, (0, 2.5)),
            pad.array(3, 3, (0, 0)),
        ];
        for array in arrays {
            for step in 0..40 {
                let at = Point::new(f64::from(step * 7 % 100) - 20.0, f64::from(step * 11 % 90) - 10.0);
                let rect = Rect::new(at, at + Point::new(3.0, 2.0));
                let walked: Vec<(u32, u32)> = array.array().map_or(vec![(0, 0)], |a| a.cells().collect());
                let touching = |(column, row): &(u32, u32)| {
                    let one = Reference::new(pad.clone(), array.element(*column, *row));
                    one.bbox().is_some_and(|b| b.touches(&rect))
                };
                let walked: Vec<_> = walked.into_iter().filter(touching).collect();
                let mut found = elements_near(&array, &rect);
                found.retain(touching);
                assert_eq!(found, walked);
            }
        }
    }
}
