//! Faces: the edges of a subtree that lie on the line through a port, across its normal.

use phidl_core::geom::{Point, Rect, Transform};
use phidl_core::layer::Layer;
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Device, PolygonView};

use super::cells::{Cells, Item, elements_near};
use super::corner::{Corner, corner_of, in_steps, rounded};
use super::linear::Linear;

/// The line through a port, across its normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    pub(super) midpoint: Point,
    pub(super) normal: Point,
}

impl Line {
    pub(super) fn new(midpoint: Point, degrees: f64) -> Self {
        Self { midpoint, normal: Point::polar(1.0, degrees) }
    }

    fn along(&self) -> Point {
        Point::new(-self.normal.y, self.normal.x)
    }

    /// Where a point lies along the line, from the midpoint.
    pub(super) fn position(&self, p: Point) -> f64 {
        (p - self.midpoint).dot(self.along())
    }

    /// How far a point is in front of the line.
    pub(super) fn distance(&self, p: Point) -> f64 {
        (p - self.midpoint).dot(self.normal)
    }

    pub(super) fn at(&self, position: f64) -> Point {
        self.midpoint + self.along() * position
    }

    /// The box around a part of the line.
    pub(super) fn rect(&self, span: (f64, f64)) -> Rect {
        Rect::new(self.at(span.0), self.at(span.1))
    }

    /// The part of the line that a box can hold.
    pub(super) fn span_of(&self, rect: &Rect) -> (f64, f64) {
        let positions = rect.corners().map(|corner| self.position(corner));
        let low = positions.iter().copied().fold(f64::INFINITY, f64::min);
        (low, positions.iter().copied().fold(f64::NEG_INFINITY, f64::max))
    }
}

/// The end of a face edge, in the frame of the cell whose joint it belongs to.
#[derive(Debug, Clone)]
pub(super) struct End {
    /// Where it is (µm), not rounded.
    pub(super) at: Point,
    /// Where a file without welding puts it (steps).
    pub(super) written: Point,
    /// The same in whole steps, if all placements between the cell and the vertex are exact.
    pub(super) exact: Option<Corner>,
    /// The rigid cell that the vertex belongs to, if it belongs to one.
    pub(super) rigid: Option<Rigid>,
}

/// A vertex of a rigid cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rigid {
    /// The placement of the rigid cell.
    pub(super) transform: Transform,
    /// The rounded vertex, in the frame of the rigid cell.
    pub(super) corner: Corner,
}

/// An edge on a face line.
#[derive(Debug, Clone)]
pub(super) struct FaceEdge {
    pub(super) layer: Layer,
    /// Both ends, the lower position along the line first.
    pub(super) ends: [End; 2],
    pub(super) positions: [f64; 2],
    /// Whether the material lies behind the line, where the normal does not point.
    pub(super) behind: bool,
}

/// What is searched for faces: a subtree of a cell, or a part of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scope {
    /// One element of a reference with all below it.
    Element(usize, (u32, u32)),
    /// The polygons of the cell itself.
    Own,
    /// All of the cell but one element of a reference.
    AllBut(usize, (u32, u32)),
}

/// One placement on the way down.
struct Place {
    device: Device,
    transform: Transform,
    /// How vertices of this cell reach the frame of the search in a plain file: linear parts and rounded origins from
    /// the outside in.
    levels: Vec<Transform>,
    rigid: Option<(usize, Transform)>,
}

/// Finds the edges on a face line.
pub(super) struct FaceSearch<'a> {
    pub(super) cells: &'a Cells,
    pub(super) grid: &'a Grid,
    pub(super) reach: f64,
}

impl FaceSearch<'_> {
    /// The edges of a part of a cell on a line, within a span of it, on these layers (all if there are none given).
    pub(super) fn edges(&self, cell: &Device, scope: Scope, line: &Line, span: (f64, f64)) -> Vec<FaceEdge> {
        let rect = line.rect(span).grown(self.reach);
        let mut found = Vec::new();
        let root = Place { device: cell.clone(), transform: Transform::IDENTITY, levels: Vec::new(), rigid: None };
        let mut stack = Vec::new();
        match scope {
            Scope::Own => self.own_edges(&root, &rect, line, span, &mut found),
            Scope::Element(reference, element) => stack.extend(self.below(&root, reference, element)),
            Scope::AllBut(reference, element) => {
                self.own_edges(&root, &rect, line, span, &mut found);
                stack.extend(self.children(&root, &rect, Some((reference, element))));
            }
        }
        while let Some(place) = stack.pop() {
            self.own_edges(&place, &rect, line, span, &mut found);
            stack.extend(self.children(&place, &rect, None));
        }
        found
    }

    fn children(&self, place: &Place, rect: &Rect, but: Option<(usize, (u32, u32))>) -> Vec<Place> {
        let local = local_box(&place.transform, rect);
        let cell = &self.cells.list[self.cells.number(&place.device)];
        let mut children = Vec::new();
        for item in cell.near(&local) {
            let Item::Reference(reference) = item else { continue };
            for element in elements_near(&place.device.references()[reference], &local) {
                if but != Some((reference, element)) {
                    children.extend(self.below(place, reference, element));
                }
            }
        }
        children
    }

    fn below(&self, place: &Place, reference: usize, (column, row): (u32, u32)) -> Option<Place> {
        let reference = place.device.references().get(reference)?;
        let own = reference.element(column, row);
        let transform = own.then(&place.transform);
        let mut levels = place.levels.clone();
        levels.push(own);
        let child = self.cells.child(reference);
        let rigid = place.rigid.or_else(|| child.rigid.then_some((levels.len(), transform)));
        Some(Place { device: reference.device().clone(), transform, levels, rigid })
    }

    fn own_edges(&self, place: &Place, rect: &Rect, line: &Line, span: (f64, f64), found: &mut Vec<FaceEdge>) {
        let local = local_box(&place.transform, rect);
        let cell = &self.cells.list[self.cells.number(&place.device)];
        for item in cell.near(&local) {
            if let Item::Polygon(index) = item
                && let Some(polygon) = place.device.polygon(index)
            {
                self.edges_of(place, polygon, line, span, found);
            }
        }
    }

    fn edges_of(
        &self,
        place: &Place,
        polygon: PolygonView<'_>,
        line: &Line,
        span: (f64, f64),
        found: &mut Vec<FaceEdge>,
    ) {
        let matrix = place.transform.matrix();
        let points = polygon.points;
        let near = |p: Point| line.distance(p).abs() <= self.reach;
        let mut left_inside = None;
        for i in 0..points.len() {
            let (from, to) = (points[i], points[(i + 1) % points.len()]);
            let (a, b) = (matrix.apply(from), matrix.apply(to));
            if !near(a) || !near(b) || a.distance(b) <= self.reach {
                continue;
            }
            let (mut low, mut high) = ((line.position(a), from, a), (line.position(b), to, b));
            let rising = low.0 <= high.0;
            if !rising {
                std::mem::swap(&mut low, &mut high);
            }
            if low.0 > span.1 || high.0 < span.0 {
                continue;
            }
            // Left of an edge that runs up along the line is behind the line.
            let counter_clockwise =
                *left_inside.get_or_insert_with(|| (signed_area(points) > 0.0) != place.transform.x_reflection);
            found.push(FaceEdge {
                layer: polygon.layer,
                ends: [self.end(place, low.1, low.2), self.end(place, high.1, high.2)],
                positions: [low.0, high.0],
                behind: rising == counter_clockwise,
            });
        }
    }

    fn end(&self, place: &Place, local: Point, at: Point) -> End {
        let corner = rounded(in_steps(self.grid, local));
        let mut written = corner;
        let mut exact = Some(corner_of(corner));
        let mut rigid = None;
        for (depth, level) in place.levels.iter().enumerate().rev() {
            if let Some((first, transform)) = place.rigid
                && first == depth + 1
            {
                rigid = exact.map(|corner| Rigid { transform, corner });
            }
            let origin = rounded(in_steps(self.grid, level.origin));
            written = level.apply_vector(written) + origin;
            let image = exact.and_then(|corner| Linear::of(level).apply_exactly(corner));
            exact = image.map(|[x, y]| {
                let [ox, oy] = corner_of(origin);
                [x + ox, y + oy]
            });
        }
        End { at, written, exact, rigid }
    }
}

/// The box in a cell's frame around a box in the frame where the cell is placed.
pub(super) fn local_box(transform: &Transform, rect: &Rect) -> Rect {
    let back = transform.inverse().matrix();
    let corners = rect.corners().map(|corner| back.apply(corner));
    Rect::around(corners).unwrap_or(*rect)
}

/// Twice the signed area.
fn signed_area(points: &[Point]) -> f64 {
    let Some(&origin) = points.first() else { return 0.0 };
    (1..points.len().saturating_sub(1)).map(|i| (points[i] - origin).cross(points[i + 1] - origin)).sum()
}
