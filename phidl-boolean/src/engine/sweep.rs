//! The sweep over one strip: what lies on either side of each piece, and which boundary edge follows which.
//!
//! After snapping, pieces meet only at their ends, so the sweep has no geometry to invent: it keeps the list of pieces
//! over the present grid point, from bottom to top, and adds up their windings. Below all pieces there is nothing,
//! which is why a strip needs no help from its neighbors.

use std::{cmp::Ordering, ops::Range};

use super::{
    Rule,
    active::{Active, Place},
    edge::Edge,
    order::by_x,
    span::{Spans, drop_last_cancelled, push_merged},
};
use crate::point::{GridPoint, side};

/// Names a boundary edge: its number in the strip, or [`SPAN`] with the number of a piece that reaches over a seam.
pub(super) type Name = u32;

/// Marks the [`Name`] of a piece that belongs to another strip.
pub(super) const SPAN: Name = 1 << 31;

/// What one strip found out.
#[derive(Debug, Default)]
pub(super) struct Swept {
    /// Where each boundary edge of this strip starts, with the covered side on its left. Edges are numbered by their
    /// left end, from left to right and upward.
    pub(super) from: Vec<GridPoint>,
    /// Pairs of boundary edges: the second follows the first.
    pub(super) follows: Vec<(Name, Name)>,
    /// Boundary edges at the left end of a gap, and the boundary edge right below that end.
    pub(super) below: Vec<(Name, Name)>,
    /// Boundary edges of this strip that reach over a seam: number of the piece, number of the edge.
    pub(super) spans: Vec<(u32, Name)>,
    /// What lies around each of the points that were asked for, in their order.
    pub(super) located: Vec<Located>,
}

/// What lies around a point that is on no piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Located {
    pub(super) winding: [i32; 2],
    /// The boundary edge right below.
    pub(super) below: Option<Name>,
}

/// Which side of a piece is covered, if not both or neither.
#[derive(Clone, Copy, PartialEq)]
enum Boundary {
    None,
    CoveredAbove,
    CoveredBelow,
}

/// What the sweep knows about a piece after its left end has been passed.
#[derive(Clone, Copy)]
struct Known {
    above: [i32; 2],
    boundary: Boundary,
    name: Name,
}

/// Sweeps one strip, whose last grid column is `last`, and says what lies around some `points` of it (ascending).
pub(super) fn sweep_strip(
    pieces: &[Edge],
    spans: &Spans,
    strip: usize,
    last: i64,
    rule: Rule,
    points: impl Iterator<Item = GridPoint>,
) -> Swept {
    let mut pieces = in_order(pieces);
    let own = pieces.len();
    let mut entering: Vec<u32> = spans.entering(strip).to_vec();
    entering.sort_unstable_by(|&a, &b| upward_at_seam(&spans.piece(a), &spans.piece(b)));
    pieces.extend(entering.iter().map(|&number| spans.piece(number)));

    let mut sweep = Sweep::new(rule, (spans, strip), &pieces, last);
    sweep.enter(own, &entering);
    sweep.run(own, points);
    sweep.swept
}

/// The boundary pieces of what one operand covers, with windings that count it once.
pub(super) fn boundary(pieces: &[Edge], operand: usize, rule: Rule) -> Vec<Edge> {
    let pieces = in_order(pieces);
    let spans = Spans::default();
    let mut sweep = Sweep::new(rule, (&spans, 0), &pieces, i64::MAX);
    sweep.run(pieces.len(), std::iter::empty());
    let once = |(piece, known): (&Edge, &Known)| {
        let mut delta = [0, 0];
        delta[operand] = match known.boundary {
            Boundary::None => return None,
            Boundary::CoveredAbove => 1,
            Boundary::CoveredBelow => -1,
        };
        Some(Edge { delta, ..*piece })
    };
    pieces.iter().zip(&sweep.known).filter_map(once).collect()
}

struct Sweep<'a> {
    rule: Rule,
    spans: &'a Spans,
    strip: usize,
    pieces: &'a [Edge],
    /// Last grid column of the strip.
    last: i64,
    known: Vec<Known>,
    active: Active,
    /// The boundary edges around the present point, counter-clockwise from straight down; true if it leads away.
    around: Vec<(Name, bool)>,
    /// Those of them that end in the present point, from bottom to top.
    arriving: Vec<(Name, bool)>,
    swept: Swept,
}

impl<'a> Sweep<'a> {
    fn new(rule: Rule, (spans, strip): (&'a Spans, usize), pieces: &'a [Edge], last: i64) -> Self {
        let unknown = Known { above: [0, 0], boundary: Boundary::None, name: 0 };
        let known = vec![unknown; pieces.len()];
        Self {
            rule,
            spans,
            strip,
            pieces,
            last,
            known,
            active: Active::new(pieces.len()),
            around: Vec::new(),
            arriving: Vec::new(),
            swept: Swept::default(),
        }
    }

    /// Puts the pieces that come over the left seam in place; `pieces[own..]` are those, from bottom to top.
    fn enter(&mut self, own: usize, numbers: &[u32]) {
        let mut winding = [0, 0];
        for (piece, number) in (own..self.pieces.len()).zip(numbers) {
            winding = self.learn(piece, winding);
            self.known[piece].name = SPAN | number;
            self.active.insert(self.active.top(), index(piece)..index(piece + 1));
        }
    }

    /// Visits every grid point of the strip at which a piece begins or ends, from left to right and upward.
    fn run(&mut self, own: usize, points: impl Iterator<Item = GridPoint>) {
        let mut points = points.peekable();
        let pieces = self.pieces;
        let ends = ends_in_order(pieces, self.last);
        let (mut next_piece, mut next_end) = (0, 0);
        let end_at = |next: usize| ends.get(next).map(|&piece| pieces[piece as usize].r);
        loop {
            let begin = pieces[..own].get(next_piece).map(|piece| piece.l);
            let end = end_at(next_end);
            let at = match (begin, end) {
                (Some(begin), Some(end)) => begin.min(end),
                (Some(only), None) | (None, Some(only)) => only,
                (None, None) => break,
            };
            while let Some(point) = points.next_if(|&point| point < at) {
                self.locate(point);
            }
            let first = next_piece;
            while next_piece < own && pieces[next_piece].l == at {
                next_piece += 1;
            }
            let ending = if end == Some(at) { Some(ends[next_end]) } else { None };
            while end_at(next_end) == Some(at) {
                next_end += 1;
            }
            self.visit(at, first..next_piece, ending);
        }
        points.for_each(|point| self.locate(point));
    }

    /// Notes what lies around a point that is on no piece.
    fn locate(&mut self, point: GridPoint) {
        let pieces = self.pieces;
        let place = self.active.search(|piece| pieces[piece as usize].cross(point) > 0);
        let winding = self.active.below(place).map_or([0, 0], |under| self.known[under as usize].above);
        self.swept.located.push(Located { winding, below: self.boundary_below(place) });
    }

    /// The first boundary edge below a place.
    fn boundary_below(&self, place: Place) -> Option<Name> {
        let mut below = self.active.all_below(place).map(|piece| self.known[piece as usize]);
        below.find(|known| known.boundary != Boundary::None).map(|known| known.name)
    }

    /// Replaces the pieces that end at a point, of which one may be known, by those that begin there, from bottom to top.
    fn visit(&mut self, at: GridPoint, beginning: Range<usize>, ending: Option<u32>) {
        let place = self.take_ending(at, ending);
        let mut winding = self.active.below(place).map_or([0, 0], |under| self.known[under as usize].above);
        self.around.clear();
        for piece in beginning.clone() {
            winding = self.learn(piece, winding);
            self.name(piece);
            let Known { boundary, name, .. } = self.known[piece];
            if boundary != Boundary::None {
                self.around.push((name, boundary == Boundary::CoveredAbove));
            }
        }
        if self.arriving.is_empty() {
            self.note_gap(place);
        }
        self.around.extend(self.arriving.iter().rev());
        self.link();
        self.active.insert(place, index(beginning.start)..index(beginning.end));
    }

    /// Removes the pieces that end at a point, notes which are boundary edges, and returns the place they leave.
    fn take_ending(&mut self, at: GridPoint, ending: Option<u32>) -> Place {
        let (pieces, known, arriving) = (self.pieces, &self.known, &mut self.arriving);
        arriving.clear();
        let Some(ending) = ending else { return self.active.search(|piece| pieces[piece as usize].cross(at) > 0) };
        let mut lowest = self.active.place_of(ending);
        while self.active.below(lowest).is_some_and(|piece| pieces[piece as usize].r == at) {
            lowest = self.active.step_down(lowest);
        }
        self.active.remove_while(lowest, |piece| {
            let ends = pieces[piece as usize].r == at;
            let Known { boundary, name, .. } = known[piece as usize];
            if ends && boundary != Boundary::None {
                arriving.push((name, boundary == Boundary::CoveredBelow));
            }
            ends
        })
    }

    /// Each covered wedge between two boundary edges turns from the edge that arrives to the edge that leaves. So parts
    /// that touch in a point stay apart, and an outline never crosses itself.
    fn link(&mut self) {
        for (position, &(name, leaves)) in self.around.iter().enumerate() {
            if leaves {
                let (arriving, _) = self.around[(position + 1) % self.around.len()];
                self.swept.follows.push((arriving, name));
            }
        }
    }

    /// If a gap in a covered area begins at this point, notes which boundary edge is right below.
    fn note_gap(&mut self, place: Place) {
        let Some(&(name, false)) = self.around.first() else { return };
        if let Some(below) = self.boundary_below(place) {
            self.swept.below.push((name, below));
        }
    }

    /// Works out the sides of a piece from the winding below it; returns the winding above it.
    fn learn(&mut self, piece: usize, below: [i32; 2]) -> [i32; 2] {
        let delta = self.pieces[piece].delta;
        let above = [below[0] + delta[0], below[1] + delta[1]];
        let boundary = match (self.rule.covers(below), self.rule.covers(above)) {
            (false, true) => Boundary::CoveredAbove,
            (true, false) => Boundary::CoveredBelow,
            _ => Boundary::None,
        };
        self.known[piece].above = above;
        self.known[piece].boundary = boundary;
        above
    }

    /// Numbers a piece that begins in this strip, if it is a boundary edge.
    fn name(&mut self, piece: usize) {
        let e = &self.pieces[piece];
        let from = match self.known[piece].boundary {
            Boundary::None => return,
            Boundary::CoveredAbove => e.l,
            Boundary::CoveredBelow => e.r,
        };
        let name = index(self.swept.from.len());
        self.swept.from.push(from);
        self.known[piece].name = name;
        if e.r.x > self.last {
            self.swept.spans.push((self.spans.number_of(self.strip, e), name));
        }
    }
}

/// A number of a piece as it is stored.
#[expect(clippy::cast_possible_truncation, reason = "the number of edges is checked when they are gathered")]
fn index(piece: usize) -> u32 {
    piece as u32
}

/// The pieces in the order in which a sweep comes to them, coinciding ones made one.
fn in_order(pieces: &[Edge]) -> Vec<Edge> {
    let piece = |number: u32| &pieces[number as usize];
    let order =
        by_x((0u32..).zip(pieces).map(|(number, e)| (number, e.l.x)), |a, b| left_then_upward(piece(a), piece(b)));
    let mut sorted = Vec::with_capacity(pieces.len());
    order.into_iter().for_each(|number| push_merged(&mut sorted, *piece(number)));
    drop_last_cancelled(&mut sorted);
    sorted
}

/// Numbers of the pieces that end up to some grid column, in the order of their right ends.
fn ends_in_order(pieces: &[Edge], last: i64) -> Vec<u32> {
    let right = |number: u32| pieces[number as usize].r;
    let ending = (0u32..).zip(pieces).map(|(number, e)| (number, e.r.x)).filter(|&(_, x)| x <= last);
    by_x(ending, |a, b| (right(a), a).cmp(&(right(b), b)))
}

/// Order of the left ends, and from bottom to top around a common one.
fn left_then_upward(a: &Edge, b: &Edge) -> Ordering {
    a.l.cmp(&b.l).then_with(|| side(a.l, b.r, a.r))
}

/// Order from bottom to top of pieces that all cross one vertical line and do not cross each other.
fn upward_at_seam(a: &Edge, b: &Edge) -> Ordering {
    if a.l >= b.l { side(b.l, b.r, a.l).then_with(|| side(b.l, b.r, a.r)) } else { upward_at_seam(b, a).reverse() }
}
