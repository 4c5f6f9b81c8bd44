//! The plan of an anchor: which placements below it are written in place, and where their seam points go.
//!
//! An anchor is a placement that no open joint leads out of. Its inside is rounded in its own frame and it moves as a
//! whole. Many anchors of one cell at one angle are one form. Below it, a placement is *exposed* if it holds a member of
//! an open joint that is not all its own, or touches its surroundings in a turned parent: such placements are written in
//! place, rounded in the frame of the anchor.

use std::collections::{BTreeMap, VecDeque};

use phidl_core::geom::{Matrix, Point, Rect, Transform};
use phidl_core::layer::Layer;
use phidl_core::num::grid::Grid;
use phidl_core::place::Bounded;
use phidl_core::scene::{Device, Reference};

use super::cells::{Cells, Item, elements_near};
use super::classes::{Classes, SeamPoint};
use super::corner::{Corner, in_steps, nearest, rounded};
use super::faces::{Rigid, local_box};
use super::joints::{Found, Seam, State};
use super::linear::{Linear, Orientation};
use super::options::{Beneath, WeldOptions};
use crate::error::{IoError, Result};

/// Boxes nearer than this touch (steps).
const TOUCHING: f64 = 3.0;

/// All that is known before anything is planned.
pub(super) struct Layout<'a> {
    pub(super) cells: &'a Cells,
    /// What was found in each cell, by its number.
    pub(super) found: &'a [Found],
    /// Whether a cell or one below it has a joint.
    pub(super) has_joints: &'a [bool],
    /// Whether a cell or one below it has an open joint if it stands upright.
    pub(super) is_open: &'a [bool],
    pub(super) grid: &'a Grid,
    pub(super) reach: f64,
    pub(super) options: &'a WeldOptions,
}

/// What tells anchors apart: cell, residue and magnification (as bits).
pub(super) type AnchorKey = (usize, u64, u64);

/// What becomes of placements that are not exposed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Rest {
    /// They place the cell as it is.
    AsIs,
    /// They place the form of an anchor, with the linear part of the placement or what of it the form does not hold.
    Anchor { key: AnchorKey, keeps_linear: bool },
}

/// A placement on its way to the anchor's frame.
#[derive(Debug, Clone)]
pub(super) struct Placement {
    /// From the cell to the anchor (µm), not rounded.
    pub(super) truth: Transform,
    /// The same, ready to be applied to many points.
    pub(super) matrix: Matrix,
    pub(super) linear: Linear,
    /// Where the cell's origin is written (steps): whole numbers if the placement is exact.
    pub(super) origin: Point,
}

impl Placement {
    fn root(base: Transform) -> Self {
        Self { truth: base, matrix: base.matrix(), linear: Linear::of(&base), origin: Point::ORIGIN }
    }

    /// Whether the cell's corners are rounded in the cell, and not in the anchor.
    pub(super) fn is_exact(&self) -> bool {
        self.linear.is_exact()
    }

    /// Whether the cell is written in other coordinates than its own.
    pub(super) fn is_baked(&self) -> bool {
        !self.linear.is_orientation()
    }

    /// The frame in which the cell is written: an orientation and a whole-numbered origin.
    pub(super) fn frame(&self) -> (Orientation, Corner) {
        (self.linear.orientation, nearest(self.origin))
    }

    pub(super) fn below(&self, own: &Transform, grid: &Grid) -> Self {
        let truth = own.then(&self.truth);
        let linear = Linear::of(&truth);
        let origin = in_steps(grid, self.matrix.apply_vector(own.origin)) + self.origin;
        let origin = if linear.is_exact() { rounded(origin) } else { origin };
        Self { truth, matrix: truth.matrix(), linear, origin }
    }

    /// Where a corner is written that is rounded in the cell, if the placement is exact.
    pub(super) fn apply_exactly(&self, corner: Corner) -> Option<Corner> {
        let ([x, y], (_, [ox, oy])) = (self.linear.apply_exactly(corner)?, self.frame());
        Some([x + ox, y + oy])
    }

    /// Where a point of the cell is written.
    pub(super) fn corner(&self, local: Point, grid: &Grid) -> Corner {
        let steps = in_steps(grid, local);
        let exact = self.is_exact().then(|| self.apply_exactly(nearest(steps)));
        exact.flatten().unwrap_or_else(|| {
            let placed = in_steps(grid, self.matrix.apply_vector(local)) + self.origin;
            nearest(placed)
        })
    }
}

/// A placement that is written in place.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) cell: usize,
    pub(super) placement: Placement,
    /// The exposed placements of the cell: reference and element, with the index of their node.
    pub(super) exposed: BTreeMap<(usize, (u32, u32)), usize>,
}

/// The plan of one anchor: its node first, every other one after the node that holds it.
#[derive(Debug)]
pub(super) struct Plan {
    pub(super) nodes: Vec<Node>,
    pub(super) classes: Classes,
}

impl Layout<'_> {
    fn device(&self, cell: usize) -> &Device {
        &self.cells.list[cell].device
    }

    /// What becomes of the placements of a reference that are not exposed.
    pub(super) fn rest(&self, node: &Placement, reference: &Reference) -> Rest {
        let child = self.cells.number(reference.device());
        let upright = (child, 0.0_f64.to_bits(), 1.0_f64.to_bits());
        if self.cells.list[child].rigid {
            return Rest::AsIs;
        }
        let linear = Linear::of(&reference.transform().then(&node.truth));
        let trusted = self.options.beneath == Beneath::Trust;
        if linear.is_exact() || trusted {
            return match self.is_open[child] {
                true => Rest::Anchor { key: upright, keeps_linear: true },
                false => Rest::AsIs,
            };
        }
        match self.has_joints[child] {
            true => {
                let key = (child, linear.residue.to_bits(), linear.magnification.to_bits());
                Rest::Anchor { key, keeps_linear: false }
            }
            false => Rest::AsIs,
        }
    }

    /// Plans an anchor.
    pub(super) fn plan(&self, (cell, residue, magnification): AnchorKey) -> Result<Plan> {
        let (rotation, magnification) = (f64::from_bits(residue), f64::from_bits(magnification));
        let base = Transform { rotation, magnification, ..Transform::IDENTITY };
        let mut planner = Planner { layout: self, nodes: Vec::new(), seams: Vec::new(), open: VecDeque::new() };
        planner.add(cell, Placement::root(base))?;
        planner.run()?;
        let Planner { nodes, seams, .. } = planner;
        Ok(Plan { nodes, classes: Classes::of(&seams, self.grid, self.reach) })
    }

    /// Whether a vertex of an element of a reference lies at a point, or an edge of these layers runs through it.
    fn holds_member(&self, reference: &Reference, (column, row): (u32, u32), at: Point, layers: &[Layer]) -> bool {
        let around = Rect::new(at, at).grown(self.reach);
        let mut stack = vec![(reference.device().clone(), reference.element(column, row))];
        while let Some((device, transform)) = stack.pop() {
            let local = local_box(&transform, &around);
            let cell = &self.cells.list[self.cells.number(&device)];
            let back = transform.inverse();
            let (local_at, reach) = (back.apply(at), self.reach * back.magnification);
            for item in cell.near(&local) {
                match item {
                    Item::Polygon(index) => {
                        let Some(polygon) = device.polygon(index) else { continue };
                        if touches(polygon.points, local_at, layers.contains(&polygon.layer), reach) {
                            return true;
                        }
                    }
                    Item::Reference(index) => {
                        let child = &device.references()[index];
                        for (column, row) in elements_near(child, &local) {
                            stack.push((child.device().clone(), child.element(column, row).then(&transform)));
                        }
                    }
                }
            }
        }
        false
    }

    /// Whether an element of a reference touches another element of its cell, or a neighbor in its array, on a layer that
    /// both draw on.
    fn touches_neighbors(&self, cell: usize, reference: usize) -> bool {
        let index = &self.cells.list[cell];
        let own = &index.device.references()[reference];
        let margin = TOUCHING * self.grid.step();
        let Some(bbox) = index.reference_box(reference) else { return false };
        let layers = self.cells.child(own).layers();
        let shared = |others: &[Layer]| others.iter().any(|layer| layers.binary_search(layer).is_ok());
        if let Some(array) = own.array() {
            let one = Reference::new(own.device().clone(), *own.transform());
            let neighbors = [(1, 0), (0, 1), (1, 1)].into_iter().filter(|(i, j)| *i < array.columns && *j < array.rows);
            let steps = neighbors.map(|(i, j)| own.placed_step(array.step(i, j)));
            let skew = own.placed_step(array.column_step - array.row_step);
            let Some(first) = one.bbox() else { return false };
            let touching = |step: Point| first.grown(margin).touches(&first.shifted(step));
            if steps.into_iter().any(touching) || (array.columns > 1 && array.rows > 1 && touching(skew)) {
                return true;
            }
        }
        index.near(&bbox.grown(margin)).into_iter().any(|item| match item {
            Item::Polygon(polygon) => {
                let polygon = index.device.polygon(polygon);
                polygon.is_some_and(|polygon| layers.binary_search(&polygon.layer).is_ok())
            }
            Item::Reference(other) => {
                other != reference && shared(self.cells.child(&index.device.references()[other]).layers())
            }
        })
    }
}

/// Whether an outline has a vertex at a point or, if edges count, an edge through it.
fn touches(points: &[Point], at: Point, edges: bool, reach: f64) -> bool {
    if points.iter().any(|p| p.distance(at) <= reach) {
        return true;
    }
    let through = |(a, b): (Point, Point)| {
        let length = a.distance(b);
        let direction = (b - a) / length;
        let position = (at - a).dot(direction);
        (at - a).cross(direction).abs() <= reach && position > 0.0 && position < length
    };
    edges && (0..points.len()).any(|i| through((points[i], points[(i + 1) % points.len()])))
}

struct Planner<'l, 'a> {
    layout: &'l Layout<'a>,
    nodes: Vec<Node>,
    seams: Vec<SeamPoint>,
    /// Seam points of open joints whose members were not looked for yet, with the layers of their edges.
    open: VecDeque<(Point, Vec<Layer>)>,
}

impl Planner<'_, '_> {
    fn run(&mut self) -> Result<()> {
        while let Some((at, layers)) = self.open.pop_front() {
            let mut stack = vec![0];
            while let Some(node) = stack.pop() {
                stack.extend(self.expose(node, at, &layers)?);
            }
        }
        Ok(())
    }

    /// The nodes of a node that hold a member at a point (in the anchor's frame), made where they were not yet.
    fn expose(&mut self, node: usize, at: Point, layers: &[Layer]) -> Result<Vec<usize>> {
        let layout = self.layout;
        let cell = self.nodes[node].cell;
        let index = &layout.cells.list[cell];
        let local = self.nodes[node].placement.truth.inverse().apply(at);
        let around = Rect::new(local, local).grown(layout.reach);
        let mut held = Vec::new();
        for item in index.near(&around) {
            let Item::Reference(reference) = item else { continue };
            let placed = &index.device.references()[reference];
            if layout.cells.child(placed).rigid {
                continue;
            }
            for element in elements_near(placed, &around) {
                if let Some(known) = self.nodes[node].exposed.get(&(reference, element)) {
                    held.push(*known);
                } else if layout.holds_member(placed, element, local, layers) {
                    held.push(self.add_below(node, reference, element)?);
                }
            }
        }
        Ok(held)
    }

    fn add_below(&mut self, node: usize, reference: usize, (column, row): (u32, u32)) -> Result<usize> {
        let layout = self.layout;
        let placed = &layout.device(self.nodes[node].cell).references()[reference];
        let placement = self.nodes[node].placement.below(&placed.element(column, row), layout.grid);
        let added = self.add(layout.cells.number(placed.device()), placement)?;
        self.nodes[node].exposed.insert((reference, (column, row)), added);
        Ok(added)
    }

    /// Adds a node with the joints of its cell and, if it is turned, with what touches in it.
    fn add(&mut self, cell: usize, placement: Placement) -> Result<usize> {
        let layout = self.layout;
        if self.nodes.len() >= layout.options.most_forms {
            return Err(self.too_many());
        }
        for joint in &layout.found[cell].joints {
            let open = joint.state == State::Open || (joint.state == State::Closed && !placement.is_exact());
            for seam in &joint.seams {
                let point = self.seam_point(seam, &placement);
                if open {
                    self.open.push_back((point.truth, point.layers.clone()));
                }
                self.seams.push(point);
            }
        }
        let baked = placement.is_baked();
        let node = self.nodes.len();
        self.nodes.push(Node { cell, placement, exposed: BTreeMap::new() });
        if baked {
            self.add_touching(node)?;
        }
        Ok(node)
    }

    fn add_touching(&mut self, node: usize) -> Result<()> {
        let layout = self.layout;
        let cell = self.nodes[node].cell;
        for (reference, placed) in layout.device(cell).references().iter().enumerate() {
            if layout.cells.child(placed).rigid || placed.bbox().is_none() || !layout.touches_neighbors(cell, reference)
            {
                continue;
            }
            if placed.count() > layout.options.most_forms {
                return Err(self.too_many());
            }
            let (columns, rows) = placed.array().map_or((1, 1), |a| (a.columns, a.rows));
            for element in (0..columns).flat_map(|column| (0..rows).map(move |row| (column, row))) {
                self.add_below(node, reference, element)?;
            }
        }
        Ok(())
    }

    fn too_many(&self) -> IoError {
        let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
        for node in &self.nodes {
            *counts.entry(node.cell).or_default() += 1;
        }
        let most = counts.iter().max_by_key(|(cell, count)| (**count, **cell)).map_or(0, |(cell, _)| *cell);
        let rule = format!(
            "be enough for all placements that are written in place; cell \"{}\" has most of them, and a rigid cell needs none",
            self.layout.device(most).name()
        );
        IoError::option("weld.most_forms", self.layout.options.most_forms, rule)
    }

    fn seam_point(&self, seam: &Seam, placement: &Placement) -> SeamPoint {
        let grid = self.layout.grid;
        let predicted = |rigid: &Rigid| {
            let below = placement.below(&rigid.transform, grid);
            let (_, [ox, oy]) = below.frame();
            let corner = Point::new(rigid.corner[0] as f64, rigid.corner[1] as f64);
            let [x, y] = nearest(below.matrix.apply_vector(corner));
            [ox + x, oy + y]
        };
        let mirrored = placement.truth.x_reflection;
        let rigid_edge = seam.rigid_edge.map(|[a, b]| {
            let [a, b] = [predicted(&a), predicted(&b)];
            if mirrored { [b, a] } else { [a, b] }
        });
        SeamPoint {
            truth: placement.truth.apply(seam.at),
            layers: seam.layers.clone(),
            exact: seam.exact.iter().filter_map(|corner| placement.apply_exactly(*corner)).collect(),
            rigid: seam.rigid.iter().map(predicted).collect(),
            rigid_edge,
        }
    }
}
