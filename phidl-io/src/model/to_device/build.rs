//! Cells of the model into devices.

use phidl_core::geom::{Outline, Point, Transform};
use phidl_core::layer::{Layer, Layers};
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Anchor, Array, Device, DeviceBuilder, Label, Polygon, Reference, TextStyle};

use super::order::Order;
use super::wire::{self, Step};
use crate::error::{IoError, Result};
use crate::model::{Cell, Corner, Layout, Placement, ProblemKind, Text};

/// Builds the devices of some top cells with all that they place. The cells are taken out of the layout, so that its
/// memory is free when its devices are there. `layers`: what is kept; everything unless given.
///
/// # Errors
/// [`IoError::CyclicCells`], [`IoError::TooDeep`]; [`IoError::Device`].
pub(crate) fn devices(layout: &mut Layout, file: &str, tops: &[usize], layers: Option<&Layers>) -> Result<Devices> {
    let mut order = Order::new(layout, file);
    let orders: Vec<Vec<usize>> = tops.iter().map(|top| order.below(*top)).collect::<Result<_>>()?;
    let mut builder = Builder {
        file,
        layers,
        grid: layout.grid,
        devices: vec![None; layout.names.len()],
        left_out: 0,
        missing: vec![false; layout.names.len()],
    };
    for index in orders.into_iter().flatten() {
        let id = layout.cells[index].name;
        let cell = std::mem::replace(&mut layout.cells[index], Cell::new(id));
        builder.cell(cell, layout)?;
    }
    let tops = tops.iter().map(|top| layout.cells[*top].name);
    let tops = tops.map(|name| builder.devices[name.index()].clone()).collect::<Option<Vec<_>>>();
    Ok(Devices { tops: tops.expect("invariant: every top cell is in an order"), left_out: builder.left_out })
}

/// What [`devices`] built.
pub(crate) struct Devices {
    /// The devices of the top cells.
    pub(crate) tops: Vec<Device>,
    /// Polygons, paths, boxes and texts on layers that were not asked for.
    pub(crate) left_out: u64,
}

struct Builder<'a> {
    file: &'a str,
    layers: Option<&'a Layers>,
    grid: Grid,
    /// The device of each cell name.
    devices: Vec<Option<Device>>,
    left_out: u64,
    /// Names of missing cells that are listed already.
    missing: Vec<bool>,
}

/// The corners of an outline in grid steps.
struct OnGrid<'a, T>(&'a [[T; 2]], Grid);

impl<T: Copy + Into<i64>> Outline for OnGrid<'_, T> {
    fn append_to(self, buffer: &mut Vec<Point>) {
        let Self(corners, grid) = self;
        buffer.extend(corners.iter().map(|[x, y]| Point::new(grid.um((*x).into()), grid.um((*y).into()))));
    }
}

impl Builder<'_> {
    fn cell(&mut self, cell: Cell, layout: &mut Layout) -> Result<()> {
        let name = layout.names.name(cell.name).to_owned();
        let device = self.open(&cell, &name, layout).and_then(|open| open.build()).map_err(|source| {
            IoError::Device { place: format!("{}: cell {name:?}", self.file).into(), source: Box::new(source) }
        })?;
        self.devices[cell.name.index()] = Some(device);
        Ok(())
    }

    fn open(&mut self, cell: &Cell, name: &str, layout: &mut Layout) -> phidl_core::Result<DeviceBuilder> {
        let mut open = Device::builder(name);
        open.reserve(cell.polygons.len(), cell.polygons.corner_count());
        for polygon in cell.polygons.iter() {
            if self.is_kept(polygon.layer) {
                let key = open.add_polygon(OnGrid(polygon.corners, self.grid), polygon.layer)?;
                if let Some(properties) = polygon.properties {
                    open.set_properties(key, properties.clone())?;
                }
            }
        }
        for element in &cell.boxes {
            if self.is_kept(element.layer) {
                let key = open.add_polygon(OnGrid(&element.corners, self.grid), element.layer)?;
                open.set_properties(key, element.properties.clone())?;
            }
        }
        for path in &cell.paths {
            let outlines = if self.is_kept(path.layer) { wire::outlines(path) } else { continue };
            if path.fixed_width {
                layout.problems.push(name, path.offset, ProblemKind::Absolute);
            }
            if outlines.is_empty() {
                layout.problems.push(name, path.offset, ProblemKind::Empty);
            }
            for outline in outlines {
                self.polygon(&mut open, &outline, path.layer, &path.properties)?;
            }
        }
        for text in &cell.texts {
            if self.is_kept(text.layer) {
                open.add(self.label(text));
            }
        }
        for placement in &cell.placements {
            let child = self.child(placement, name, layout)?;
            open.add(self.reference(child, placement));
        }
        Ok(open)
    }

    fn polygon(
        &self,
        open: &mut DeviceBuilder,
        outline: &[Step],
        layer: Layer,
        properties: &phidl_core::scene::Properties,
    ) -> phidl_core::Result<()> {
        let mut polygon = Polygon::new(OnGrid(outline, self.grid), layer);
        polygon.properties = properties.clone();
        open.add(polygon);
        Ok(())
    }

    fn is_kept(&mut self, layer: Layer) -> bool {
        let kept = self.layers.is_none_or(|layers| layers.iter().any(|kept| kept == layer));
        self.left_out += u64::from(!kept);
        kept
    }

    /// The device that a placement places; an empty one if the file does not have it.
    fn child(&mut self, placement: &Placement, cell: &str, layout: &mut Layout) -> phidl_core::Result<Device> {
        let index = placement.child.index();
        if self.devices[index].is_none() {
            let name = layout.names.name(placement.child).to_owned();
            self.devices[index] = Some(Device::builder(&name).build()?);
            if !std::mem::replace(&mut self.missing[index], true) {
                layout.problems.push(cell, placement.offset, ProblemKind::MissingCell(name.into()));
            }
        }
        Ok(self.devices[index].clone().expect("invariant: it was made above"))
    }

    fn label(&self, text: &Text) -> Label {
        let transform = Transform {
            x_reflection: text.x_reflection,
            magnification: text.magnification.unwrap_or(1.0),
            rotation: text.rotation,
            origin: self.point(text.origin),
        };
        let style = TextStyle {
            font: text.font,
            path_type: text.path_type,
            width: text.width.map(|width| self.grid.um(width.into())),
            anchor_unstated: text.anchor.is_none(),
            magnification_stated: text.magnification == Some(1.0),
        };
        let label = Label::new(text.string.clone(), transform.origin, text.layer).with_transform(transform);
        let mut label = label.anchored(text.anchor.unwrap_or(Anchor::NorthWest)).with_style(style);
        label.properties = text.properties.clone();
        label
    }

    fn reference(&self, child: Device, placement: &Placement) -> Reference {
        let transform = Transform {
            x_reflection: placement.x_reflection,
            magnification: placement.magnification,
            rotation: placement.rotation,
            origin: self.point(placement.origin),
        };
        let mut reference = Reference::new(child, transform);
        if let Some(lattice) = placement.lattice.as_deref() {
            // The steps of an array are in its own frame: those of the file with turn and reflection undone.
            let frame = Transform { magnification: 1.0, origin: Point::ORIGIN, ..transform }.inverse();
            let um = |extent: [i64; 2]| Point::new(self.grid.um(extent[0]), self.grid.um(extent[1]));
            let step = |extent, count: u32| frame.apply_vector(um(extent) / f64::from(count));
            reference = reference.with_array(Array {
                columns: lattice.columns,
                rows: lattice.rows,
                column_step: step(lattice.column_extent, lattice.columns),
                row_step: step(lattice.row_extent, lattice.rows),
            });
        }
        if let Some(properties) = &placement.properties {
            reference.properties = (**properties).clone();
        }
        reference
    }

    fn point(&self, [x, y]: Corner) -> Point {
        Point::new(self.grid.um(x.into()), self.grid.um(y.into()))
    }
}
