//! Expanding a hierarchy on all cores.
//!
//! Every thread fills its own range of the result in place. It finds the placed cell in which the range begins (prefix sums
//! over the references make that one search per level), and iterates from there. The result is the sequential one for
//! every division into ranges.
//!
//! Not tasks per reference with slices of a zeroed buffer, nor buffers per thread that are joined: both are shorter, and
//! both write every point twice.

use std::collections::HashMap;

use rayon::prelude::*;

use super::Device;
use super::flat_counts::FlatCounts;
use super::polygon_store::{PolygonStore, StoreEntry};
use super::walk::Instances;
use crate::geom::{Matrix, Point, Transform};

/// Below this number of points, threads cost more than they save.
const WORTH_IT: u64 = 100_000;

/// Whether a hierarchy of this size is expanded in parallel.
pub(super) fn is_worth_it(total: FlatCounts) -> bool {
    total.points > WORTH_IT
}

/// All polygons of a hierarchy whose size fits into memory, without their properties.
pub(super) fn all_polygons(device: &Device, counts: &HashMap<usize, FlatCounts>) -> PolygonStore {
    let plan = Plan::new(device, counts);
    let total = plan.sizes[&device.ptr_id()];
    let mut points = Vec::new();
    (0..total.points)
        .into_par_iter()
        .map_init(|| Reader::new(&plan, |size| size.points), |reader, index| reader.point(index))
        .collect_into_vec(&mut points);
    let mut entries = Vec::new();
    (0..total.polygons)
        .into_par_iter()
        .map_init(|| Reader::new(&plan, |size| size.polygons), |reader, index| reader.entry(index))
        .collect_into_vec(&mut entries);
    PolygonStore::from_parts(points, entries)
}

/// A number of polygons and of points: the size of a part of the result, or what precedes it.
#[derive(Debug, Clone, Copy, Default)]
struct Size {
    polygons: usize,
    points: usize,
}

impl Size {
    fn own(polygons: &PolygonStore) -> Self {
        Self { polygons: polygons.len(), points: polygons.point_count() }
    }

    fn from_counts(counts: FlatCounts) -> Self {
        let narrow = |count: u64| usize::try_from(count).expect("invariant: the size was checked before");
        Self { polygons: narrow(counts.polygons), points: narrow(counts.points) }
    }

    fn add(&mut self, size: Self, times: usize) {
        self.polygons += size.polygons * times;
        self.points += size.points * times;
    }
}

/// A hierarchy with the prefix sums that find any of its polygons and points. Maps are by [`Device::ptr_id`].
struct Plan<'a> {
    root: &'a Device,
    /// The size of every cell with what is below it.
    sizes: HashMap<usize, Size>,
    /// What precedes each reference of a cell, counted from the beginning of the cell.
    before: HashMap<usize, Vec<Size>>,
}

impl<'a> Plan<'a> {
    fn new(root: &'a Device, counts: &HashMap<usize, FlatCounts>) -> Self {
        let cells = root.cells();
        let sizes = cells.iter().map(|cell| (cell.ptr_id(), Size::from_counts(counts[&cell.ptr_id()]))).collect();
        let before = cells.iter().map(|cell| (cell.ptr_id(), prefix_sums(cell, &sizes))).collect();
        Self { root, sizes, before }
    }
}

fn prefix_sums(cell: &Device, sizes: &HashMap<usize, Size>) -> Vec<Size> {
    let mut sum = Size::own(&cell.cell().polygons);
    let mut sums = Vec::with_capacity(cell.references().len());
    for reference in cell.references() {
        sums.push(sum);
        sum.add(sizes[&reference.device().ptr_id()], reference.count());
    }
    sums
}

/// Reads the expanded hierarchy from any index on; the next index costs least.
struct Reader<'p, 'a> {
    plan: &'p Plan<'a>,
    /// Which of the two numbers an index counts.
    measure: fn(&Size) -> usize,
    walk: Instances<'a>,
    polygons: Option<&'a PolygonStore>,
    matrix: Matrix,
    /// What precedes the current placed cell in the result.
    base: Size,
    /// The next index.
    next: usize,
}

impl<'p, 'a> Reader<'p, 'a> {
    fn new(plan: &'p Plan<'a>, measure: fn(&Size) -> usize) -> Self {
        Self {
            plan,
            measure,
            walk: Instances::exhausted(),
            polygons: None,
            matrix: Transform::IDENTITY.matrix(),
            base: Size::default(),
            next: 0,
        }
    }

    fn point(&mut self, index: usize) -> Point {
        let (polygons, at) = self.go_to(index);
        self.matrix.apply(polygons.all_points()[at])
    }

    fn entry(&mut self, index: usize) -> StoreEntry {
        let (polygons, at) = self.go_to(index);
        let entry = polygons.entry(at);
        StoreEntry { end: self.base.points + entry.end, ..entry }
    }

    /// The placed cell of an index, and the index within it.
    fn go_to(&mut self, index: usize) -> (&'a PolygonStore, usize) {
        if self.polygons.is_none() || index != self.next {
            self.seek(index);
        }
        self.next = index + 1;
        loop {
            let polygons = self.polygons.expect("invariant: an index within the total lies in some placed cell");
            let at = index - (self.measure)(&self.base);
            let own = Size::own(polygons);
            if at < (self.measure)(&own) {
                return (polygons, at);
            }
            self.base.add(own, 1);
            let instance = self.walk.next();
            self.polygons = instance.map(|i| &i.device.cell().polygons);
            self.matrix = instance.map_or(self.matrix, |i| i.transform.matrix());
        }
    }

    fn seek(&mut self, index: usize) {
        let mut device = self.plan.root;
        let mut transform = Transform::IDENTITY;
        self.walk = Instances::exhausted();
        self.base = Size::default();
        loop {
            let inside = index - (self.measure)(&self.base);
            let before = &self.plan.before[&device.ptr_id()];
            if inside < (self.measure)(&Size::own(&device.cell().polygons)) {
                break;
            }
            // The last reference that begins at or before the index; empty ones begin where the next does.
            let number = before.partition_point(|size| (self.measure)(size) <= inside) - 1;
            let reference = &device.references()[number];
            let below = self.plan.sizes[&reference.device().ptr_id()];
            let element = (inside - (self.measure)(&before[number])) / (self.measure)(&below);
            self.base.add(before[number], 1);
            self.base.add(below, element);
            let (column, row) = position(element, reference.array().map_or(1, |a| a.rows));
            self.walk.push_after(device, transform, number, (column, row));
            transform = reference.element(column, row).then(&transform);
            device = reference.device();
        }
        self.walk.push_before_children(device, transform);
        self.polygons = Some(&device.cell().polygons);
        self.matrix = transform.matrix();
    }
}

/// Column and row of an element, counted column by column.
fn position(element: usize, rows: u32) -> (u32, u32) {
    let rows = rows as usize;
    let narrow = |v: usize| u32::try_from(v).expect("invariant: an array has at most u32 columns and rows");
    (narrow(element / rows), narrow(element % rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::place::Movable;

    fn dot(size: i32) -> Device {
        let mut d = Device::builder("dot");
        for _ in 0..size {
            d.add_polygon([(0, 0), (size, 0), (0, 1)], 1).unwrap();
        }
        d.build().unwrap()
    }

    /// Own polygons, empty cells, arrays, and depth.
    fn hierarchy() -> Device {
        let empty = Device::builder("empty").build().unwrap();
        let mut middle = Device::builder("middle");
        middle.add(&empty);
        middle.add(dot(3).array(3, 2, (10, 20)));
        middle.add_polygon([(0, 0), (5, 0), (5, 5), (0, 5)], 2).unwrap();
        let middle = middle.build().unwrap();
        let mut top = Device::builder("top");
        top.add(&empty);
        top.add(middle.array(2, 3, (100, 100)).rotated(30));
        top.add(&empty);
        top.add(dot(1).place().mirrored((0, 0), (1, 2)));
        top.add(&empty);
        top.build().unwrap()
    }

    #[test]
    fn every_index_reads_what_the_sequential_walk_gives() {
        let top = hierarchy();
        let plan = Plan::new(&top, &FlatCounts::of_cells(&top));
        let expected: Vec<Point> = top.flat_polygons().flat_map(|p| p.points().collect::<Vec<_>>()).collect();
        assert_eq!(plan.sizes[&top.ptr_id()].points, expected.len());
        for (index, point) in expected.iter().enumerate() {
            assert_eq!(Reader::new(&plan, |size| size.points).point(index), *point, "{index}");
        }
        let mut reader = Reader::new(&plan, |size| size.points);
        assert!((0..expected.len()).all(|index| reader.point(index) == expected[index]));
    }

    #[test]
    fn the_parallel_result_is_the_sequential_one() {
        let top = hierarchy();
        let flat = all_polygons(&top, &FlatCounts::of_cells(&top));
        let expected: Vec<_> = top.flat_polygons().map(|p| (p.layer, p.points().collect::<Vec<_>>())).collect();
        let got: Vec<_> = flat.iter().map(|p| (Some(p.layer), p.points.to_vec())).collect();
        assert_eq!(got, expected);
    }
}
