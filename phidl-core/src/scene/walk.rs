//! Lazy iterators over a hierarchy: every placed cell, and every polygon, in top-level coordinates.
//!
//! Nothing is copied: an iterator keeps one frame per level and applies one matrix to the points of a cell when they are
//! asked for.

use std::collections::HashSet;
use std::sync::Arc;

use super::{Device, Polygon, PolygonView, Properties};
use crate::geom::{Matrix, Point, Rect, Transform, signed_area};
use crate::layer::{Layer, Layers};
use crate::place::Bounded;

/// A placed cell in top-level coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Instance<'a> {
    /// The cell.
    pub device: &'a Device,
    /// From the coordinates of the cell to those of the top cell.
    pub transform: Transform,
    /// How many references lie above it; 0 for the top cell itself.
    pub depth: usize,
}

/// An iterator over all placed cells: a cell first, then what its references place, in order; of an array, columns outside
/// and rows inside. Made by [`Device::instances`].
#[derive(Debug, Clone)]
pub struct Instances<'a> {
    start: Option<(&'a Device, Transform)>,
    frames: Vec<Frame<'a>>,
    /// References below this depth are not followed.
    deepest: usize,
    visit: Visit,
}

/// Which placed cells are visited. Without pruning, an array of 60,000 × 60,000 empty cells would take a minute.
#[derive(Debug, Clone)]
enum Visit {
    All,
    /// Cells that draw something.
    Drawn,
    /// Cells in this set, by [`Device::ptr_id`].
    Only(Arc<HashSet<usize>>),
}

impl Visit {
    fn includes(&self, device: &Device) -> bool {
        match self {
            Self::All => true,
            Self::Drawn => !device.is_empty(),
            Self::Only(cells) => cells.contains(&device.ptr_id()),
        }
    }
}

/// The state of the iteration over the references of one cell.
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
    fn next_child(&mut self, visit: &Visit) -> Option<(&'a Device, Transform)> {
        loop {
            let reference = self.device.references().get(self.reference)?;
            let (columns, rows) = reference.array().map_or((1, 1), |a| (a.columns, a.rows));
            let (column, row) = self.element;
            let skipped = self.element == (0, 0) && !visit.includes(reference.device());
            if skipped || column >= columns || row >= rows {
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
        if let Some((device, transform)) = self.start.take() {
            return Some(self.enter(device, transform));
        }
        while let Some(frame) = self.frames.last_mut() {
            match frame.next_child(&self.visit) {
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
    /// The placed cells from one cell on, which has this transform.
    pub(super) fn new(device: &'a Device, transform: Transform) -> Self {
        Self { start: Some((device, transform)), frames: Vec::new(), deepest: usize::MAX, visit: Visit::All }
    }

    /// Skips placed cells that draw nothing.
    pub(super) fn drawn(self) -> Self {
        Self { visit: Visit::Drawn, ..self }
    }

    /// Skips placed cells outside a set of [`Device::ptr_id`].
    pub(super) fn only(self, cells: Arc<HashSet<usize>>) -> Self {
        Self { visit: Visit::Only(cells), ..self }
    }

    fn enter(&mut self, device: &'a Device, transform: Transform) -> Instance<'a> {
        let depth = self.frames.len();
        if depth < self.deepest {
            self.frames.push(Frame::new(device, transform));
        } else {
            // A frame at the end of its references keeps the depth right and is popped by the next call.
            let past_the_end = device.references().len();
            self.frames.push(Frame { reference: past_the_end, ..Frame::new(device, transform) });
        }
        Instance { device, transform, depth }
    }
}

#[cfg(feature = "parallel")]
impl<'a> Instances<'a> {
    /// An exhausted iterator over the cells that draw something; position it by pushing frames from the top cell down.
    pub(super) fn exhausted() -> Self {
        Self { start: None, frames: Vec::new(), deepest: usize::MAX, visit: Visit::Drawn }
    }

    /// Pushes a frame that resumes after one element of one reference.
    pub(super) fn push_after(&mut self, device: &'a Device, transform: Transform, reference: usize, last: (u32, u32)) {
        let mut frame = Frame { reference, element: last, ..Frame::new(device, transform) };
        frame.next_child(&self.visit);
        self.frames.push(frame);
    }

    /// Pushes a frame that begins with the first placed cell of a cell.
    pub(super) fn push_before_children(&mut self, device: &'a Device, transform: Transform) {
        self.frames.push(Frame::new(device, transform));
    }
}

/// A polygon of a hierarchy in top-level coordinates.
#[derive(Debug, Clone)]
pub struct FlatPolygon<'a> {
    /// The cell that it belongs to; for a box, the cell that the box stands for.
    pub device: &'a Device,
    /// Its layer; a box that stands for a cell has none.
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
    /// The corners in top-level coordinates, in order.
    pub fn points(&self) -> impl ExactSizeIterator<Item = Point> + DoubleEndedIterator + Clone + '_ {
        let matrix = self.matrix;
        self.stored().iter().map(move |p| matrix.apply(*p))
    }

    /// The number of corners.
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

    /// The polygon as a value.
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

/// An iterator over the polygons of a whole hierarchy: those of a cell first, then those of its references, in order.
/// Made by [`Device::flat_polygons`].
#[derive(Debug, Clone)]
pub struct FlatPolygons<'a> {
    instances: Instances<'a>,
    current: Option<(Instance<'a>, Matrix, usize)>,
    layers: Option<Layers>,
    boxes_at: Option<usize>,
}

impl<'a> FlatPolygons<'a> {
    /// The polygons of some placed cells.
    pub(super) fn of(instances: Instances<'a>) -> Self {
        Self { instances: instances.drawn(), current: None, layers: None, boxes_at: None }
    }
}

impl FlatPolygons<'_> {
    /// Only those on these layers.
    #[must_use]
    pub fn on(self, layers: impl Into<Layers>) -> Self {
        Self { layers: Some(layers.into()), ..self }
    }

    /// Follows references `depth` levels down; cells below are replaced by their bounding boxes. With depth 0, all
    /// references of the top cell are boxes.
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
        let polygons = &instance.device.cell().polygons;
        while *next < polygons.len() {
            let view: PolygonView<'a> = polygons.get(*next);
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
    /// Every placed cell of the hierarchy with its transform: this cell first, then what its references place, in order.
    #[must_use]
    pub fn instances(&self) -> Instances<'_> {
        Instances::new(self, Transform::IDENTITY)
    }

    /// Every polygon of the hierarchy in the coordinates of this cell: its own first, then those of its references, in
    /// order. Nothing is copied.
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
        FlatPolygons::of(self.instances())
    }
}
