//! The different cells of a hierarchy: every drawing once.
//!
//! Cells come after the cells that they place, the top cell last, so that whoever reads or draws them knows every cell
//! before it is placed. PHIDL writes them in the order of a hash table.

use std::collections::HashMap;

use phidl_core::scene::Device;

/// The different cells below a device and itself: children first, each drawing once, whatever it is called.
#[derive(Debug)]
pub(crate) struct DistinctCells {
    cells: Vec<Device>,
    /// The place in `cells` of every device of the hierarchy, by its address.
    places: HashMap<usize, usize>,
}

impl DistinctCells {
    pub(crate) fn of(top: &Device) -> Self {
        let mut cells: Vec<Device> = Vec::new();
        let mut places = HashMap::new();
        let mut alike: HashMap<Outward, Vec<usize>> = HashMap::new();
        for cell in top.cells().into_iter().rev() {
            let candidates = alike.entry(Outward::of(&cell)).or_default();
            // Hashing a large cell costs as much as writing it; done only where a look from outside leaves a doubt.
            let known = candidates.iter().find(|place| cells[**place].drawing_hash() == cell.drawing_hash());
            let place = known.copied().unwrap_or_else(|| {
                candidates.push(cells.len());
                cells.len()
            });
            places.insert(cell.ptr_id(), place);
            if place == cells.len() {
                cells.push(cell);
            }
        }
        Self { cells, places }
    }

    /// The cells, the top cell last.
    pub(crate) fn as_slice(&self) -> &[Device] {
        &self.cells
    }

    /// The place among the cells of a device of the hierarchy.
    pub(crate) fn place_of(&self, device: &Device) -> usize {
        *self.places.get(&device.ptr_id()).expect("invariant: a reference leads to a cell of the hierarchy")
    }
}

/// What is seen of a cell without looking at its points. Cells of one drawing agree in it.
#[derive(PartialEq, Eq, Hash)]
struct Outward {
    polygons: usize,
    first_polygon: usize,
    references: usize,
    labels: usize,
}

impl Outward {
    fn of(cell: &Device) -> Self {
        Self {
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

    #[test]
    fn equal_drawings_are_one_cell_at_any_depth() {
        let (a, b, other) = (square("a", 1), square("b", 1), square("c", 2));
        let (left, right) = (holding("left", &[&a]), holding("right", &[&b]));
        let top = holding("top", &[&left, &right, &other]);
        let cells = DistinctCells::of(&top);
        assert_eq!(cells.as_slice().len(), 4);
        assert_eq!(cells.place_of(&a), cells.place_of(&b));
        assert_eq!(cells.place_of(&left), cells.place_of(&right));
        assert_ne!(cells.place_of(&a), cells.place_of(&other));
    }

    #[test]
    fn cells_come_after_what_they_place_and_the_top_is_last() {
        let a = square("a", 1);
        let inner = holding("inner", &[&a]);
        let top = holding("top", &[&a, &inner]);
        let cells = DistinctCells::of(&top);
        assert_eq!(cells.as_slice().iter().map(Device::name).collect::<Vec<_>>(), ["a", "inner", "top"]);
    }
}
