//! [`SegmentSet`]: the first stage, contours of both operands as segments.

use std::ops::Range;

use rayon::prelude::*;

use super::{input::Operand, radix::by_x, segment::Segment};
use crate::{
    error::BooleanError,
    point::{GridPoint, signed_area2},
};

/// Segment numbers are `u32`, and the top bit marks segments that span a seam.
pub(super) const MAX_SEGMENTS: usize = 1 << 31;

/// Contours handled by one parallel job while their directions are found.
const CONTOURS_PER_JOB: usize = 512;

/// The segments of all contours that are not isolated, numbered along the contours.
///
/// Points are copied with the contours from left to right, so that the segments of a strip are close in memory. Segments
/// are computed from the points on request: a list of them would take several times the memory.
pub(super) struct SegmentSet {
    /// The end of each segment, in the direction of its contour.
    points: Vec<GridPoint>,
    /// The contour of each segment.
    contour_of: Vec<u32>,
    contours: Vec<Contour>,
    /// Whether each operand is [`Operand::Shapes`].
    are_shapes: [bool; 2],
}

/// The segments of a contour.
#[derive(Clone, Copy)]
struct Contour {
    /// Number of its first segment.
    first: u32,
    /// How many segments it has.
    len: u32,
    operand: u8,
    /// Factor of the winding delta: −1 for clockwise shapes, which cover what they enclose.
    sign: i8,
}

impl SegmentSet {
    /// The segments of all contours but the isolated ones; contours of the second operand are numbered after the first.
    pub(super) fn new(operands: &[Operand; 2], is_isolated: impl Fn(usize) -> bool) -> Result<Self, BooleanError> {
        let points: usize = operands.iter().map(|operand| operand.contours().point_count()).sum();
        if points >= MAX_SEGMENTS {
            return Err(BooleanError::TooLarge { edges: points, limit: MAX_SEGMENTS });
        }
        let of_operand = |operand| std::iter::repeat(operand).zip(operands[usize::from(operand)].contours().iter());
        let all = [0, 1].into_iter().flat_map(of_operand).enumerate();
        let contours: Vec<(u8, &[GridPoint])> = all
            .filter(|&(number, (_, points))| !points.is_empty() && !is_isolated(number))
            .map(|(_, contour)| contour)
            .collect();
        let segments = contours.iter().map(|(_, points)| points.len()).sum();
        let mut set = Self {
            points: Vec::with_capacity(segments),
            contour_of: Vec::with_capacity(segments),
            contours: Vec::with_capacity(contours.len()),
            are_shapes: operands.map(|operand| matches!(operand, Operand::Shapes(_))),
        };
        let begins = (0u32..).zip(contours.iter().map(|(_, points)| points[0].x));
        let in_order = |a: u32, b: u32| {
            let ((a_operand, a_points), (b_operand, b_points)) = (contours[a as usize], contours[b as usize]);
            a_points.cmp(b_points).then(a_operand.cmp(&b_operand)).then(a.cmp(&b))
        };
        let mut last = None;
        for number in by_x(begins, in_order) {
            let (operand, points) = contours[number as usize];
            // Copies of a shape cover what the shape covers.
            let is_copy = last == Some((operand, points)) && set.are_shapes[usize::from(operand)];
            if !is_copy {
                set.add(operand, points);
            }
            last = Some((operand, points));
        }
        set.orient_shapes();
        Ok(set)
    }

    #[expect(clippy::cast_possible_truncation, reason = "segments are fewer than MAX_SEGMENTS, contours too")]
    fn add(&mut self, operand: u8, points: &[GridPoint]) {
        let (number, first) = (self.contours.len() as u32, self.points.len() as u32);
        self.contours.push(Contour { first, len: points.len() as u32, operand, sign: 1 });
        self.contour_of.extend(std::iter::repeat_n(number, points.len()));
        self.points.extend_from_slice(points);
    }

    /// Finds the shapes that run clockwise.
    fn orient_shapes(&mut self) {
        let (points, are_shapes) = (&self.points, self.are_shapes);
        self.contours.par_iter_mut().with_min_len(CONTOURS_PER_JOB).for_each(|contour| {
            if are_shapes[usize::from(contour.operand)] && signed_area2(contour.of(points)) < 0 {
                contour.sign = -1;
            }
        });
    }

    /// Number of segments.
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    /// A segment by its number.
    pub(super) fn segment(&self, number: u32) -> Segment {
        self.reader().segment(number)
    }

    /// Reads segments of which most belong to the contour of the one before.
    pub(super) fn reader(&self) -> SegmentReader<'_> {
        SegmentReader { set: self, contour: 0, points: &[], first: 0, delta: [0; 2] }
    }

    /// The contour of a segment.
    #[inline]
    pub(super) fn contour_of(&self, segment: u32) -> u32 {
        self.contour_of[segment as usize]
    }

    /// True if a contour is a shape, so that crossings with itself matter.
    pub(super) fn is_shape(&self, contour: u32) -> bool {
        self.are_shapes[self.operand_of(contour)]
    }

    /// The operand that a contour belongs to.
    pub(super) fn operand_of(&self, contour: u32) -> usize {
        usize::from(self.contours[contour as usize].operand)
    }

    /// Whether one of two segments of a contour (the first has the lower number) begins where the other ends.
    pub(super) fn are_neighbors(&self, low: u32, high: u32) -> bool {
        let Contour { first, len, .. } = self.contours[self.contour_of(low) as usize];
        let empty = |mut segments: Range<u32>| segments.all(|segment| self.segment(segment).is_empty());
        empty(low + 1..high) || (empty(first..low) && empty(high + 1..first + len))
    }
}

impl Contour {
    fn of(self, points: &[GridPoint]) -> &[GridPoint] {
        &points[self.first as usize..][..self.len as usize]
    }
}

/// Computes segments, and remembers the contour of the last one.
pub(super) struct SegmentReader<'a> {
    set: &'a SegmentSet,
    contour: u32,
    points: &'a [GridPoint],
    /// Number of the first segment of the contour.
    first: u32,
    /// Of a segment that runs from left to right.
    delta: [i32; 2],
}

impl SegmentReader<'_> {
    /// A segment by its number.
    #[inline]
    pub(super) fn segment(&mut self, number: u32) -> Segment {
        let (from, to) = self.ends(number);
        // The order of the ends is unpredictable, so this code has no branch.
        let forward = (from.x < to.x) | ((from.x == to.x) & (from.y < to.y));
        let sign = if forward { 1 } else { -1 };
        let (l, r) = if forward { (from, to) } else { (to, from) };
        Segment { l, r, delta: self.delta.map(|d| sign * d) }
    }

    /// The contour of the last segment.
    #[inline]
    pub(super) fn contour(&self) -> u32 {
        self.contour
    }

    /// First and last grid column of a segment; `None` if it is empty.
    #[inline]
    pub(super) fn columns(&mut self, number: u32) -> Option<(i64, i64)> {
        let (from, to) = self.ends(number);
        if from == to { None } else { Some((from.x.min(to.x), from.x.max(to.x))) }
    }

    #[inline]
    fn ends(&mut self, number: u32) -> (GridPoint, GridPoint) {
        let mut end = number.wrapping_sub(self.first) as usize;
        if end >= self.points.len() {
            self.turn_to(self.set.contour_of(number));
            end = (number - self.first) as usize;
        }
        let start = if end == 0 { self.points.len() } else { end };
        (self.points[start - 1], self.points[end])
    }

    fn turn_to(&mut self, number: u32) {
        let contour = self.set.contours[number as usize];
        (self.contour, self.points, self.first) = (number, contour.of(&self.set.points), contour.first);
        self.delta = [0; 2];
        self.delta[usize::from(contour.operand)] = i32::from(contour.sign);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contours::Contours;

    fn contours(outlines: &[&[(i64, i64)]]) -> Contours {
        outlines.iter().map(|outline| outline.iter().copied().map(GridPoint::from)).collect()
    }

    #[test]
    fn shapes_wind_once_in_any_direction_and_oriented_contours_in_theirs() {
        let clockwise = contours(&[&[(0, 0), (0, 4), (4, 0)]]);
        let operands = [Operand::Shapes(&clockwise), Operand::Oriented(&clockwise)];
        let set = SegmentSet::new(&operands, |_| false).unwrap();
        let left = (GridPoint::new(0, 0), GridPoint::new(0, 4));
        let found: Vec<Segment> = (0..6).map(|number| set.segment(number)).filter(|e| (e.l, e.r) == left).collect();
        // To the right of the left edge (read upward) is the inside; "above" it is the outside.
        assert_eq!(found.iter().map(|e| e.delta).collect::<Vec<_>>(), [[-1, 0], [0, 1]]);
        assert_eq!((set.operand_of(0), set.operand_of(1)), (0, 1));
    }

    #[test]
    fn neighbors_are_found_over_repeated_points() {
        let repeated = contours(&[&[], &[(0, 0), (0, 0), (5, 0), (5, 0), (5, 0), (5, 5), (0, 0)]]);
        let operands = [Operand::Shapes(&repeated), Operand::Oriented(&repeated)];
        let set = SegmentSet::new(&operands, |_| false).unwrap();
        let used: Vec<u32> = (0..7).filter(|&segment| !set.segment(segment).is_empty()).collect();
        assert_eq!(used, [2, 5, 6]);
        assert!(set.are_neighbors(2, 5) && set.are_neighbors(5, 6) && set.are_neighbors(2, 6));
        let square = contours(&[&[(0, 0), (5, 0), (5, 5), (0, 5)]]);
        let operands = [Operand::Shapes(&square), Operand::Oriented(&square)];
        let set = SegmentSet::new(&operands, |_| false).unwrap();
        assert!(set.are_neighbors(0, 3) && !set.are_neighbors(0, 2) && !set.are_neighbors(5, 7));
    }
}
