//! The distinct cells of a hierarchy, in the order of a file.
//!
//! Cells come after the cells that they place, the top cells last, so that a reader knows every cell before it is placed.
//! PHIDL writes them in the order of a hash table.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use phidl_core::hash::Digest;
use phidl_core::scene::Device;

/// Which devices are written as one cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MergeCells {
    /// Devices with the same content: name, drawing, ports, info, generator and parameters. Nothing is lost.
    #[default]
    EqualContent,
    /// Devices that are drawn alike, whatever their names, ports and info are. Files get smaller; the cells of a foundry
    /// may lose their names.
    EqualDrawings,
    /// No devices: two that were built separately are two cells, also where they have the same content.
    Never,
}

/// The distinct cells below some devices and these themselves: children first.
#[derive(Debug)]
pub(crate) struct DistinctCells {
    cells: Vec<Device>,
    /// The index in `cells` of every device of the hierarchy, by its address.
    indices: HashMap<usize, usize>,
}

impl DistinctCells {
    pub(crate) fn of(tops: &[Device], merge: MergeCells) -> Self {
        let mut distinct = Self { cells: Vec::new(), indices: HashMap::new() };
        let mut buckets: HashMap<Fingerprint, Bucket> = HashMap::new();
        for top in tops {
            for cell in top.cells().into_iter().rev() {
                if !distinct.indices.contains_key(&cell.ptr_id()) {
                    distinct.add(cell, merge, &mut buckets);
                }
            }
        }
        distinct
    }

    fn add(&mut self, cell: Device, merge: MergeCells, buckets: &mut HashMap<Fingerprint, Bucket>) {
        let next = self.cells.len();
        let digest: fn(&Device) -> Digest = match merge {
            MergeCells::Never => {
                self.indices.insert(cell.ptr_id(), next);
                return self.cells.push(cell);
            }
            MergeCells::EqualContent => Device::content_hash,
            MergeCells::EqualDrawings => Device::drawing_hash,
        };
        let index = match buckets.entry(Fingerprint::of(&cell, merge)) {
            Entry::Vacant(entry) => {
                entry.insert(Bucket { first: next, by_digest: HashMap::new() });
                next
            }
            // Hashing a large cell costs as much as writing it. Only cells with equal fingerprints are hashed.
            Entry::Occupied(mut entry) => {
                let bucket = entry.get_mut();
                if bucket.by_digest.is_empty() {
                    bucket.by_digest.insert(digest(&self.cells[bucket.first]), bucket.first);
                }
                *bucket.by_digest.entry(digest(&cell)).or_insert(next)
            }
        };
        self.indices.insert(cell.ptr_id(), index);
        if index == next {
            self.cells.push(cell);
        }
    }

    /// The cells, the top cells last.
    pub(crate) fn as_slice(&self) -> &[Device] {
        &self.cells
    }

    /// The index among the cells of a device of the hierarchy.
    pub(crate) fn index_of(&self, device: &Device) -> usize {
        *self.indices.get(&device.ptr_id()).expect("invariant: a reference leads to a cell of the hierarchy")
    }
}

/// Cells with equal fingerprints.
struct Bucket {
    first: usize,
    /// Empty as long as there is only the first.
    by_digest: HashMap<Digest, usize>,
}

/// What is known of a cell without its points. Cells that are one agree in it.
#[derive(PartialEq, Eq, Hash)]
struct Fingerprint {
    name: Option<String>,
    polygons: usize,
    first_polygon: usize,
    references: usize,
    labels: usize,
}

impl Fingerprint {
    fn of(cell: &Device, merge: MergeCells) -> Self {
        Self {
            name: (merge == MergeCells::EqualContent).then(|| cell.name().to_owned()),
            polygons: cell.polygons().len(),
            first_polygon: cell.polygons().next().map_or(0, |polygon| polygon.points.len()),
            references: cell.references().len(),
            labels: cell.labels().len(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(name: &str, size: i32) -> Device {
        let mut d = Device::builder(name);
        d.add_polygon([(0, 0), (size, 0), (size, size), (0, size)], 1).unwrap();
        d.build().unwrap()
    }

    fn holding(name: &str, children: &[&Device]) -> Device {
        let mut d = Device::builder(name);
        for child in children {
            d.add(*child);
        }
        d.build().unwrap()
    }

    fn count(top: &Device, merge: MergeCells) -> usize {
        DistinctCells::of(std::slice::from_ref(top), merge).as_slice().len()
    }

    #[test]
    fn contents_decide_and_twins_of_two_names_stay_two() {
        let (a, again, twin, other) = (square("a", 1), square("a", 1), square("b", 1), square("a", 2));
        let top = holding("top", &[&a, &again, &twin, &other]);
        assert_eq!(count(&top, MergeCells::EqualContent), 4);
        assert_eq!(count(&top, MergeCells::EqualDrawings), 3);
        assert_eq!(count(&top, MergeCells::Never), 5);
    }

    #[test]
    fn equal_drawings_are_one_cell_at_any_depth_on_request() {
        let (a, b, other) = (square("a", 1), square("b", 1), square("c", 2));
        let (left, right) = (holding("left", &[&a]), holding("right", &[&b]));
        let top = holding("top", &[&left, &right, &other]);
        let cells = DistinctCells::of(std::slice::from_ref(&top), MergeCells::EqualDrawings);
        assert_eq!(cells.as_slice().len(), 4);
        assert_eq!(cells.index_of(&a), cells.index_of(&b));
        assert_eq!(cells.index_of(&left), cells.index_of(&right));
        assert_ne!(cells.index_of(&a), cells.index_of(&other));
    }

    #[test]
    fn cells_come_after_what_they_place_and_the_top_is_last() {
        let a = square("a", 1);
        let inner = holding("inner", &[&a]);
        let top = holding("top", &[&a, &inner]);
        let cells = DistinctCells::of(&[top], MergeCells::default());
        assert_eq!(cells.as_slice().iter().map(Device::name).collect::<Vec<_>>(), ["a", "inner", "top"]);
    }
}
