//! Expanding a hierarchy on all cores.
//!
//! Every thread fills its own stretch of the result in place: it looks up once which placed cell the stretch begins in
//! (sums of what lies before each reference make that a search per level), and streams from there. The result is the
//! sequential one, whatever the stretches. Gathering pieces per thread and joining them would move every point twice.

use std::collections::HashMap;

use rayon::prelude::*;

use super::Device;
use super::flatten::Amount;
use super::outlines::{Outlines, Span};
use super::walk::Instances;
use crate::geom::{Matrix, Point, Transform};

/// Below this number of points, threads cost more than they save.
const WORTH_IT: usize = 100_000;

/// Whether a hierarchy of so much is expanded in parallel.
pub(super) fn is_worth_it(total: Amount) -> bool {
    total.points > WORTH_IT
}

/// All polygons of a hierarchy, without their properties.
pub(super) fn all_outlines(device: &Device, amounts: &HashMap<usize, Amount>) -> Outlines {
    let plan = Plan::new(device, amounts);
    let total = amounts[&device.address()];
    let mut points = Vec::new();
    (0..total.points)
        .into_par_iter()
        .map_init(|| Reader::new(&plan, |a| a.points), |reader, index| reader.point(index))
        .collect_into_vec(&mut points);
    let mut spans = Vec::new();
    (0..total.polygons)
        .into_par_iter()
        .map_init(|| Reader::new(&plan, |a| a.polygons), |reader, index| reader.span(index))
        .collect_into_vec(&mut spans);
    Outlines::from_parts(points, spans)
}

/// A hierarchy with the sums that find any of its polygons and points.
struct Plan<'a> {
    root: &'a Device,
    amounts: &'a HashMap<usize, Amount>,
    /// By a cell's address: what is drawn before each of its references, counted from the cell's own beginning.
    before: HashMap<usize, Vec<Amount>>,
}

impl<'a> Plan<'a> {
    fn new(root: &'a Device, amounts: &'a HashMap<usize, Amount>) -> Self {
        let before = root.cells().iter().map(|cell| (cell.address(), sums_before(cell, amounts))).collect();
        Self { root, amounts, before }
    }
}

fn sums_before(cell: &Device, amounts: &HashMap<usize, Amount>) -> Vec<Amount> {
    let outlines = &cell.cell().outlines;
    let mut sum = Amount { polygons: outlines.len(), points: outlines.point_count() };
    let mut sums = Vec::with_capacity(cell.references().len());
    for reference in cell.references() {
        sums.push(sum);
        let below = amounts[&reference.device().address()];
        sum.polygons += below.polygons * reference.count();
        sum.points += below.points * reference.count();
    }
    sums
}

/// Reads the expanded hierarchy from any index on; the next index costs least.
struct Reader<'p, 'a> {
    plan: &'p Plan<'a>,
    /// Which of the two amounts an index counts.
    measure: fn(&Amount) -> usize,
    walk: Instances<'a>,
    outlines: Option<&'a Outlines>,
    matrix: Matrix,
    /// Where the current placed cell begins in the result.
    base: Amount,
    /// The next index.
    next: usize,
}

impl<'p, 'a> Reader<'p, 'a> {
    fn new(plan: &'p Plan<'a>, measure: fn(&Amount) -> usize) -> Self {
        Self {
            plan,
            measure,
            walk: Instances::nowhere(),
            outlines: None,
            matrix: Transform::IDENTITY.matrix(),
            base: Amount::default(),
            next: 0,
        }
    }

    fn point(&mut self, index: usize) -> Point {
        let (outlines, at) = self.go_to(index);
        self.matrix.apply(outlines.all_points()[at])
    }

    fn span(&mut self, index: usize) -> Span {
        let (outlines, at) = self.go_to(index);
        let span = outlines.span(at);
        Span { end: self.base.points + span.end, ..span }
    }

    /// The cell that an index falls into, and where in it.
    fn go_to(&mut self, index: usize) -> (&'a Outlines, usize) {
        if self.outlines.is_none() || index != self.next {
            self.seek(index);
        }
        self.next = index + 1;
        loop {
            let outlines = self.outlines.expect("invariant: an index within the total lies in some placed cell");
            let at = index - (self.measure)(&self.base);
            let own = own_amount(outlines);
            if at < (self.measure)(&own) {
                return (outlines, at);
            }
            self.base.points += own.points;
            self.base.polygons += own.polygons;
            let instance = self.walk.next();
            self.outlines = instance.map(|i| &i.device.cell().outlines);
            self.matrix = instance.map_or(self.matrix, |i| i.transform.matrix());
        }
    }

    fn seek(&mut self, index: usize) {
        let mut device = self.plan.root;
        let mut transform = Transform::IDENTITY;
        self.walk = Instances::nowhere();
        self.base = Amount::default();
        loop {
            let inside = index - (self.measure)(&self.base);
            let before = &self.plan.before[&device.address()];
            if inside < (self.measure)(&own_amount(&device.cell().outlines)) {
                break;
            }
            // The last reference that begins at or before the index; empty ones begin where the next does.
            let number = before.partition_point(|amount| (self.measure)(amount) <= inside) - 1;
            let reference = &device.references()[number];
            let below = self.plan.amounts[&reference.device().address()];
            let element = (inside - (self.measure)(&before[number])) / (self.measure)(&below);
            self.base.points += before[number].points + element * below.points;
            self.base.polygons += before[number].polygons + element * below.polygons;
            let (column, row) = position(element, reference.array().map_or(1, |a| a.rows));
            self.walk.push_after(device, transform, number, (column, row));
            transform = reference.element(column, row).then(&transform);
            device = reference.device();
        }
        self.walk.push_before_children(device, transform);
        self.outlines = Some(&device.cell().outlines);
        self.matrix = transform.matrix();
    }
}

fn own_amount(outlines: &Outlines) -> Amount {
    Amount { polygons: outlines.len(), points: outlines.point_count() }
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
    use crate::scene::flatten::amounts;

    fn dot(size: i32) -> Device {
        let mut d = Device::builder("dot");
        for _ in 0..size {
            d.add_polygon([(0, 0), (size, 0), (0, 1)], 1).unwrap();
        }
        d.build().unwrap()
    }

    /// Own polygons, empty cells, arrays, and depth: everything that an index can fall into.
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
        let amounts = amounts(&top);
        let plan = Plan::new(&top, &amounts);
        let expected: Vec<Point> = top.flat_polygons().flat_map(|p| p.points().collect::<Vec<_>>()).collect();
        let total = amounts[&top.address()];
        assert_eq!(total.points, expected.len());
        for (index, point) in expected.iter().enumerate() {
            assert_eq!(Reader::new(&plan, |a| a.points).point(index), *point, "{index}");
        }
        let mut reader = Reader::new(&plan, |a| a.points);
        assert!((0..expected.len()).all(|index| reader.point(index) == expected[index]));
    }

    #[test]
    fn the_parallel_result_is_the_sequential_one() {
        let top = hierarchy();
        let flat = all_outlines(&top, &amounts(&top));
        let expected: Vec<_> = top.flat_polygons().map(|p| (p.layer, p.points().collect::<Vec<_>>())).collect();
        let got: Vec<_> = flat.iter().map(|p| (Some(p.layer), p.points.to_vec())).collect();
        assert_eq!(got, expected);
    }
}
