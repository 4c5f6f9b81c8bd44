//! Interaction clusters: placements within the interaction distance of each other.

use rstar::{
    AABB, RTree,
    primitives::{GeomWithData, Rectangle},
};

use super::placement::{Bounds, FlatGeometry, Placement};
use crate::point::GridPoint;

/// An outline of more points counts as its box: a test of all its edges for each placement inside would cost more than
/// it saves.
const MOST_POINTS: usize = 2_000;

/// Placements that interact, directly or through others.
#[derive(Debug)]
pub(super) struct InteractionCluster {
    /// Ascending.
    pub(super) members: Vec<usize>,
    /// Whether an outline of the flat geometry is within the interaction distance.
    pub(super) is_blocked: bool,
}

type Entry = GeomWithData<Rectangle<[f64; 2]>, usize>;

/// The clusters of placements, in the order of their first members. Placements and outlines interact if their boxes, each
/// grown by `distance` steps, touch.
pub(super) fn clusters(placements: &[Placement], flat: &FlatGeometry, distance: f64) -> Vec<InteractionCluster> {
    let boxes: Vec<Bounds> = placements.iter().map(|placement| placement.bounds.grown(distance)).collect();
    let entry = |(i, b): (usize, &Bounds)| Entry::new(Rectangle::from_corners(b.low, b.high), i);
    let tree = RTree::bulk_load(boxes.iter().enumerate().map(entry).collect());
    let near = |b: &Bounds| {
        tree.locate_in_envelope_intersecting(&AABB::from_corners(b.low, b.high)).map(|entry: &Entry| entry.data)
    };
    let mut groups = Groups::new(placements.len());
    for (i, b) in boxes.iter().enumerate() {
        near(b).for_each(|other| groups.join(i, other));
    }
    let mut blocked = vec![false; placements.len()];
    for outline in flat.sides.iter().flat_map(|contours| contours.iter()) {
        let Some(around) = around(outline) else { continue };
        for i in near(&around.grown(distance)) {
            let group = groups.find(i);
            blocked[group] = blocked[group] || reaches(outline, boxes[i].grown(distance));
        }
    }
    gathered(groups, &blocked)
}

fn gathered(mut groups: Groups, blocked: &[bool]) -> Vec<InteractionCluster> {
    let mut indices = vec![usize::MAX; blocked.len()];
    let mut clusters: Vec<InteractionCluster> = Vec::new();
    for i in 0..blocked.len() {
        let group = groups.find(i);
        if indices[group] == usize::MAX {
            indices[group] = clusters.len();
            clusters.push(InteractionCluster { members: Vec::new(), is_blocked: blocked[group] });
        }
        clusters[indices[group]].members.push(i);
    }
    clusters
}

#[expect(clippy::cast_precision_loss, reason = "coordinates on the grid are far below 2^53")]
fn real(p: GridPoint) -> [f64; 2] {
    [p.x as f64, p.y as f64]
}

fn around(outline: &[GridPoint]) -> Option<Bounds> {
    let points = outline.iter().map(|&p| Bounds { low: real(p), high: real(p) });
    points.reduce(Bounds::around)
}

/// Whether an outline runs through a box or encloses it.
fn reaches(outline: &[GridPoint], within: Bounds) -> bool {
    if outline.len() > MOST_POINTS {
        return true;
    }
    let closed = || outline.iter().zip(outline.iter().cycle().skip(1)).map(|(&a, &b)| (real(a), real(b)));
    closed().any(|(a, b)| crosses(a, b, within)) || winding(closed(), within.low) != 0
}

/// Whether an edge has a point in a box.
fn crosses(a: [f64; 2], b: [f64; 2], within: Bounds) -> bool {
    let beside = |i: usize| a[i].max(b[i]) < within.low[i] || a[i].min(b[i]) > within.high[i];
    if beside(0) || beside(1) {
        return false;
    }
    let side = |x: f64, y: f64| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    let Bounds { low, high } = within;
    let sides = [side(low[0], low[1]), side(high[0], low[1]), side(high[0], high[1]), side(low[0], high[1])];
    !(sides.iter().all(|&s| s > 0.0) || sides.iter().all(|&s| s < 0.0))
}

/// The winding number of edges around a point that is on none of them.
fn winding(edges: impl Iterator<Item = ([f64; 2], [f64; 2])>, p: [f64; 2]) -> i32 {
    let crossing = |(a, b): ([f64; 2], [f64; 2])| {
        let left = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0.0;
        i32::from(a[1] <= p[1] && b[1] > p[1] && left) - i32::from(a[1] > p[1] && b[1] <= p[1] && !left)
    };
    edges.map(crossing).sum()
}

/// Disjoint sets of numbers; a set is named after its smallest member.
struct Groups(Vec<usize>);

impl Groups {
    fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    fn find(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    fn join(&mut self, i: usize, j: usize) {
        let (i, j) = (self.find(i), self.find(j));
        self.0[i.max(j)] = i.min(j);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(points: &[(i64, i64)]) -> Vec<GridPoint> {
        points.iter().copied().map(GridPoint::from).collect()
    }

    #[test]
    fn a_frame_reaches_boxes_that_it_touches_but_not_those_inside_its_opening() {
        let keyholed = outline(&[
            (0, 0),
            (100, 0),
            (100, 100),
            (0, 100),
            (0, 90),
            (90, 90),
            (90, 10),
            (10, 10),
            (10, 90),
            (0, 90),
        ]);
        let at = |x: f64, y: f64| Bounds { low: [x, y], high: [x + 5.0, y + 5.0] };
        assert!(!reaches(&keyholed, at(50.0, 50.0)));
        assert!(!reaches(&keyholed, at(200.0, 50.0)));
        assert!(reaches(&keyholed, at(8.0, 50.0)));
        assert!(reaches(&outline(&[(0, 0), (100, 0), (100, 100), (0, 100)]), at(50.0, 50.0)));
    }

    #[test]
    fn an_edge_that_passes_a_corner_outside_does_not_cross() {
        let within = Bounds { low: [0.0, 0.0], high: [10.0, 10.0] };
        assert!(crosses([-5.0, 5.0], [5.0, 12.0], within));
        assert!(!crosses([-5.0, 5.0], [5.0, 25.0], within));
        assert!(crosses([2.0, 2.0], [3.0, 3.0], within));
    }
}
