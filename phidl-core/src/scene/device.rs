//! [`Device`]: the finished cell.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use triomphe::Arc;

use super::leaves_first::{leaves_first, placed, placed_and_recorded, release};
use super::{Array, Cell, DeviceBuilder, Label, PolygonView, Reference, Source};
use crate::error::Result;
use crate::geom::{Point, Rect, Transform, convex_hull};
use crate::hash::{self, Digest};
use crate::layer::Layer;
use crate::param::Value;
use crate::place::Bounded;
use crate::port::Port;

/// A finished cell: immutable, shared, cheap to clone, safe to use from several threads.
///
/// A finished cell never changes; [`Device::edit`] opens a copy. Two devices are equal if their contents are, including
/// ports and info; [`Device::same_cell`] tests whether they are the same object.
#[derive(Clone)]
pub struct Device(Arc<Finished>);

/// A cell with its cached properties.
pub(super) struct Finished {
    pub(super) cell: Cell,
    bbox: OnceLock<Option<Rect>>,
    hull: OnceLock<Box<[Point]>>,
    content: OnceLock<Digest>,
    drawing: OnceLock<Digest>,
}

impl Finished {
    pub(super) fn new(cell: Cell) -> Self {
        Self { cell, bbox: OnceLock::new(), hull: OnceLock::new(), content: OnceLock::new(), drawing: OnceLock::new() }
    }
}

impl Device {
    /// Opens a new, empty cell.
    #[must_use]
    pub fn builder(name: impl AsRef<str>) -> DeviceBuilder {
        DeviceBuilder::new(name.as_ref())
    }

    pub(crate) fn from_cell(cell: Cell) -> Self {
        Self(Arc::new(Finished::new(cell)))
    }

    pub(super) fn of(finished: Arc<Finished>) -> Self {
        Self(finished)
    }

    /// Opens a copy of this cell. The copy keeps the name but not the record of the generator.
    #[must_use]
    pub fn edit(&self) -> DeviceBuilder {
        DeviceBuilder::from_cell(Cell { source: None, ..self.cell().clone() })
    }

    /// Opens an empty cell that keeps info and generator of this one: for programs that draw the same cell in other
    /// coordinates, as a writer does.
    #[must_use]
    pub fn redrawn(&self, name: impl AsRef<str>) -> DeviceBuilder {
        let Cell { info, source, .. } = self.cell();
        let (info, source) = (info.clone(), source.clone());
        DeviceBuilder::from_cell(Cell { name: name.as_ref().into(), info, source, ..Cell::default() })
    }

    /// The same cell under another name.
    #[must_use]
    pub fn renamed(mut self, name: impl AsRef<str>) -> Self {
        match Arc::get_mut(&mut self.0) {
            Some(finished) => {
                finished.cell.name = name.as_ref().into();
                finished.content = OnceLock::new(); // takes the name in
                self
            }
            None => Self::from_cell(Cell { name: name.as_ref().into(), ..self.cell().clone() }),
        }
    }

    /// A placement of this cell at the origin.
    #[must_use]
    pub fn place(&self) -> Reference {
        Reference::new(self.clone(), Transform::IDENTITY)
    }

    /// A regular array of this cell, the first element at the origin; `spacing` is from column to column and from row to row
    /// (µm).
    #[must_use]
    pub fn array(&self, columns: u32, rows: u32, spacing: impl Into<Point>) -> Reference {
        let spacing = spacing.into();
        self.place().with_array(Array {
            columns,
            rows,
            column_step: Point::new(spacing.x, 0.0),
            row_step: Point::new(0.0, spacing.y),
        })
    }

    /// The name of the cell. A file may need another one; it is made when the file is written.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.cell().name
    }

    /// Whether both are the same object, not only equal.
    #[must_use]
    pub fn same_cell(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// The identity of this cell among all cells that are alive: for tables of cells within a run of the program.
    #[must_use]
    pub fn ptr_id(&self) -> usize {
        Arc::as_ptr(&self.0) as usize
    }

    /// A port.
    ///
    /// # Errors
    /// [`Error::Unknown`](crate::Error::Unknown) with the names that exist.
    pub fn port(&self, name: &str) -> Result<&Port> {
        self.cell().port(name)
    }

    /// The ports, in the order in which they were added.
    pub fn ports(&self) -> impl ExactSizeIterator<Item = &Port> {
        self.cell().ports.iter()
    }

    /// The reference under an alias.
    ///
    /// # Errors
    /// [`Error::Unknown`](crate::Error::Unknown) with the aliases that exist.
    pub fn get(&self, alias: &str) -> Result<&Reference> {
        Ok(&self.cell().references[self.cell().alias(alias)?])
    }

    /// The aliases with their references, in the order in which they were added.
    pub fn aliases(&self) -> impl ExactSizeIterator<Item = (&str, &Reference)> {
        self.cell().aliases.iter().map(|alias| (alias.name.as_str(), &self.cell().references[alias.index]))
    }

    /// The polygons of this cell itself, in the order in which they were added. For those of the whole hierarchy see
    /// [`Device::flat_polygons`].
    pub fn polygons(&self) -> impl ExactSizeIterator<Item = PolygonView<'_>> + DoubleEndedIterator + Clone {
        self.cell().polygons.iter()
    }

    /// The polygon with an index, in the order in which they were added.
    #[must_use]
    pub fn polygon(&self, index: usize) -> Option<PolygonView<'_>> {
        let outlines = &self.cell().polygons;
        (index < outlines.len()).then(|| outlines.get(index))
    }

    /// The references of this cell, in the order in which they were added.
    #[must_use]
    pub fn references(&self) -> &[Reference] {
        &self.cell().references
    }

    /// The labels of this cell itself, in the order in which they were added.
    #[must_use]
    pub fn labels(&self) -> &[Label] {
        &self.cell().labels
    }

    /// The values recorded about the cell.
    #[must_use]
    pub fn info(&self) -> &BTreeMap<String, Value> {
        &self.cell().info
    }

    /// The generator that drew the cell, with its parameters, if one did.
    #[must_use]
    pub fn source(&self) -> Option<&Source> {
        self.cell().source.as_ref()
    }

    /// Whether the cell and all cells below it have no polygons.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bbox().is_none()
    }

    /// The identity of the content: equal for cells with equal drawing, names, ports, info and generator, on every machine
    /// and in every run. Computed on the first call.
    #[must_use]
    pub fn content_hash(&self) -> Digest {
        let known = |device: &Self| device.0.content.get().is_some();
        let compute = |device: &Self| _ = device.0.content.get_or_init(|| hash::content(device.cell()));
        leaves_first(self, placed_and_recorded, known, compute);
        *self.0.content.get_or_init(|| hash::content(self.cell()))
    }

    /// The identity of the drawing: equal for cells with equal polygons, references and labels, in order, on all levels,
    /// whatever their names, ports and info. Computed on the first call.
    #[must_use]
    pub fn drawing_hash(&self) -> Digest {
        let known = |device: &Self| device.0.drawing.get().is_some();
        let compute = |device: &Self| _ = device.0.drawing.get_or_init(|| hash::drawing(device.cell()));
        leaves_first(self, placed, known, compute);
        *self.0.drawing.get_or_init(|| hash::drawing(self.cell()))
    }

    /// PHIDL's order-sensitive SHA-1 of all polygons of the hierarchy, as 40 hexadecimal digits, for comparing results.
    /// Coordinates are truncated to `precision` (µm, usually 1e-4).
    ///
    /// Layers, vertex order and first vertices matter; polygon order, hierarchy, ports and labels do not.
    ///
    /// # Errors
    /// [`Error::Invalid`](crate::Error::Invalid) unless the precision is a positive length; [`Error::TooLarge`](crate::Error::TooLarge)
    /// beyond [`FLAT_LIMIT`](super::FLAT_LIMIT).
    pub fn hash_geometry(&self, precision: f64) -> Result<String> {
        hash::geometry(self, precision)
    }

    /// The corners of the convex hull of all polygons. The bounding box of a rotated placement depends on nothing else.
    #[must_use]
    pub fn hull(&self) -> &[Point] {
        let known = |device: &Self| device.0.hull.get().is_some();
        let compute = |device: &Self| _ = device.0.hull.get_or_init(|| hull_of(device.cell()).into());
        leaves_first(self, placed, known, compute);
        self.0.hull.get_or_init(|| hull_of(self.cell()).into())
    }

    /// The layers of all polygons in this cell and below, ascending.
    #[must_use]
    pub fn layers(&self) -> Vec<Layer> {
        let mut layers: Vec<Layer> =
            self.cells().iter().flat_map(|cell| cell.polygons().map(|p| p.layer).collect::<Vec<_>>()).collect();
        layers.sort_unstable();
        layers.dedup();
        layers
    }

    pub(crate) fn cell(&self) -> &Cell {
        &self.0.cell
    }

    /// The same cell with the record of the generator that drew it.
    pub(crate) fn with_source(mut self, source: Source) -> Self {
        let source = Some(source);
        match Arc::get_mut(&mut self.0) {
            Some(finished) => {
                finished.cell.source = source;
                finished.content = OnceLock::new(); // it includes the source
                self
            }
            None => Self::from_cell(Cell { source, ..self.cell().clone() }),
        }
    }

    /// The approximate size of this cell in bytes, without the cells that it places.
    pub(crate) fn own_size(&self) -> usize {
        let cell = self.cell();
        let map_entry = 128;
        size_of::<Finished>()
            + cell.polygons.heap_size()
            + cell.references.capacity() * size_of::<Reference>()
            + cell.labels.capacity() * size_of::<Label>()
            + (cell.ports.len() + cell.aliases.len() + cell.info.len()) * map_entry
    }
}

/// The convex hull of a cell, from its own points and from the hulls of what it places.
fn hull_of(cell: &Cell) -> Vec<Point> {
    /// The hull is built in batches, so that a huge cell does not copy all its points.
    const BATCH: usize = 4096;
    let mut hull = Vec::new();
    for batch in cell.polygons.all_points().chunks(BATCH) {
        hull.extend_from_slice(batch);
        hull = convex_hull(hull);
    }
    for reference in &cell.references {
        let placed = reference.device().hull();
        if placed.is_empty() {
            continue;
        }
        for element in reference.corner_elements() {
            let matrix = element.matrix();
            hull.extend(placed.iter().map(|p| matrix.apply(*p)));
        }
        if hull.len() > BATCH {
            hull = convex_hull(hull);
        }
    }
    convex_hull(hull)
}

impl Drop for Finished {
    fn drop(&mut self) {
        release(&mut self.cell);
    }
}

impl Bounded for Device {
    /// The bounding box of all polygons and references; ports and labels do not count. Cached.
    fn bbox(&self) -> Option<Rect> {
        if let Some(bbox) = self.0.bbox.get() {
            return *bbox;
        }
        let known = |device: &Self| device.0.bbox.get().is_some();
        leaves_first(self, placed, known, |device| _ = device.0.bbox.get_or_init(|| device.cell().bbox()));
        *self.0.bbox.get_or_init(|| self.cell().bbox())
    }
}

impl From<&Device> for Device {
    /// The same cell, as a clone.
    fn from(device: &Device) -> Self {
        device.clone()
    }
}

impl PartialEq for Device {
    fn eq(&self, other: &Self) -> bool {
        self.same_cell(other) || self.content_hash() == other.content_hash()
    }
}

impl Eq for Device {}

impl std::fmt::Debug for Device {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}

impl std::fmt::Display for Device {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let cell = self.cell();
        write!(
            f,
            "Device (name {:?}, ports {:?}, aliases {:?}, {} polygons, {} references)",
            cell.name,
            cell.ports.names().collect::<Vec<_>>(),
            cell.aliases.names().collect::<Vec<_>>(),
            cell.polygons.len(),
            cell.references.len()
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_can_be_shared_between_threads() {
        fn assert_shared<T: Send + Sync + Clone>() {}
        assert_shared::<Device>();
    }
}
