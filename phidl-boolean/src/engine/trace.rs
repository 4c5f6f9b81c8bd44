//! The last stage: boundary edges of all strips are linked to rings, and each hole is assigned to its outer ring.

use super::{
    budget::Budget,
    input::Rule,
    isolated::IsolatedPolygons,
    sweep::{BoundaryEdges, BoundaryId, SPANNING, Surroundings},
};
use crate::{
    contours::Contours,
    error::BooleanError,
    jobs::both,
    point::{GridPoint, side, signed_area2},
    region::Region,
};

const UNKNOWN: u32 = u32::MAX;

/// Boundary edges between two looks at the budget.
const EDGES_PER_CHECK: u32 = 1 << 16;

/// Assembles the region from the boundary edges of all strips and the isolated polygons that bound it.
pub(super) fn trace(
    strips: &[BoundaryEdges],
    spanning: usize,
    isolated: &IsolatedPolygons,
    rule: Rule,
    budget: &Budget,
) -> Result<Region, BooleanError> {
    let numbering = EdgeNumbering::new(strips, spanning);
    let rings = TracedRings::follow(strips, &numbering, budget)?;
    let owners = rings.owners(strips, &numbering);
    let mut assembly = RingAssembly { traced: &rings.contours, isolated, rings: Vec::new() };
    assembly.rings.reserve(owners.len() + isolated.len());
    assembly.rings.extend(owners.iter().zip(0u32..).map(|(&owner, number)| Ring {
        number,
        kind: if owner == number { Kind::Outer } else { Kind::HoleOf(owner) },
        is_isolated: false,
    }));
    let surroundings = strips
        .iter()
        .enumerate()
        .flat_map(|(strip, edges)| edges.surroundings.iter().map(move |surroundings| (strip, surroundings)));
    for (number, (strip, around)) in (0u32..).zip(surroundings) {
        let owner = |id| owners[rings.ring_of[numbering.number(strip, id) as usize] as usize];
        if let Some(kind) = isolated_kind(number, around, isolated, rule, owner) {
            assembly.rings.push(Ring { number, kind, is_isolated: true });
        }
    }
    Ok(assembly.into_region())
}

/// The boundary edges of all strips, from start to end.
pub(super) fn boundary_edges(strips: &[BoundaryEdges], spanning: usize) -> Vec<[GridPoint; 2]> {
    let numbering = EdgeNumbering::new(strips, spanning);
    let (next, from) = (numbering.following(strips), starts(strips, numbering.total));
    from.iter().zip(next).map(|(&start, next)| [start, from[next as usize]]).collect()
}

/// What an isolated polygon bounds, if anything.
fn isolated_kind(
    number: u32,
    around: &Surroundings,
    isolated: &IsolatedPolygons,
    rule: Rule,
    owner: impl Fn(BoundaryId) -> u32,
) -> Option<Kind> {
    let inside = isolated.inside(number as usize, around.winding);
    match (rule.covers(around.winding), rule.covers(inside)) {
        (false, true) => Some(Kind::Outer),
        // The surroundings are covered, so there is a boundary below.
        (true, false) => around.below.map(|id| Kind::HoleOf(owner(id))),
        _ => None,
    }
}

/// A ring of the result.
#[derive(Clone, Copy)]
struct Ring {
    /// Among the traced rings, or among the isolated polygons.
    number: u32,
    kind: Kind,
    is_isolated: bool,
}

#[derive(Clone, Copy)]
enum Kind {
    Outer,
    /// A hole in a traced ring; isolated polygons have none.
    HoleOf(u32),
}

/// Sorts traced rings and isolated polygons, and puts each hole after its outer ring.
struct RingAssembly<'a> {
    traced: &'a Contours,
    isolated: &'a IsolatedPolygons,
    rings: Vec<Ring>,
}

impl RingAssembly<'_> {
    fn points(&self, ring: Ring) -> &[GridPoint] {
        let number = ring.number as usize;
        if ring.is_isolated { self.isolated.polygon(number) } else { self.traced.get(number).unwrap_or_default() }
    }

    fn start_vertex(&self, ring: Ring) -> GridPoint {
        if ring.is_isolated { self.isolated.begin(ring.number as usize) } else { self.points(ring)[0] }
    }

    fn into_region(mut self) -> Region {
        // Traced rings with one start vertex keep their order; isolated polygons share no vertex with others.
        let mut rings = std::mem::take(&mut self.rings);
        rings.sort_by_key(|&ring| self.start_vertex(ring));
        let mut holes: Vec<(u32, Ring)> = rings
            .iter()
            .filter_map(|&ring| if let Kind::HoleOf(owner) = ring.kind { Some((owner, ring)) } else { None })
            .collect();
        holes.sort_by_key(|&(owner, _)| owner);

        let total = rings.iter().map(|&ring| self.points(ring).len()).sum();
        let mut contours = Contours::with_capacity(rings.len(), total);
        let mut polygons = Vec::with_capacity(rings.len() - holes.len());
        for &ring in rings.iter().filter(|ring| matches!(ring.kind, Kind::Outer)) {
            polygons.push(contours.len());
            contours.push(self.points(ring).iter().copied());
            let own = if ring.is_isolated { 0 } else { holes.partition_point(|&(owner, _)| owner < ring.number) };
            let is_own = |hole: &&(u32, Ring)| !ring.is_isolated && hole.0 == ring.number;
            for &(_, hole) in holes[own..].iter().take_while(is_own) {
                push_hole(&mut contours, self.points(hole), hole.is_isolated);
            }
        }
        Region::from_parts(contours, polygons)
    }
}

/// Isolated polygons are stored counter-clockwise; as holes they are reversed, with the same start vertex.
fn push_hole(contours: &mut Contours, points: &[GridPoint], reverse: bool) {
    if reverse {
        contours.push(points[..1].iter().chain(points[1..].iter().rev()).copied());
    } else {
        contours.push(points.iter().copied());
    }
}

/// Numbers of the boundary edges over all strips.
struct EdgeNumbering {
    bases: Vec<u32>,
    spanning: Vec<u32>,
    total: usize,
}

impl EdgeNumbering {
    #[expect(clippy::cast_possible_truncation, reason = "the number of segments is checked when they are gathered")]
    fn new(strips: &[BoundaryEdges], spanning: usize) -> Self {
        let mut numbering =
            Self { bases: Vec::with_capacity(strips.len()), spanning: vec![UNKNOWN; spanning], total: 0 };
        for strip in strips {
            let base = numbering.total as u32;
            numbering.bases.push(base);
            numbering.total += strip.from.len();
            for &(segment, id) in &strip.spanning {
                numbering.spanning[segment as usize] = base + id;
            }
        }
        numbering
    }

    /// The boundary edge that follows each.
    fn following(&self, strips: &[BoundaryEdges]) -> Vec<u32> {
        let mut next = vec![UNKNOWN; self.total];
        for (strip, edges) in strips.iter().enumerate() {
            for &(edge, following) in &edges.follows {
                next[self.number(strip, edge) as usize] = self.number(strip, following);
            }
        }
        next
    }

    fn number(&self, strip: usize, id: BoundaryId) -> u32 {
        if id & SPANNING == 0 { self.bases[strip] + id } else { self.spanning[(id & !SPANNING) as usize] }
    }
}

/// The start of each boundary edge.
fn starts(strips: &[BoundaryEdges], edges: usize) -> Vec<GridPoint> {
    let mut from = Vec::with_capacity(edges);
    strips.iter().for_each(|strip| from.extend_from_slice(&strip.from));
    from
}

/// Closed rings in the order of their leftmost points, which are the start vertices.
struct TracedRings {
    contours: Contours,
    /// The number of the first edge of each ring; ascending.
    first_edges: Vec<u32>,
    ring_of: Vec<u32>,
}

impl TracedRings {
    fn follow(strips: &[BoundaryEdges], numbering: &EdgeNumbering, budget: &Budget) -> Result<Self, BooleanError> {
        let (next, from) = both(numbering.total, || numbering.following(strips), || starts(strips, numbering.total));
        let mut rings = Self {
            contours: Contours::with_capacity(0, numbering.total),
            first_edges: Vec::new(),
            ring_of: vec![UNKNOWN; numbering.total],
        };
        let mut points = Vec::new();
        for edge in (0u32..).take(numbering.total) {
            if edge.is_multiple_of(EDGES_PER_CHECK) {
                budget.check()?;
            }
            if rings.ring_of[edge as usize] == UNKNOWN {
                rings.follow_one(edge, &next, &from, &mut points);
            }
        }
        Ok(rings)
    }

    /// Traces the ring of its first edge, which touches the leftmost point of the ring.
    fn follow_one(&mut self, first: u32, next: &[u32], from: &[GridPoint], points: &mut Vec<GridPoint>) {
        #[expect(clippy::cast_possible_truncation, reason = "there are fewer rings than edges")]
        let number = self.first_edges.len() as u32;
        points.clear();
        let after = next[first as usize];
        let begin = if from[first as usize] < from[after as usize] { first } else { after };
        let mut edge = begin;
        loop {
            self.ring_of[edge as usize] = number;
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

    /// Hole assignment: the outer ring of each ring, which is itself unless it is a hole.
    fn owners(&self, strips: &[BoundaryEdges], numbering: &EdgeNumbering) -> Vec<u32> {
        let mut below = vec![UNKNOWN; self.first_edges.len()];
        for (strip, edges) in strips.iter().enumerate() {
            for &(edge, under) in &edges.below {
                let edge = numbering.number(strip, edge);
                let ring = self.ring_of[edge as usize] as usize;
                if self.first_edges[ring] == edge {
                    below[ring] = self.ring_of[numbering.number(strip, under) as usize];
                }
            }
        }
        let mut owners: Vec<u32> = Vec::with_capacity(below.len());
        for (number, (contour, under)) in (0u32..).zip(self.contours.iter().zip(below)) {
            // The ring below the leftmost point of a hole begins further left, so its owner is known.
            let owner = if signed_area2(contour) < 0 { owners[under as usize] } else { number };
            owners.push(owner);
        }
        owners
    }
}

/// Adds a point to a ring; the point before it goes if it is no corner.
fn push_corner(points: &mut Vec<GridPoint>, point: GridPoint) {
    while let [.., a, b] = points[..] {
        if side(a, b, point).is_ne() {
            break;
        }
        points.pop();
    }
    points.push(point);
}

/// Drops last points that are no corners; the first point is leftmost and therefore a corner.
fn close_corners(points: &mut Vec<GridPoint>) {
    while let [first, .., a, b] = points[..] {
        if side(a, b, first).is_ne() {
            break;
        }
        points.pop();
    }
}
