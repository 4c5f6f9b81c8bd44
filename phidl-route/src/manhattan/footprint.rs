//! [`Footprint`]: the areas that a wire covers, as convex quadrilaterals, and which of them overlap.
//!
//! The test is made on the drawn wire, with its width and with bends that cut the corners. A line without width was rejected:
//! it shows neither that two legs touch nor that two corners do not.
//!
//! Footprints with fewer than three corners between them are never compared. They cannot overlap as long as no bend is
//! tighter than half the width: with one corner between them two legs are the sides of a bend, with two they are the sides
//! of a U (at least two radii from each other) or of an S, and of three bends in a row each lies in its own quadrant.

use std::cell::OnceCell;
use std::rc::Rc;

use phidl_core::geom::{Point, Rect};
use phidl_core::{Error, Result};
use phidl_path::Bend as _;

use super::RouteBend;
use crate::port_pair::left_of;

/// Pieces that share a strip no wider than this (µm) only touch: rounding.
const TOUCH: f64 = 1e-6;
/// Half of the width (µm) that a line without width gets: a step of the usual database grid.
const THINNEST: f64 = 0.5e-3;
/// Number of quadrilaterals that cover a bend. At 90° they extend beyond it by 0.05 % of its outer radius.
const SLICES: usize = 24;
/// Maximum number of overlaps that are counted: it bounds the time for a wire that is wider than the distance of its bumps.
const MOST_OVERLAPS: usize = 1000;
/// Smallest difference of the indices of two footprints that are compared: legs have even indices, corners odd ones.
const INDEX_DISTANCE: usize = 6;

/// A right angle, and the difference (degrees) within which two bends are equal.
const RIGHT: f64 = 90.0;
const ALIKE: f64 = 1e-6;

/// A convex quadrilateral, counter-clockwise or not.
type Quad = [Point; 4];

/// A wire: its width and its bends.
#[derive(Debug)]
pub(crate) struct Wire {
    half_width: f64,
    bend: Option<(RouteBend, f64)>,
    /// Bends to the left, by the angles at which they were needed.
    shapes: Vec<Rc<Shape>>,
}

/// A bend to the left from the origin heading right.
#[derive(Debug)]
struct Shape {
    /// Its turn (degrees).
    angle: f64,
    /// Distance before its corner at which it starts (µm).
    extent: f64,
    /// A box around it.
    bounds: Rect,
    half_width: f64,
    bend: Option<(RouteBend, f64)>,
    /// Computed on demand: most bends are far from other footprints.
    quads: OnceCell<Vec<Quad>>,
}

/// A leg or a bend of a wire.
#[derive(Debug, Clone)]
pub(crate) struct Footprint {
    /// Its index along the wire: leg, corner, leg, corner …
    index: usize,
    bounds: Rect,
    covered: Covered,
}

#[derive(Debug, Clone)]
enum Covered {
    Straight(Quad),
    /// A shape from a point, along a direction, to the left of it or mirrored.
    Bend(Rc<Shape>, [Point; 3]),
}

impl Wire {
    /// A wire with bends of a radius (µm) at its corners.
    pub(crate) fn with_bends(width: f64, bend: RouteBend, radius: f64) -> Self {
        Self { half_width: (width / 2.0).max(THINNEST), bend: Some((bend, radius)), shapes: Vec::new() }
    }

    /// A line without width, with sharp corners.
    pub(crate) fn sharp() -> Self {
        Self { half_width: THINNEST, bend: None, shapes: Vec::new() }
    }

    /// The footprints of a wire along waypoints.
    pub(crate) fn footprints(&mut self, points: &[Point]) -> Result<Vec<Footprint>> {
        let legs: Vec<Point> = points.windows(2).map(|leg| (leg[1] - leg[0]) / leg[0].distance(leg[1])).collect();
        let mut footprints = Vec::with_capacity(2 * legs.len());
        let mut from = points[0];
        for (leg, along) in legs.iter().enumerate() {
            if leg > 0 {
                footprints.push(self.corner(leg, points[leg], legs[leg - 1], *along)?);
            }
            let extent = legs.get(leg + 1).map_or(Ok(0.0), |after| self.extent(*along, *after))?;
            footprints.push(self.leg(leg, from, points[leg + 1] - *along * extent));
            from = legs.get(leg + 1).map_or(from, |after| points[leg + 1] + *after * extent);
        }
        Ok(footprints)
    }

    /// The straight part of a leg.
    pub(crate) fn leg(&self, leg: usize, from: Point, to: Point) -> Footprint {
        Footprint::straight(2 * leg, from, to, self.half_width)
    }

    /// The bend before a leg, at the corner between two directions.
    pub(crate) fn corner(&mut self, leg: usize, at: Point, before: Point, after: Point) -> Result<Footprint> {
        let shape = Rc::clone(self.shape(before, after)?);
        let side = if before.cross(after) < 0.0 { -1.0 } else { 1.0 };
        let frame = [at - before * shape.extent, before, left_of(before) * side];
        let bounds = around(shape.bounds.corners().map(|p| placed(p, &frame)));
        Ok(Footprint { index: 2 * leg - 1, bounds, covered: Covered::Bend(shape, frame) })
    }

    /// How far the bend between two directions reaches (µm).
    pub(crate) fn extent(&mut self, before: Point, after: Point) -> Result<f64> {
        self.shape(before, after).map(|shape| shape.extent)
    }

    fn shape(&mut self, before: Point, after: Point) -> Result<&Rc<Shape>> {
        let angle = before.cross(after).abs().atan2(before.dot(after)).to_degrees();
        let number = match self.shapes.iter().position(|shape| (shape.angle - angle).abs() < ALIKE) {
            Some(number) => number,
            None => {
                self.shapes.push(Rc::new(Shape::new(self.bend, angle, self.half_width)?));
                self.shapes.len() - 1
            }
        };
        Ok(&self.shapes[number])
    }
}

impl Shape {
    fn new(bend: Option<(RouteBend, f64)>, angle: f64, half_width: f64) -> Result<Self> {
        if !angle.is_finite() {
            // Legs of no length, or of infinite length.
            return Err(Error::custom("route", "two waypoints are equal or infinitely far from each other"));
        }
        let extent = bend.map_or(Ok(0.0), |(bend, radius)| bend.extent(radius, angle))?;
        // Between its tangents, and so in the triangle that they make with its chord.
        let corner = Point::new(extent, 0.0);
        let mut bounds = around([Point::ORIGIN, corner, corner + Point::polar(extent, angle)]).grown(half_width);
        // But never behind its faces, or it would seem to overlap the legs that it joins.
        if angle < RIGHT + ALIKE && bend.is_some() {
            bounds.min.x = 0.0;
            bounds.max.y = if angle > RIGHT - ALIKE { extent } else { bounds.max.y };
        }
        Ok(Self { angle, extent, bounds, half_width, bend, quads: OnceCell::new() })
    }

    fn quads(&self) -> &[Quad] {
        self.quads.get_or_init(|| match self.bend {
            None => vec![[(-1, -1), (1, -1), (1, 1), (-1, 1)].map(|p| Point::from(p) * self.half_width)],
            Some((bend, radius)) => {
                let path = bend.bend(radius, self.angle).expect("invariant: a bend that has a extent can be drawn");
                slices(path.points(), self.angle, self.half_width)
            }
        })
    }
}

/// The quadrilaterals over a bend to the left with these points that turns by an angle (degrees).
fn slices(points: &[Point], angle: f64, half_width: f64) -> Vec<Quad> {
    let last = points.len() - 1;
    let normal = |i: usize| match i {
        0 => Point::new(0.0, 1.0),
        i if i == last => Point::polar(1.0, angle + 90.0),
        i => left_of(points[i + 1] - points[i - 1]) / points[i + 1].distance(points[i - 1]),
    };
    let edges = |i: usize| [points[i] + normal(i) * half_width, points[i] - normal(i) * half_width];
    let edges: Vec<[Point; 2]> = (0..=last).map(edges).collect();
    let slice = last.div_ceil(SLICES);
    (0..last).step_by(slice).map(|from| covering(&edges[from..=(from + slice).min(last)])).collect()
}

/// The quadrilateral over a part of a bend to the left, given by its inner and outer edge. The chord of the inner edge lies
/// outside the edge; the chord of the outer edge is moved outwards.
fn covering(edges: &[[Point; 2]]) -> Quad {
    let [[inner1, outer1], [inner2, outer2]] = [edges[0], edges[edges.len() - 1]];
    let chord = outer2 - outer1;
    let out = -left_of(chord / chord.norm());
    let most = edges.iter().map(|[_, outer]| (*outer - outer1).dot(out)).fold(0.0, f64::max);
    [inner1, outer1 + out * most, outer2 + out * most, inner2]
}

/// A point of a shape in a frame.
fn placed(p: Point, [origin, along, left]: &[Point; 3]) -> Point {
    *origin + *along * p.x + *left * p.y
}

fn around(points: impl IntoIterator<Item = Point>) -> Rect {
    Rect::around(points).expect("invariant: there is no footprint without points")
}

impl Footprint {
    fn straight(index: usize, from: Point, to: Point, half_width: f64) -> Self {
        let (along, length) = (to - from, from.distance(to));
        let left = if length > 0.0 { left_of(along / length) * half_width } else { Point::ORIGIN };
        let quad = [from + left, from - left, to - left, to + left];
        Self { index, bounds: around(quad), covered: Covered::Straight(quad) }
    }

    /// Something straight that is no part of the wire.
    pub(crate) fn obstacle(from: Point, to: Point, width: f64) -> Self {
        Self::straight(0, from, to, width / 2.0)
    }

    /// Whether two footprints lie on one another, and do not only touch.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        boxes_overlap(&self.bounds, &other.bounds) && self.depths(other).any(|depth| depth > TOUCH)
    }

    /// The distance by which two footprints would have to be separated so that they only touch (µm).
    pub(crate) fn depth(&self, other: &Self) -> f64 {
        match boxes_overlap(&self.bounds, &other.bounds) {
            true => self.depths(other).fold(0.0, f64::max),
            false => 0.0,
        }
    }

    fn depths(&self, other: &Self) -> impl Iterator<Item = f64> {
        let (own, others) = (self.quads_in(&other.bounds), other.quads_in(&self.bounds));
        own.into_iter().flat_map(move |(quad, bounds)| {
            let near = others.iter().filter(|(_, other)| boxes_overlap(&bounds, other));
            near.map(|(other, _)| depth(&quad, other)).reduce(f64::max)
        })
    }

    /// The quadrilaterals that extent into a box, each with its own.
    fn quads_in(&self, bounds: &Rect) -> Vec<(Quad, Rect)> {
        let boxed = self.quads().map(|quad| (quad, around(quad)));
        boxed.filter(|(_, own)| boxes_overlap(own, bounds)).collect()
    }

    /// Whether two footprints of one wire overlap.
    pub(crate) fn lies_on(&self, other: &Self) -> bool {
        self.index.abs_diff(other.index) >= INDEX_DISTANCE && self.overlaps(other)
    }

    fn quads(&self) -> impl Iterator<Item = Quad> {
        let (quads, frame) = match &self.covered {
            Covered::Straight(quad) => (std::slice::from_ref(quad), None),
            Covered::Bend(shape, frame) => (shape.quads(), Some(frame)),
        };
        quads.iter().map(move |quad| frame.map_or(*quad, |frame| quad.map(|p| placed(p, frame))))
    }
}

fn boxes_overlap(a: &Rect, b: &Rect) -> bool {
    let shared = |from: f64, to: f64| to - from > TOUCH;
    shared(a.min.x.max(b.min.x), a.max.x.min(b.max.x)) && shared(a.min.y.max(b.min.y), a.max.y.min(b.max.y))
}

/// The smallest overlap of two convex quadrilaterals across one of their edges (µm); 0 if they do not overlap.
fn depth(a: &Quad, b: &Quad) -> f64 {
    let least = |a: &Quad, b: &Quad, most: f64| {
        let sides = (0..4).map(|i| [a[i], a[(i + 1) % 4]]).filter(|[from, to]| from != to);
        sides.map(|side| shared_across(side, a, b)).fold(most, f64::min)
    };
    let most = least(a, b, f64::INFINITY);
    if most > 0.0 { least(b, a, most).max(0.0) } else { 0.0 }
}

/// The overlap of two quadrilaterals on the line across an edge (µm); negative if they are separated there.
fn shared_across([from, to]: [Point; 2], a: &Quad, b: &Quad) -> f64 {
    let across = left_of((to - from) / from.distance(to));
    let span = |quad: &Quad| {
        let at = quad.map(|p| (p - from).dot(across));
        (at.into_iter().fold(f64::INFINITY, f64::min), at.into_iter().fold(f64::NEG_INFINITY, f64::max))
    };
    let ((from_a, to_a), (from_b, to_b)) = (span(a), span(b));
    to_a.min(to_b) - from_a.max(from_b)
}

/// The number of pairs of footprints of a wire that overlap, at most [`MOST_OVERLAPS`].
pub(crate) fn self_overlaps(footprints: &[Footprint]) -> usize {
    if footprints.len() <= INDEX_DISTANCE {
        return 0;
    }
    pairs(footprints).filter(|[a, b]| a.lies_on(b)).take(MOST_OVERLAPS).count()
}

/// Pairs of footprints whose boxes share a stretch of the longer side of the whole: few, where many footprints follow each other.
fn pairs(footprints: &[Footprint]) -> impl Iterator<Item = [&Footprint; 2]> {
    let whole = Rect::around(footprints.iter().flat_map(|footprint| [footprint.bounds.min, footprint.bounds.max]));
    let upright = whole.is_some_and(|whole| whole.size().height > whole.size().width);
    let range = move |footprint: &Footprint| match upright {
        true => (footprint.bounds.min.y, footprint.bounds.max.y),
        false => (footprint.bounds.min.x, footprint.bounds.max.x),
    };
    let mut sorted: Vec<&Footprint> = footprints.iter().collect();
    sorted.sort_by(|a, b| range(a).0.total_cmp(&range(b).0));
    let neighbors = move |i: usize| {
        let reached = range(sorted[i]).1;
        let near = sorted[i + 1..].iter().take_while(|other| range(other).0 < reached);
        near.map(|other| [sorted[i], *other]).collect::<Vec<_>>()
    };
    (0..footprints.len()).flat_map(neighbors)
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::place::Bounded as _;

    fn overlaps(width: f64, points: &[(f64, f64)]) -> usize {
        let points: Vec<Point> = points.iter().copied().map(Point::from).collect();
        let count = |points: &[Point]| {
            let footprints = Wire::with_bends(width, RouteBend::Circular, 5.0).footprints(points).unwrap();
            self_overlaps(&footprints)
        };
        let turn = phidl_core::geom::Transform::rotation(37.0);
        let turned: Vec<Point> = points.iter().map(|p| turn.apply(*p + Point::new(1e3, 3e2))).collect();
        assert_eq!(count(&points) == 0, count(&turned) == 0, "a turned wire overlaps like the upright one");
        count(&points)
    }

    #[test]
    fn a_wire_overlaps_itself_as_soon_as_its_edges_do() {
        // A leg that ends 4 µm above the first one.
        let hook = [(0., 0.), (40., 0.), (40., -20.), (20., -20.), (20., -4.)];
        assert_eq!(overlaps(3.999, &hook), 0, "the end of the leg is half a width from the axis of the other");
        assert_eq!(overlaps(7.99, &hook), 0, "its face touches the other's edge");
        assert_eq!(overlaps(8.01, &hook), 1);
    }

    #[test]
    fn bends_are_cut_across_their_corners() {
        // The line goes on through its own first corner, whose bend passes 5 µm · (√2 − 1) beside it.
        let spiral = [(-30., 0.), (0., 0.), (0., 40.), (-60., 40.), (-60., -30.), (20., -30.), (20., 0.), (-0.2, 0.)];
        assert_eq!(overlaps(0.5, &spiral), 0);
        assert!(overlaps(3.5, &spiral) > 0);
    }

    #[test]
    fn bends_as_tight_as_half_the_width_touch_and_do_not_overlap() {
        let meander = [(0., 0.), (20., 0.), (20., 10.), (0., 10.), (0., 20.), (31., 20.), (31., 0.), (50., 0.)];
        assert_eq!(overlaps(10.0, &meander), 0);
    }

    #[test]
    fn a_wire_covers_no_less_than_what_is_drawn() {
        for bend in [RouteBend::Circular, RouteBend::Euler, RouteBend::Gradual] {
            for angle in [40.0, 90.0] {
                let shape = Shape::new(Some((bend, 7.0)), angle, 2.0).unwrap();
                let path = bend.bend(7.0, angle).unwrap();
                let drawn = path.extrude_width(4, 1).unwrap();
                let drawn_area = drawn.polygons().next().unwrap().area();
                let covered: f64 = shape.quads().iter().map(|quad| phidl_core::geom::signed_area(quad).abs()).sum();
                assert!(covered >= drawn_area && covered < 1.004 * drawn_area, "{bend:?}: {covered} {drawn_area}");
                let [min, max] = drawn.bbox().map(|b| [b.min, b.max]).unwrap();
                assert!([min, max].iter().all(|p| shape.bounds.grown(1e-9).contains(*p)), "{bend:?} {angle}");
            }
        }
    }
}
