//! The cells of a file: every distinct drawing of a hierarchy once, in a fixed order, with its name.
//!
//! Cells come after the cells that they place, the top cell last, so that a reader knows every cell before it is
//! placed. PHIDL writes them in the order of a hash table.

use std::collections::HashMap;

use phidl_core::scene::Device;

use super::names;

/// The distinct cells below a device, with the names that a file gives them.
#[derive(Debug)]
pub(crate) struct CellTable {
    cells: Vec<Device>,
    names: Vec<String>,
    /// The place in `cells` of every device of the hierarchy, by its address.
    places: HashMap<usize, usize>,
}

impl CellTable {
    pub(crate) fn new(top: &Device, top_name: Option<&str>, max_length: usize) -> Self {
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
            places.insert(cell.address(), place);
            if place == cells.len() {
                cells.push(cell);
            }
        }
        let names = names::unique_names(&cells, top_name, max_length);
        Self { cells, names, places }
    }

    /// The cells with their names: children before parents, the top cell last.
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = (&Device, &str)> {
        self.cells.iter().zip(self.names.iter().map(String::as_str))
    }

    /// The name of the cell that a device of the hierarchy is written as.
    pub(crate) fn name_of(&self, device: &Device) -> &str {
        let place = self.places.get(&device.address()).expect("invariant: a reference leads to a cell of the hierarchy");
        &self.names[*place]
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
        let table = CellTable::new(&top, None, 32);
        assert_eq!(table.iter().len(), 4);
        assert_eq!(table.name_of(&a), table.name_of(&b));
        assert_eq!(table.name_of(&left), table.name_of(&right));
        assert_ne!(table.name_of(&a), table.name_of(&other));
    }

    #[test]
    fn cells_come_after_what_they_place_and_the_top_is_last() {
        let a = square("a", 1);
        let inner = holding("inner", &[&a]);
        let top = holding("top", &[&a, &inner]);
        let table = CellTable::new(&top, None, 32);
        assert_eq!(table.iter().map(|(_, name)| name).collect::<Vec<_>>(), ["a", "inner", "top"]);
    }
}
