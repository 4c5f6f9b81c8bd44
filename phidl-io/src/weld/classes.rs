//! Classes: seam points of one position, with the one grid point that all members take.

use phidl_core::geom::{Point, Rect};
use phidl_core::layer::Layer;
use phidl_core::num::grid::Grid;
use rstar::primitives::GeomWithData;
use rstar::{AABB, RTree};

use super::corner::{Corner, cross, in_steps, nearest};
use super::sites::clusters;

/// A seam point in the frame of an anchor, before it has its grid point.
#[derive(Debug, Clone)]
pub(super) struct SeamPoint {
    /// Where it is (µm), not rounded.
    pub(super) truth: Point,
    pub(super) layers: Vec<Layer>,
    /// Where exact members are written.
    pub(super) exact: Vec<Corner>,
    /// Where rigid members are read.
    pub(super) rigid: Vec<Corner>,
    /// A rigid edge that runs through it, with the material on its left.
    pub(super) rigid_edge: Option<[Corner; 2]>,
}

/// A position and its grid point.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Class {
    /// Where it is (µm), not rounded.
    pub(super) truth: Point,
    pub(super) corner: Corner,
    /// The layers on which edges through it get a vertex.
    pub(super) layers: Vec<Layer>,
}

/// All classes of an anchor.
#[derive(Debug)]
pub(super) struct Classes {
    list: Vec<Class>,
    tree: RTree<GeomWithData<[f64; 2], usize>>,
    /// Classes whose rigid members disagree.
    pub(super) unweldable: Vec<Point>,
    /// The largest distance of a class point from its position (steps).
    pub(super) largest_move: f64,
}

impl Classes {
    pub(super) fn of(seams: &[SeamPoint], grid: &Grid, reach: f64) -> Self {
        let mut list = Vec::new();
        let mut unweldable = Vec::new();
        let mut largest_move = 0.0_f64;
        for members in clusters(seams.iter().map(|seam| seam.truth), reach) {
            let members: Vec<&SeamPoint> = members.into_iter().map(|index| &seams[index]).collect();
            let truth = members[0].truth;
            let mut layers: Vec<Layer> = members.iter().flat_map(|seam| seam.layers.iter().copied()).collect();
            layers.sort_unstable();
            layers.dedup();
            let (corner, agreed) = grid_point(&members, grid);
            if !agreed {
                unweldable.push(truth);
            }
            let [x, y] = corner;
            largest_move = largest_move.max(in_steps(grid, truth).distance(Point::new(x as f64, y as f64)));
            list.push(Class { truth, corner, layers });
        }
        let entries = list.iter().enumerate().map(|(index, c)| GeomWithData::new([c.truth.x, c.truth.y], index));
        Self { tree: RTree::bulk_load(entries.collect()), list, unweldable, largest_move }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The classes in a box, in the order in which they were found.
    pub(super) fn near(&self, rect: &Rect) -> Vec<&Class> {
        let envelope = AABB::from_corners([rect.min.x, rect.min.y], [rect.max.x, rect.max.y]);
        let mut found: Vec<usize> = self.tree.locate_in_envelope(&envelope).map(|entry| entry.data).collect();
        found.sort_unstable();
        found.into_iter().map(|index| &self.list[index]).collect()
    }
}

/// The grid point of a class, and whether its rigid members agree.
///
/// Rigid members decide; then exact members, if they agree; else the rounded position. On an axis where the position is a
/// half step, both neighbors are equally near: the one that more exact members have, and away from zero if that ties.
fn grid_point(members: &[&SeamPoint], grid: &Grid) -> (Corner, bool) {
    let truth = members[0].truth;
    let rounded = nearest(in_steps(grid, truth));
    let rigid: Vec<Corner> = members.iter().flat_map(|seam| seam.rigid.iter().copied()).collect();
    if let Some(first) = rigid.first() {
        return (*first, rigid.iter().all(|corner| corner == first));
    }
    if let Some(edge) = members.iter().find_map(|seam| seam.rigid_edge) {
        return (inside_of(edge, rounded, in_steps(grid, truth)), true);
    }
    let exact: Vec<Corner> = members.iter().flat_map(|seam| seam.exact.iter().copied()).collect();
    if let Some(first) = exact.first()
        && exact.iter().all(|corner| corner == first)
    {
        return (*first, true);
    }
    let steps = in_steps(grid, truth);
    let axis = |axis: usize, position: f64| {
        if (position.fract().abs() - 0.5).abs() > f64::powi(2.0, -20) {
            return rounded[axis];
        }
        let inward = rounded[axis] - rounded[axis].signum();
        let votes = |candidate: i64| exact.iter().filter(|corner| corner[axis] == candidate).count();
        if votes(inward) > votes(rounded[axis]) { inward } else { rounded[axis] }
    };
    ([axis(0, steps.x), axis(1, steps.y)], true)
}

/// The grid point nearest to a position that does not lie outside of an edge with the material on its left.
fn inside_of([a, b]: [Corner; 2], rounded: Corner, position: Point) -> Corner {
    let around = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| [rounded[0] + dx, rounded[1] + dy]));
    let distance = |corner: &Corner| position.distance(Point::new(corner[0] as f64, corner[1] as f64));
    let inside = around.filter(|corner| cross(a, b, *corner) >= 0);
    inside.min_by(|p, q| distance(p).total_cmp(&distance(q))).unwrap_or(rounded)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seam(x: f64, y: f64, exact: &[Corner]) -> SeamPoint {
        let layers = vec![Layer::new(1, 0)];
        SeamPoint { truth: Point::new(x, y), layers, exact: exact.to_vec(), rigid: vec![], rigid_edge: None }
    }

    fn point(seam: SeamPoint) -> Corner {
        Classes::of(&[seam], &Grid::new(1e-3).unwrap(), 1e-6).list[0].corner
    }

    #[test]
    fn exact_members_that_agree_decide_and_others_round() {
        assert_eq!(point(seam(0.0004, 0.0, &[[1, 0], [1, 0]])), [1, 0]);
        assert_eq!(point(seam(0.0004, 0.0, &[])), [0, 0]);
        assert_eq!(point(seam(0.0004, 0.0, &[[1, 0], [0, 0]])), [0, 0]);
    }

    #[test]
    fn on_a_half_step_the_majority_decides_and_then_the_outside() {
        assert_eq!(point(seam(9.7925, 10.0, &[[9793, 10_000], [9792, 10_000]])), [9793, 10_000]);
        assert_eq!(point(seam(9.7925, 10.0, &[[9793, 10_000], [9792, 10_000], [9792, 10_000]])), [9792, 10_000]);
        assert_eq!(point(seam(-0.0005, 0.0, &[])), [-1, 0]);
    }

    #[test]
    fn rigid_members_decide_before_all_others() {
        let rigid = SeamPoint { rigid: vec![[2613, 1494]], ..seam(2.614, 1.495, &[[2614, 1495]]) };
        assert_eq!(point(rigid.clone()), [2613, 1494]);
        let two = SeamPoint { rigid: vec![[2613, 1494], [2614, 1494]], ..rigid };
        assert_eq!(Classes::of(&[two], &Grid::new(1e-3).unwrap(), 1e-6).unweldable.len(), 1);
    }

    #[test]
    fn beside_a_rigid_edge_the_point_is_not_outside() {
        // The edge runs up with the material on its left; the nearest grid point lies on its right.
        let edge = [[0, 0], [3, 1000]];
        let seam = SeamPoint { rigid_edge: Some(edge), ..seam(0.0015, 0.5, &[]) };
        let corner = point(seam);
        assert!(cross(edge[0], edge[1], corner) >= 0, "{corner:?}");
    }
}
