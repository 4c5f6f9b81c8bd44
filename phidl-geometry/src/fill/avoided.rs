//! [`AvoidedArea`]: the area that a fill has to keep away from, as the edges around it and the polygons that make it up.
//!
//! It is what the avoided polygons cover without what the included ones cover. A raster only needs to know how near a
//! cell is to an edge and whether its middle is inside, so no new polygons are made: where polygons of the two kinds
//! meet, edges are cut at all crossings, and the fragments with avoided area on one side are kept. A boolean engine was
//! rejected: it rounds the area to a grid first, and margins would not be exact. Nearby edges are found in an R-tree.

use phidl_core::prelude::*;
use rstar::primitives::{GeomWithData, Line, Rectangle};
use rstar::{AABB, RTree};

/// Distance from an edge fragment at which the area is probed (µm); thinner slivers do not count.
const PROBE: f64 = 1e-7;
/// Sine of the angle below which two edges may lie on each other although their coordinates were rounded.
const PARALLEL: f64 = 1e-6;

/// An edge, from corner to corner.
pub(super) type Edge = (Point, Point);

/// The area that a fill has to keep away from.
#[derive(Debug)]
pub(super) struct AvoidedArea {
    /// The edges around the area; some may lie inside.
    pub(super) edges: Vec<Edge>,
    /// What is avoided, even-odd in each polygon.
    pub(super) solid: Vec<Outline>,
    /// What is cut out of it.
    pub(super) open: Vec<Outline>,
}

/// A polygon with the box around it.
#[derive(Debug)]
pub(super) struct Outline {
    pub(super) points: Vec<Point>,
    pub(super) bbox: Rect,
}

impl Outline {
    pub(super) fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        let next = self.points.iter().cycle().skip(1);
        self.points.iter().copied().zip(next.copied())
    }
}

/// Where the line through two points of different heights has this height.
pub(super) fn crossing(a: Point, b: Point, y: f64) -> f64 {
    a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)
}

impl AvoidedArea {
    /// What the polygons on avoided layers cover without those on included layers.
    pub(super) fn of(device: &Device, avoided: impl Fn(Layer) -> bool, included: &Layers) -> Self {
        let (mut solid, mut open) = (Vec::new(), Vec::new());
        for polygon in device.flat_polygons() {
            let points: Vec<Point> = polygon.points().collect();
            let Some(bbox) = Rect::around(points.iter().copied()) else { continue };
            match polygon.layer {
                Some(layer) if included.contains(layer) => open.push(Outline { points, bbox }),
                Some(layer) if avoided(layer) => solid.push(Outline { points, bbox }),
                _ => {}
            }
        }
        let edges = Index::of(&solid, &open).edges();
        Self { edges, solid, open }
    }

    /// The surroundings of a region: everything that no polygon of the device covers, in a box and around it.
    pub(super) fn outside(region: &Device, within: Rect) -> Self {
        let outline = |points: Vec<Point>| {
            let bbox = Rect::around(points.iter().copied())?;
            Some(Outline { points, bbox })
        };
        let open: Vec<Outline> =
            region.flat_polygons().filter_map(|polygon| outline(polygon.points().collect())).collect();
        // Larger than all polygons, so that its own edges are far from the box.
        let all = open.iter().fold(within, |all, outline| all.union(outline.bbox));
        let (Point { x: l, y: b }, Point { x: r, y: t }) = {
            let all = all.grown(1.0 + all.size().width.max(all.size().height));
            (all.min, all.max)
        };
        let solid: Vec<Outline> =
            outline([(l, b), (r, b), (r, t), (l, t)].map(Point::from).to_vec()).into_iter().collect();
        let edges = Index::of(&solid, &open).edges();
        Self { edges, solid, open }
    }
}

/// Spatial index over all polygons and their edges.
struct Index<'a> {
    /// First those that are avoided, then the open ones.
    outlines: Vec<&'a Outline>,
    /// How many are avoided.
    solid: usize,
    boxes: RTree<GeomWithData<Rectangle<[f64; 2]>, usize>>,
    /// Each with the number of its polygon.
    sides: RTree<GeomWithData<Line<[f64; 2]>, usize>>,
}

impl<'a> Index<'a> {
    fn of(solid: &'a [Outline], open: &'a [Outline]) -> Self {
        let outlines: Vec<&Outline> = solid.iter().chain(open).collect();
        let boxes = outlines.iter().enumerate().map(|(n, outline)| GeomWithData::new(envelope(outline.bbox).into(), n));
        let boxes = RTree::bulk_load(boxes.collect());
        // Nothing is looked for among edges if there is only one kind.
        let crossed = if solid.is_empty() || open.is_empty() { &[] } else { outlines.as_slice() };
        let side = |n, (a, b): Edge| GeomWithData::new(Line::new([a.x, a.y], [b.x, b.y]), n);
        let sides = crossed.iter().enumerate().flat_map(|(n, outline)| outline.edges().map(move |edge| side(n, edge)));
        let sides = RTree::bulk_load(sides.collect());
        Self { outlines, solid: solid.len(), boxes, sides }
    }

    /// The edges around what is avoided and not open.
    fn edges(&self) -> Vec<Edge> {
        let edges = |(n, outline): (usize, &&Outline)| match (self.meets_the_other_kind(n), n < self.solid) {
            (true, _) => outline.edges().flat_map(|edge| self.fragments(edge)).collect(),
            (false, true) => outline.edges().collect(),
            (false, false) => Vec::new(),
        };
        self.outlines.iter().enumerate().flat_map(edges).collect()
    }

    /// Whether the box of this polygon touches the box of a polygon of the other kind.
    fn meets_the_other_kind(&self, n: usize) -> bool {
        let near = self.boxes.locate_in_envelope_intersecting(&envelope(self.outlines[n].bbox));
        near.into_iter().any(|other| (other.data < self.solid) != (n < self.solid))
    }

    /// The fragments of an edge with avoided area on one side.
    fn fragments(&self, (a, b): Edge) -> Vec<Edge> {
        let near = self.sides.locate_in_envelope_intersecting(&envelope(Rect::new(a, b)));
        let near = near.map(|side| (side.geom().from.into(), side.geom().to.into()));
        let mut fragments = fragments((a, b), near);
        fragments.retain(|fragment| has_area_beside(*fragment, |p| self.is_avoided(p)));
        fragments
    }

    /// Whether a point lies in an avoided polygon and in no open one.
    fn is_avoided(&self, p: Point) -> bool {
        let around = self.boxes.locate_in_envelope_intersecting(&envelope(Rect::new(p, p)));
        let (solid, open): (Vec<usize>, Vec<usize>) = around.map(|found| found.data).partition(|n| *n < self.solid);
        solid.into_iter().any(|n| self.is_inside(n, p)) && !open.into_iter().any(|n| self.is_inside(n, p))
    }

    /// Whether a point lies inside a polygon, even-odd. The result for points on an edge is not defined.
    fn is_inside(&self, n: usize, p: Point) -> bool {
        let ray = Rect::new(p, (self.outlines[n].bbox.max.x, p.y));
        let crossed = self.sides.locate_in_envelope_intersecting(&envelope(ray)).filter(|side| {
            let (a, b): Edge = (side.geom().from.into(), side.geom().to.into());
            side.data == n && (a.y <= p.y) != (b.y <= p.y) && p.x < crossing(a, b, p.y)
        });
        crossed.count() % 2 == 1
    }
}

fn envelope(rect: Rect) -> AABB<[f64; 2]> {
    AABB::from_corners([rect.min.x, rect.min.y], [rect.max.x, rect.max.y])
}

/// An edge cut wherever another one crosses or joins it. Cuts elsewhere would do no harm.
fn fragments((a, b): Edge, edges: impl Iterator<Item = Edge>) -> Vec<Edge> {
    let along = b - a;
    let mut cuts = vec![0.0, 1.0];
    for (c, d) in edges {
        let across = d - c;
        let turn = along.cross(across);
        cuts.push((c - a).cross(across) / turn);
        if turn.abs() <= PARALLEL * along.norm() * across.norm() {
            // Where parallel edges lie on each other, their ends are the cuts.
            cuts.extend([c, d].map(|end| (end - a).dot(along) / along.dot(along)));
        }
    }
    // Not a number: without a crossing there is none.
    cuts.retain(|cut| (0.0..=1.0).contains(cut));
    cuts.sort_by(f64::total_cmp);
    cuts.windows(2).map(|cut| (a + along * cut[0], a + along * cut[1])).collect()
}

/// Whether avoided area lies on either side of an edge fragment.
fn has_area_beside((a, b): Edge, covered: impl Fn(Point) -> bool) -> bool {
    let along = b - a;
    let length = along.norm();
    if length <= PROBE {
        return false;
    }
    let offset = Point::new(-along.y, along.x) * (PROBE / length);
    let middle = (a + b) / 2.0;
    covered(middle + offset) || covered(middle - offset)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(low: f64, high: f64) -> Rect {
        Rect::new((low, low), (high, high))
    }

    fn region(solid: Rect, open: Rect) -> AvoidedArea {
        let mut d = Device::builder("scene");
        d.add_polygon(solid, 1).unwrap();
        d.add_polygon(open, 2).unwrap();
        AvoidedArea::of(&d.build().unwrap(), |_| true, &2.into())
    }

    fn length(region: &AvoidedArea) -> f64 {
        region.edges.iter().map(|(a, b)| a.distance(*b)).sum()
    }

    #[test]
    fn a_hole_adds_its_edges_and_what_hides_everything_leaves_none() {
        assert!((length(&region(square(0.0, 10.0), square(4.0, 6.0))) - 48.0).abs() < 1e-9);
        assert_eq!(length(&region(square(0.0, 10.0), square(-1.0, 11.0))), 0.0);
        assert_eq!(length(&region(square(0.0, 10.0), square(0.0, 10.0))), 0.0);
        assert_eq!(length(&region(square(0.0, 10.0), square(20.0, 30.0))), 40.0);
    }

    #[test]
    fn a_cut_corner_swaps_its_edges_for_those_of_the_cut() {
        // 10 × 10 without its quarter: still 40 around it. An edge shared with the cut is none any more.
        assert!((length(&region(square(0.0, 10.0), square(5.0, 15.0))) - 40.0).abs() < 1e-9);
        let half = Rect::new((0.0, 0.0), (10.0, 4.0));
        assert!((length(&region(square(0.0, 10.0), half)) - 32.0).abs() < 1e-9);
    }
}
