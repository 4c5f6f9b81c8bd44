//! Polygons that are equal up to a shift, found by hash.

use std::collections::HashMap;

use phidl_core::layer::Layer;
use phidl_core::scene::Properties;
use rustc_hash::FxBuildHasher;

use super::options::Shapes;
use crate::model::{Corner, PolygonRef, Polygons};

/// Polygons of one shape on one layer with the same properties.
#[derive(Debug, Clone, Copy)]
pub(super) struct Group<'a> {
    pub(super) layer: Layer,
    pub(super) shape: Shape,
    pub(super) properties: Option<&'a Properties>,
    /// Another group with the same hash.
    next: Option<usize>,
}

/// A shape without its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// Width and height, from the lower left corner.
    Rectangle([u64; 2]),
    /// Corners of [`Groups::vectors`], from the first one.
    Polygon { start: usize, end: usize },
}

/// The polygons of a cell by shape.
#[derive(Debug, Default)]
pub(super) struct Groups<'a> {
    pub(super) groups: Vec<Group<'a>>,
    /// Corners of all shapes, each from the first one of its shape.
    pub(super) vectors: Vec<[i64; 2]>,
    /// For each polygon its group and position.
    items: Vec<(usize, Corner)>,
    /// Polygons that enclose nothing.
    pub(super) empty: u64,
}

impl<'a> Groups<'a> {
    /// Groups the polygons; without `merge`, each is a group of its own.
    pub(super) fn of(polygons: &'a Polygons, shapes: Shapes, merge: bool) -> Self {
        let mut groups = Self::default();
        let mut by_hash: HashMap<u64, usize, FxBuildHasher> = HashMap::default();
        for polygon in polygons.iter() {
            groups.add(polygon, shapes, merge.then_some(&mut by_hash));
        }
        groups
    }

    fn add(
        &mut self,
        polygon: PolygonRef<'a>,
        shapes: Shapes,
        by_hash: Option<&mut HashMap<u64, usize, FxBuildHasher>>,
    ) {
        let corners = polygon.corners;
        let rectangle = (shapes == Shapes::Rectangles).then(|| rectangle(corners)).flatten();
        let (shape, at) = match rectangle {
            Some((size, lower_left)) => (Shape::Rectangle(size), lower_left),
            None => {
                let start = self.vectors.len();
                self.push_vectors(corners);
                if self.vectors.len() < start + 3 {
                    self.vectors.truncate(start);
                    self.empty += 1;
                    return;
                }
                (Shape::Polygon { start, end: self.vectors.len() }, corners[0])
            }
        };
        let group = Group { layer: polygon.layer, shape, properties: polygon.properties, next: None };
        let number = match by_hash {
            None => self.push(group),
            Some(by_hash) => {
                let first = by_hash.entry(self.hash(&group)).or_insert(self.groups.len());
                let mut candidate = (*first < self.groups.len()).then_some(*first);
                while let Some(known) = candidate.filter(|known| !self.same(&self.groups[*known], &group)) {
                    candidate = self.groups[known].next;
                }
                match candidate {
                    Some(known) => {
                        if let Shape::Polygon { start, .. } = shape {
                            self.vectors.truncate(start);
                        }
                        known
                    }
                    None => {
                        let next = (*first < self.groups.len()).then_some(*first);
                        *first = self.groups.len();
                        self.push(Group { next, ..group })
                    }
                }
            }
        };
        self.items.push((number, at));
    }

    fn push(&mut self, group: Group<'a>) -> usize {
        self.groups.push(group);
        self.groups.len() - 1
    }

    /// Appends the corners from the first one, without those that repeat the one before.
    fn push_vectors(&mut self, corners: &[Corner]) {
        let Some(first) = corners.first() else { return };
        let vector = |corner: &Corner| [0, 1].map(|axis| i64::from(corner[axis]) - i64::from(first[axis]));
        let mut last = None;
        for corner in corners {
            if last != Some(corner) {
                self.vectors.push(vector(corner));
            }
            last = Some(corner);
        }
        if self.vectors.last() == Some(&[0, 0]) && corners.len() > 1 {
            self.vectors.pop();
        }
    }

    fn hash(&self, group: &Group<'_>) -> u64 {
        const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
        let mix = |hash: u64, number: u64| (hash.rotate_left(23) ^ number).wrapping_mul(FACTOR);
        let layer = (u64::from(group.layer.number) << 16) | u64::from(group.layer.datatype);
        match group.shape {
            Shape::Rectangle([width, height]) => mix(mix(layer, width), height),
            Shape::Polygon { start, end } => self.vectors[start..end]
                .iter()
                .fold(!layer, |hash, [x, y]| mix(mix(hash, x.cast_unsigned()), y.cast_unsigned())),
        }
    }

    fn same(&self, a: &Group<'_>, b: &Group<'_>) -> bool {
        a.layer == b.layer && a.properties == b.properties && self.same_shape(a.shape, b.shape)
    }

    fn same_shape(&self, a: Shape, b: Shape) -> bool {
        match (a, b) {
            (Shape::Polygon { start, end }, Shape::Polygon { start: from, end: to }) => {
                self.vectors[start..end] == self.vectors[from..to]
            }
            (a, b) => a == b,
        }
    }

    /// For each group in the order of the file (layers, then first appearance) its number and positions.
    pub(super) fn positions(&self) -> (Vec<usize>, Vec<Corner>, Vec<usize>) {
        let mut ends = vec![0_usize; self.groups.len()];
        for (group, _) in &self.items {
            ends[*group] += 1;
        }
        let mut sum = 0;
        for end in &mut ends {
            let count = *end;
            *end = sum;
            sum += count;
        }
        let mut positions = vec![[0, 0]; self.items.len()];
        for (group, at) in &self.items {
            positions[ends[*group]] = *at;
            ends[*group] += 1;
        }
        let mut layers: HashMap<Layer, usize> = HashMap::new();
        for group in &self.groups {
            let number = layers.len();
            layers.entry(group.layer).or_insert(number);
        }
        let mut order: Vec<usize> = (0..self.groups.len()).collect();
        if layers.len() > 1 {
            order.sort_by_key(|group| layers[&self.groups[*group].layer]);
        }
        (order, positions, ends)
    }
}

/// Size and lower left corner of a rectangle along the axes.
fn rectangle(corners: &[Corner]) -> Option<([u64; 2], Corner)> {
    let &[a, b, c, d] = corners else { return None };
    let horizontal_first = a[1] == b[1] && b[0] == c[0] && c[1] == d[1] && d[0] == a[0];
    let vertical_first = a[0] == b[0] && b[1] == c[1] && c[0] == d[0] && d[1] == a[1];
    if !(horizontal_first || vertical_first) || a[0] == c[0] || a[1] == c[1] {
        return None;
    }
    let size = [0, 1].map(|axis| u64::from(a[axis].abs_diff(c[axis])));
    Some((size, [a[0].min(c[0]), a[1].min(c[1])]))
}
