//! Lazy walks through a hierarchy: every placed cell, and every polygon where it ends up.
//!
//! Nothing is copied: a walk keeps one frame per level and applies one matrix to the points of a cell when they are
//! asked for.

use super::{Device, Polygon, PolygonView, Properties};
use crate::geom::{Matrix, Point, Rect, Transform, signed_area};
use crate::layer::{Layer, Layers};
use crate::place::Bounded;
use crate::port::Port;

/// A cell where it ends up below the cell that was walked.
#[derive(Debug, Clone, Copy)]
pub struct Instance<'a> {
    /// The cell.
    pub device: &'a Device,
    /// Where it ends up.
    pub transform: Transform,
    /// How many references lie above it; 0 is the walked cell itself.
    pub depth: usize,
}

/// A walk over all placed cells: a cell first, then what its references place, in order; of an array, columns outside
/// and rows inside. Made by [`Device::instances`].
#[derive(Debug, Clone)]
pub struct Instances<'a> {
    start: Option<&'a Device>,
    frames: Vec<Frame<'a>>,
    /// References below this depth are not followed.
    deepest: usize,
}

/// Where the walk is inside the references of one cell.
#[derive(Debug, Clone)]
struct Frame<'a> {
    device: &'a Device,
    transform: Transform,
    /// The next reference.
    reference: usize,
    /// The next element of it, if it is an array.
    element: (u32, u32),
}

impl<'a> Frame<'a> {
    fn new(device: &'a Device, transform: Transform) -> Self {
        Self { device, transform, reference: 0, element: (0, 0) }
    }

    /// The next placed cell of this one.
    fn next_child(&mut self) -> Option<(&'a Device, Transform)> {
        loop {
            let reference = self.device.references().get(self.reference)?;
            let (columns, rows) = reference.array().map_or((1, 1), |a| (a.columns, a.rows));
            let (column, row) = self.element;
            if column >= columns || row >= rows {
                self.reference += 1;
                self.element = (0, 0);
                continue;
            }
            self.element = if row + 1 < rows { (column, row + 1) } else { (column + 1, 0) };
            return Some((reference.device(), reference.element(column, row).then(&self.transform)));
        }
    }
}

impl<'a> Iterator for Instances<'a> {
    type Item = Instance<'a>;

    fn next(&mut self) -> Option<Instance<'a>> {
        if let Some(device) = self.start.take() {
            return Some(self.enter(device, Transform::IDENTITY));
        }
        while let Some(frame) = self.frames.last_mut() {
            match frame.next_child() {
                Some((device, transform)) => return Some(self.enter(device, transform)),
                None => {
                    self.frames.pop();
                }
            }
        }
        None
    }
}

impl<'a> Instances<'a> {
    fn enter(&mut self, device: &'a Device, transform: Transform) -> Instance<'a> {
        let depth = self.frames.len();
        if depth < self.deepest {
            self.frames.push(Frame::new(device, transform));
        } else {
            // A frame without references to follow keeps the depth right and is left at once.
            let past_the_end = device.references().len();
            self.frames.push(Frame { reference: past_the_end, ..Frame::new(device, transform) });
        }
        Instance { device, transform, depth }
    }
}

#[cfg(feature = "parallel")]
impl<'a> Instances<'a> {
    /// A walk that is over, to be set anywhere with the two methods below, from the top down.
    pub(super) fn nowhere() -> Self {
        Self { start: None, frames: Vec::new(), deepest: usize::MAX }
    }

    /// Goes on, in time, after one element of one reference of a cell.
    pub(super) fn push_after(&mut self, device: &'a Device, transform: Transform, reference: usize, last: (u32, u32)) {
        let mut frame = Frame { reference, element: last, ..Frame::new(device, transform) };
        frame.next_child();
        self.frames.push(frame);
    }

    /// Goes on with the first placed cell of a cell.
    pub(super) fn push_before_children(&mut self, device: &'a Device, transform: Transform) {
        self.frames.push(Frame::new(device, transform));
    }
}

/// A polygon where it ends up below the cell that was walked.
#[derive(Debug, Clone)]
pub struct FlatPolygon<'a> {
    /// The cell that it belongs to; for a box, the cell that the box stands for.
    pub device: &'a Device,
    /// Where it is drawn; a box that stands for a cell has no layer.
    pub layer: Option<Layer>,
    corners: Corners<'a>,
    matrix: Matrix,
    properties: Option<&'a Properties>,
}

#[derive(Debug, Clone)]
enum Corners<'a> {
    Stored(&'a [Point]),
    Box([Point; 4]),
}

impl FlatPolygon<'_> {
    /// The corners where they end up, in order.
    pub fn points(&self) -> impl ExactSizeIterator<Item = Point> + DoubleEndedIterator + Clone + '_ {
        let matrix = self.matrix;
        self.stored().iter().map(move |p| matrix.apply(*p))
    }

    /// How many corners it has.
    #[must_use]
    pub fn len(&self) -> usize {
        self.stored().len()
    }

    /// Whether it has no corners; a polygon of a cell always has some.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.stored().is_empty()
    }

    /// Area (µm²), whatever the direction of the outline.
    #[must_use]
    pub fn area(&self) -> f64 {
        let Matrix { a, b, c, d, .. } = self.matrix;
        (signed_area(self.stored()) * (a * d - b * c)).abs()
    }

    /// The polygon as a value of its own.
    #[must_use]
    pub fn to_polygon(&self) -> Polygon {
        let mut polygon = Polygon::new(self.points().collect::<Vec<_>>(), self.layer);
        polygon.properties = self.properties.cloned().unwrap_or_default();
        polygon
    }

    fn stored(&self) -> &[Point] {
        match &self.corners {
            Corners::Stored(points) => points,
            Corners::Box(points) => points,
        }
    }
}

impl Bounded for FlatPolygon<'_> {
    fn bbox(&self) -> Option<Rect> {
        Rect::around(self.points())
    }
}

/// A walk over the polygons of a whole hierarchy: those of a cell first, then those of its references, in order. Made
/// by [`Device::flat_polygons`].
#[derive(Debug, Clone)]
pub struct FlatPolygons<'a> {
    instances: Instances<'a>,
    current: Option<(Instance<'a>, Matrix, usize)>,
    layers: Option<Layers>,
    boxes_at: Option<usize>,
}

impl FlatPolygons<'_> {
    /// Only those on these layers.
    #[must_use]
    pub fn on(self, layers: impl Into<Layers>) -> Self {
        Self { layers: Some(layers.into()), ..self }
    }

    /// Follows references only `depth` levels down; what they place further below is shown as the box around it. With
    /// depth 0, all references of the walked cell are boxes.
    #[must_use]
    pub fn to_depth(mut self, depth: usize) -> Self {
        self.instances.deepest = depth + 1;
        Self { boxes_at: Some(depth + 1), ..self }
    }
}

impl<'a> Iterator for FlatPolygons<'a> {
    type Item = FlatPolygon<'a>;

    fn next(&mut self) -> Option<FlatPolygon<'a>> {
        loop {
            if let Some(polygon) = self.next_of_current() {
                return Some(polygon);
            }
            let instance = self.instances.next()?;
            if self.boxes_at == Some(instance.depth) {
                let Some(rect) = instance.device.bbox() else { continue };
                return Some(FlatPolygon {
                    device: instance.device,
                    layer: None,
                    corners: Corners::Box(rect.corners()),
                    matrix: instance.transform.matrix(),
                    properties: None,
                });
            }
            self.current = Some((instance, instance.transform.matrix(), 0));
        }
    }
}

impl<'a> FlatPolygons<'a> {
    fn next_of_current(&mut self) -> Option<FlatPolygon<'a>> {
        let (instance, matrix, next) = self.current.as_mut()?;
        let outlines = &instance.device.cell().outlines;
        while *next < outlines.len() {
            let view: PolygonView<'a> = outlines.get(*next);
            *next += 1;
            if self.layers.as_ref().is_none_or(|layers| layers.contains(view.layer)) {
                return Some(FlatPolygon {
                    device: instance.device,
                    layer: Some(view.layer),
                    corners: Corners::Stored(view.points),
                    matrix: *matrix,
                    properties: view.property_map(),
                });
            }
        }
        self.current = None;
        None
    }
}

impl Device {
    /// Every placed cell of the hierarchy with its place: this cell first, then what its references place, in order.
    #[must_use]
    pub fn instances(&self) -> Instances<'_> {
        Instances { start: Some(self), frames: Vec::new(), deepest: usize::MAX }
    }

    /// Every polygon of the hierarchy where it ends up, one after the other: its own first, then those of its
    /// references, in order. Nothing is copied.
    ///
    /// ```
    /// # use phidl_core::prelude::*;
    /// # let mut d = Device::builder("dot");
    /// # d.add_polygon([(0, 0), (1, 0), (0, 1)], 1)?;
    /// # let dot = d.build()?;
    /// let mut d = Device::builder("field");
    /// d.add(dot.array(100, 100, (10, 10)));
    /// let field = d.build()?;
    /// assert_eq!(field.flat_polygons().on(1).count(), 10_000);
    /// assert_eq!(field.flat_polygons().to_depth(0).count(), 10_000); // boxes
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    #[must_use]
    pub fn flat_polygons(&self) -> FlatPolygons<'_> {
        FlatPolygons { instances: self.instances(), current: None, layers: None, boxes_at: None }
    }

    /// The ports of this cell and of what is placed below it, where they end up; `depth` 0 is this cell only, `None`
    /// has no limit.
    ///
    /// Those of an array come row by row, and their info has `array_idx`, row and column, of the outermost array.
    #[must_use]
    pub fn ports_recursive(&self, depth: Option<usize>) -> Vec<Port> {
        let mut ports: Vec<Port> = self.ports().cloned().collect();
        if depth == Some(0) {
            return ports;
        }
        for reference in self.references() {
            let inner = reference.device().ports_recursive(depth.map(|d| d - 1));
            match reference.array() {
                None => ports.extend(inner.into_iter().map(|port| placed(port, &reference.element(0, 0)))),
                Some(array) => {
                    let cells = (0..array.rows).flat_map(|row| (0..array.columns).map(move |column| (row, column)));
                    for (row, column) in cells {
                        let element = reference.element(column, row);
                        let marked = inner.iter().map(|p| p.clone().with_info("array_idx", [row, column]));
                        ports.extend(marked.map(|port| placed(port, &element)));
                    }
                }
            }
        }
        ports
    }
}

fn placed(mut port: Port, transform: &Transform) -> Port {
    use crate::place::Transformable;
    port.transform_mut(transform);
    port
}
