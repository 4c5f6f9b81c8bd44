//! From the facts of all strips to outlines: follow the boundary edges, then give each hole to its outline.

use super::{
    Rule,
    free::Free,
    sweep::{Located, Name, SPAN, Swept},
};
use crate::{
    contours::Contours,
    jobs::both,
    point::{GridPoint, side, signed_area2},
    region::Region,
};

const UNKNOWN: u32 = u32::MAX;

/// Draws the region whose boundary edges the strips have found, with the free outlines that bound it.
pub(super) fn trace(strips: &[Swept], spans: usize, free: &Free, rule: Rule) -> Region {
    let names = Names::new(strips, spans);
    let outlines = Outlines::follow(strips, &names);
    let owners = outlines.owners(strips, &names);
    let mut assembly = Assembly { outlines: &outlines.contours, free, parts: Vec::new() };
    assembly.parts.reserve(owners.len() + free.len());
    assembly.parts.extend(owners.iter().zip(0u32..).map(|(&owner, number)| Part {
        number,
        kind: if owner == number { Kind::Outer } else { Kind::HoleOf(owner) },
        is_free: false,
    }));
    let located = strips.iter().enumerate().flat_map(|(strip, swept)| swept.located.iter().map(move |l| (strip, l)));
    for (number, (strip, around)) in (0u32..).zip(located) {
        let owner = |name| owners[outlines.outline_of[names.number(strip, name) as usize] as usize];
        if let Some(kind) = free_kind(number, around, free, rule, owner) {
            assembly.parts.push(Part { number, kind, is_free: true });
        }
    }
    assembly.into_region()
}

/// What a free outline bounds, if anything.
fn free_kind(number: u32, around: &Located, free: &Free, rule: Rule, owner: impl Fn(Name) -> u32) -> Option<Kind> {
    let inside = free.inside(number as usize, around.winding);
    match (rule.covers(around.winding), rule.covers(inside)) {
        (false, true) => Some(Kind::Outer),
        // Around it is covered, so there is a boundary below it.
        (true, false) => around.below.map(|name| Kind::HoleOf(owner(name))),
        _ => None,
    }
}

/// An outline of the result.
#[derive(Clone, Copy)]
struct Part {
    /// Among the traced outlines, or among the free ones.
    number: u32,
    kind: Kind,
    is_free: bool,
}

#[derive(Clone, Copy)]
enum Kind {
    Outer,
    /// A hole in a traced outline; free ones have none.
    HoleOf(u32),
}

/// Puts traced and free outlines in order.
struct Assembly<'a> {
    outlines: &'a Contours,
    free: &'a Free,
    parts: Vec<Part>,
}

impl Assembly<'_> {
    fn points(&self, part: Part) -> &[GridPoint] {
        let number = part.number as usize;
        if part.is_free { self.free.outline(number) } else { self.outlines.get(number).unwrap_or_default() }
    }

    fn begin(&self, part: Part) -> GridPoint {
        if part.is_free { self.free.begin(part.number as usize) } else { self.points(part)[0] }
    }

    fn into_region(mut self) -> Region {
        // Traced outlines that begin in one point keep their order; free ones share no point with others.
        let mut parts = std::mem::take(&mut self.parts);
        parts.sort_by_key(|&part| self.begin(part));
        let mut holes: Vec<(u32, Part)> = parts
            .iter()
            .filter_map(|&part| if let Kind::HoleOf(owner) = part.kind { Some((owner, part)) } else { None })
            .collect();
        holes.sort_by_key(|&(owner, _)| owner);

        let total = parts.iter().map(|&part| self.points(part).len()).sum();
        let mut contours = Contours::with_capacity(parts.len(), total);
        let mut polygons = Vec::with_capacity(parts.len() - holes.len());
        for &part in parts.iter().filter(|part| matches!(part.kind, Kind::Outer)) {
            polygons.push(contours.len());
            contours.push(self.points(part).iter().copied());
            let own = if part.is_free { 0 } else { holes.partition_point(|&(owner, _)| owner < part.number) };
            let is_own = |hole: &&(u32, Part)| !part.is_free && hole.0 == part.number;
            for &(_, hole) in holes[own..].iter().take_while(is_own) {
                push_hole(&mut contours, self.points(hole), hole.is_free);
            }
        }
        Region::from_parts(contours, polygons)
    }
}

/// Free outlines are stored counter-clockwise; as holes they run the other way, from the same point.
fn push_hole(contours: &mut Contours, points: &[GridPoint], turn: bool) {
    if turn {
        contours.push(points[..1].iter().chain(points[1..].iter().rev()).copied());
    } else {
        contours.push(points.iter().copied());
    }
}

/// Turns the names that the strips use into numbers over all strips.
struct Names {
    bases: Vec<u32>,
    spans: Vec<u32>,
    total: usize,
}

impl Names {
    #[expect(clippy::cast_possible_truncation, reason = "the number of edges is checked when they are gathered")]
    fn new(strips: &[Swept], spans: usize) -> Self {
        let mut names = Self { bases: Vec::with_capacity(strips.len()), spans: vec![UNKNOWN; spans], total: 0 };
        for strip in strips {
            let base = names.total as u32;
            names.bases.push(base);
            names.total += strip.from.len();
            for &(span, name) in &strip.spans {
                names.spans[span as usize] = base + name;
            }
        }
        names
    }

    /// The boundary edge that follows each.
    fn following(&self, strips: &[Swept]) -> Vec<u32> {
        let mut next = vec![UNKNOWN; self.total];
        for (strip, swept) in strips.iter().enumerate() {
            for &(edge, following) in &swept.follows {
                next[self.number(strip, edge) as usize] = self.number(strip, following);
            }
        }
        next
    }

    fn number(&self, strip: usize, name: Name) -> u32 {
        if name & SPAN == 0 { self.bases[strip] + name } else { self.spans[(name & !SPAN) as usize] }
    }
}

/// Where each boundary edge starts.
fn begins(strips: &[Swept], edges: usize) -> Vec<GridPoint> {
    let mut from = Vec::with_capacity(edges);
    strips.iter().for_each(|strip| from.extend_from_slice(&strip.from));
    from
}

/// Closed outlines in the order of their leftmost points, which is where each begins.
struct Outlines {
    contours: Contours,
    /// The number of the first edge of each outline; ascending.
    first_edges: Vec<u32>,
    outline_of: Vec<u32>,
}

impl Outlines {
    fn follow(strips: &[Swept], names: &Names) -> Self {
        let (next, from) = both(names.total, || names.following(strips), || begins(strips, names.total));
        let mut outlines = Self {
            contours: Contours::with_capacity(0, names.total),
            first_edges: Vec::new(),
            outline_of: vec![UNKNOWN; names.total],
        };
        let mut points = Vec::new();
        for edge in (0u32..).take(names.total) {
            if outlines.outline_of[edge as usize] == UNKNOWN {
                outlines.follow_one(edge, &next, &from, &mut points);
            }
        }
        outlines
    }

    /// The first edge of an outline that we come to touches the leftmost point of it.
    fn follow_one(&mut self, first: u32, next: &[u32], from: &[GridPoint], points: &mut Vec<GridPoint>) {
        #[expect(clippy::cast_possible_truncation, reason = "there are fewer outlines than edges")]
        let number = self.first_edges.len() as u32;
        points.clear();
        let after = next[first as usize];
        let begin = if from[first as usize] < from[after as usize] { first } else { after };
        let mut edge = begin;
        loop {
            self.outline_of[edge as usize] = number;
            push_corner(points, from[edge as usize]);
            edge = next[edge as usize];
            if edge == begin {
                break;
            }
        }
        close_corners(points);
        self.first_edges.push(first);
        self.contours.push(points.iter().copied());
    }

    /// The outline that owns each outline: itself, or for a hole the one around it.
    fn owners(&self, strips: &[Swept], names: &Names) -> Vec<u32> {
        let mut below = vec![UNKNOWN; self.first_edges.len()];
        for (strip, swept) in strips.iter().enumerate() {
            for &(edge, under) in &swept.below {
                let edge = names.number(strip, edge);
                let outline = self.outline_of[edge as usize] as usize;
                if self.first_edges[outline] == edge {
                    below[outline] = self.outline_of[names.number(strip, under) as usize];
                }
            }
        }
        let mut owners: Vec<u32> = Vec::with_capacity(below.len());
        for (number, (contour, under)) in (0u32..).zip(self.contours.iter().zip(below)) {
            // What is below the leftmost point of a hole began further left, so its owner is known.
            let owner = if signed_area2(contour) < 0 { owners[under as usize] } else { number };
            owners.push(owner);
        }
        owners
    }
}

/// Adds a point to an outline; the point before it goes if it is no corner.
fn push_corner(points: &mut Vec<GridPoint>, point: GridPoint) {
    while let [.., a, b] = points[..] {
        if side(a, b, point).is_ne() {
            break;
        }
        points.pop();
    }
    points.push(point);
}

/// The first point is the leftmost and so a corner, but the last one may not be.
fn close_corners(points: &mut Vec<GridPoint>) {
    while let [first, .., a, b] = points[..] {
        if side(a, b, first).is_ne() {
            break;
        }
        points.pop();
    }
}
