//! The laws that any bytes must obey: read as shapes, they are combined, moved and cut. The fuzz targets of the
//! repository (`fuzz/`) and the property tests call the same functions.
//!
//! Bytes are read as nasty shapes on purpose: few, small and crowded, with points that come back (spikes, seams), stand
//! twice, or share a coordinate, and coordinates up to the end of the range and beyond it.

use arbitrary::{Result, Unstructured};
use phidl_boolean::{
    BooleanError, Join, OffsetOptions, Operation, Region, RunOptions, StripCount,
    grid::{self, Contours, GridPoint, MAX_COORDINATE, signed_area2},
};

use crate::check::{assert_clean, assert_covers};

const OPERATIONS: [Operation; 5] = [Operation::Or, Operation::And, Operation::Not, Operation::BMinusA, Operation::Xor];

/// Steps by which edges may end up off after merging, moving, snapping and comparing: up to one each, and
/// one where a nearly straight corner counts as straight.
const ROUNDING: f64 = 6.0;

/// Where coordinates are taken from: the larger the scale, the rarer it is that points meet.
#[derive(Clone, Copy)]
struct Space {
    center: i64,
    reach: i64,
    /// Every edge is axis-parallel, so nothing is snapped and every law is exact.
    axis_parallel: bool,
}

impl Space {
    fn take(bytes: &mut Unstructured) -> Result<Self> {
        let (center, reach) = *bytes.choose(&[
            (0, 6),
            (0, 40),
            (0, 3_000),
            (MAX_COORDINATE - 20, 20),
            (0, MAX_COORDINATE),
            (2 - MAX_COORDINATE, 3),
        ])?;
        Ok(Self { center, reach, axis_parallel: bytes.arbitrary()? })
    }

    fn coordinate(self, bytes: &mut Unstructured) -> Result<i64> {
        Ok(self.center + bytes.int_in_range(-self.reach..=self.reach)?)
    }

    fn shapes(self, bytes: &mut Unstructured) -> Result<Contours> {
        let mut shapes = Contours::new();
        for _ in 0..bytes.int_in_range(0..=6)? {
            let shape = if self.axis_parallel { self.rectangle(bytes)? } else { self.polygon(bytes)? };
            shapes.push(shape);
        }
        Ok(shapes)
    }

    fn rectangle(self, bytes: &mut Unstructured) -> Result<Vec<GridPoint>> {
        let (x, y, z, w) =
            (self.coordinate(bytes)?, self.coordinate(bytes)?, self.coordinate(bytes)?, self.coordinate(bytes)?);
        Ok([(x, y), (z, y), (z, w), (x, w)].map(GridPoint::from).to_vec())
    }

    fn polygon(self, bytes: &mut Unstructured) -> Result<Vec<GridPoint>> {
        let mut points: Vec<GridPoint> = Vec::new();
        for _ in 0..bytes.int_in_range(0..=9)? {
            let fresh = GridPoint::new(self.coordinate(bytes)?, self.coordinate(bytes)?);
            let last = points.last().copied().unwrap_or(fresh);
            points.push(match bytes.int_in_range(0..=7u8)? {
                0 => last,
                1 => GridPoint::new(last.x, fresh.y),
                2 => GridPoint::new(fresh.x, last.y),
                3 if !points.is_empty() => *bytes.choose(&points)?,
                _ => fresh,
            });
        }
        Ok(points)
    }
}

/// Set operations: refused exactly if a coordinate is beyond the range, otherwise clean, right at probes, with the areas
/// of set algebra, and the same for all divisions and numbers of threads.
pub(crate) fn operations_obey_set_algebra(bytes: &[u8]) {
    _ = with_two_operands(bytes, |a, b, axis_parallel, bytes| {
        let run = RunOptions::default();
        if let Some(refused) = [a, b].into_iter().find_map(|shapes| shapes.check_range().err()) {
            assert_eq!(grid::boolean(a, b, Operation::Or, &run), Err(refused));
            return Ok(());
        }
        let strips = StripCount::Fixed(bytes.int_in_range(1..=9)?);
        let divided = RunOptions { strips, threads: Some(bytes.int_in_range(1..=3)?), ..run };
        let [or, and, not, reversed, xor] =
            OPERATIONS.map(|operation| grid::boolean(a, b, operation, &run).expect("coordinates are in range"));
        for (operation, whole) in OPERATIONS.into_iter().zip([&or, &and, &not, &reversed, &xor]) {
            assert_clean(whole);
            assert_eq!(grid::boolean(a, b, operation, &divided).as_ref(), Ok(whole));
            assert_covers(whole, a, b, operation, &probes(a, b));
        }
        // All operations on the same shapes bend the same edges alike, so their areas add up to the step.
        assert_eq!(or.area2(), and.area2() + not.area2() + reversed.area2());
        assert_eq!(xor.area2(), not.area2() + reversed.area2());
        if axis_parallel {
            assert_exact_algebra(a, b, [&or, &and, &not]);
        }
        Ok(())
    });
}

/// What holds to the step where no edge bends.
fn assert_exact_algebra(a: &Contours, b: &Contours, [or, and, not]: [&Region; 3]) {
    let run = RunOptions::default();
    let [a, b] = [a, b].map(|shapes| Region::merged(shapes, &run).expect("coordinates are in range"));
    assert_eq!(or.area2() + and.area2(), a.area2() + b.area2());
    assert_eq!((&(&a | &b), &(&a & &b), &(&a - &b)), (or, and, not));
    assert_eq!(a.combine(&a, Operation::Or, &run).as_ref(), Ok(&a));
    assert_eq!((&a | &b), (&b | &a));
    let m = MAX_COORDINATE;
    let plane: Contours = [[(-m, -m), (m, -m), (m, m), (-m, m)].map(GridPoint::from)].into_iter().collect();
    let outside_b = &Region::merged(&plane, &run).expect("the plane is in range") - &b;
    assert_eq!(&(&a & &outside_b), not);
}

/// Growing and shrinking: refused for a reason, otherwise clean, the same for all divisions, larger or smaller than the
/// shapes as the sign says, and out and in again no smaller.
pub(crate) fn offsets_keep_their_side(bytes: &[u8]) {
    _ = with_one_operand(bytes, |shapes, bytes| {
        let distance = *bytes.choose(&[0.0, 0.4, 1.0, 2.5, 7.0, 33.3, 1e4, 1e9])?;
        let distance = if bytes.arbitrary()? { distance } else { -distance };
        let join = match bytes.int_in_range(0..=3u8)? {
            0 => Join::Bevel,
            1 => Join::Miter { limit: 1.0 + f64::from(bytes.arbitrary::<u8>()?) / 16.0 },
            2 => Join::Extended { extension: f64::from(bytes.arbitrary::<u8>()?) / 16.0 },
            _ => Join::Round { points_per_turn: 3.0 + f64::from(bytes.arbitrary::<u8>()?) },
        };
        let growth = OffsetOptions { join, merge_first: bytes.arbitrary()? };
        let run = RunOptions::default();
        let moved = match grid::offset(shapes, distance, &growth, &run) {
            Ok(moved) => moved,
            Err(BooleanError::OutOfRange { .. }) => return Ok(()),
            Err(error) => panic!("{error}"),
        };
        assert_clean(&moved);
        let divided = RunOptions { strips: StripCount::Fixed(bytes.int_in_range(1..=9)?), threads: Some(2), ..run };
        assert_eq!(grid::offset(shapes, distance, &growth, &divided).as_ref(), Ok(&moved));
        let merged = Region::merged(shapes, &run).expect("coordinates are in range");
        let (smaller, larger) = if distance < 0.0 { (&moved, &merged) } else { (&merged, &moved) };
        assert_within(smaller, larger, 0.0);
        // These joins keep everything within the distance; the others cut into that. A rounded corner turns an edge,
        // and farther on the way back than edges are long, no other property holds.
        if (0.0..50.0).contains(&distance)
            && matches!(join, Join::Miter { .. } | Join::Bevel)
            && growth.merge_first
            && let Ok(back) = moved.offset(-distance, Join::default(), &run)
        {
            assert_within(&merged, &back, distance);
        }
        Ok(())
    });
}

/// Panics if more of the smaller region sticks out than rounding of its edges and the given number of steps explain.
fn assert_within(smaller: &Region, larger: &Region, steps: f64) {
    let sticking_out = smaller.combine(larger, Operation::Not, &RunOptions::default()).expect("regions are in range");
    let allowed = (ROUNDING + steps) * perimeter(smaller);
    assert!(sticking_out.area() <= allowed, "{} of {smaller:?} sticks out of {larger:?}", sticking_out.area());
}

fn perimeter(region: &Region) -> f64 {
    let length = |(p, q): (&GridPoint, &GridPoint)| ((p.x - q.x) as f64).hypot((p.y - q.y) as f64);
    region.contours().iter().flat_map(|c| c.iter().zip(c.iter().cycle().skip(1))).map(length).sum()
}

/// Outlines for files: every hole opened, every part within the limit, area and points exactly those of the region.
pub(crate) fn parts_lose_nothing(bytes: &[u8]) {
    _ = with_two_operands(bytes, |a, b, axis_parallel, bytes| {
        let Ok(region) = grid::boolean(a, b, Operation::Xor, &RunOptions::default()) else { return Ok(()) };
        let limit = bytes.int_in_range(3..=12)?;
        let parts = region.fractured(limit).expect("3 points and more are enough");
        assert!(parts.iter().all(|part| part.len() <= limit && signed_area2(part) > 0));
        let whole = region.without_holes();
        assert_eq!(whole.len(), region.polygons().len());
        for outlines in [parts, whole] {
            assert_eq!(outlines.iter().map(signed_area2).sum::<i128>(), region.area2());
            assert_eq!(sorted(&outlines), sorted(region.contours()));
            if axis_parallel {
                let again = Region::merged(&outlines, &RunOptions::default()).expect("its points are in range");
                assert_eq!(again.area2(), region.area2());
            }
        }
        Ok(())
    });
}

fn sorted(contours: &Contours) -> Vec<GridPoint> {
    let mut points = contours.points().to_vec();
    points.sort_unstable();
    points.dedup();
    points
}

/// The corners of the shapes and positions between them.
fn probes(a: &Contours, b: &Contours) -> Vec<GridPoint> {
    let points: Vec<GridPoint> = a.points().iter().chain(b.points()).copied().collect();
    let between = points.iter().zip(points.iter().skip(1)).zip(points.iter().skip(3));
    between.map(|((p, q), r)| GridPoint::new((p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3)).collect()
}

fn with_two_operands(
    bytes: &[u8],
    law: impl FnOnce(&Contours, &Contours, bool, &mut Unstructured) -> Result<()>,
) -> Result<()> {
    let mut bytes = Unstructured::new(bytes);
    let space = Space::take(&mut bytes)?;
    let (a, b) = (space.shapes(&mut bytes)?, space.shapes(&mut bytes)?);
    law(&a, &b, space.axis_parallel, &mut bytes)
}

fn with_one_operand(bytes: &[u8], law: impl FnOnce(&Contours, &mut Unstructured) -> Result<()>) -> Result<()> {
    let mut bytes = Unstructured::new(bytes);
    let shapes = Space::take(&mut bytes)?.shapes(&mut bytes)?;
    law(&shapes, &mut bytes)
}
