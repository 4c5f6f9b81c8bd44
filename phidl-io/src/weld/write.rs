//! Forms: cells as they are written, in coordinates that lie on the grid.

use std::collections::{BTreeMap, HashMap};

use phidl_core::geom::{Point, Rect, Transform};
use phidl_core::hash::Digest;
use phidl_core::scene::{Array, Device, DeviceBuilder, Reference};

use super::corner::Corner;
use super::linear::Orientation;
use super::plan::{AnchorKey, Layout, Node, Placement, Plan, Rest};
use super::polygon::{self, Welded};
use super::report::{Counts, FormReport};
use crate::error::{IoError, Result};

/// Digits of the digest in the name of a form.
const DIGITS: usize = 8;

/// Writes the forms of all anchors, those of inner cells first.
pub(super) struct FormWriter<'a> {
    pub(super) layout: &'a Layout<'a>,
    /// Names are cut to this many bytes.
    pub(super) name_limit: usize,
    pub(super) anchors: HashMap<AnchorKey, Device>,
    /// Forms by the address of their cell and the digest of what they draw.
    known: HashMap<(usize, Digest), Device>,
    pub(super) forms: Vec<FormReport>,
    pub(super) counts: Counts,
}

/// Column and row of an element of an array.
type Element = (u32, u32);

/// What a node is written as: a cell and the frame in which it is placed.
struct Written {
    device: Device,
    frame: (Orientation, Corner),
}

impl<'a> FormWriter<'a> {
    pub(super) fn new(layout: &'a Layout<'a>, name_limit: usize) -> Self {
        Self {
            layout,
            name_limit,
            anchors: HashMap::new(),
            known: HashMap::new(),
            forms: Vec::new(),
            counts: Counts::default(),
        }
    }

    /// Writes one anchor; the anchors that it places are written.
    pub(super) fn write(&mut self, key: AnchorKey, plan: &Plan) -> Result<()> {
        let upright = key.1 == 0.0_f64.to_bits() && key.2 == 1.0_f64.to_bits();
        let mut written: Vec<Option<Written>> = plan.nodes.iter().map(|_| None).collect();
        for (number, node) in plan.nodes.iter().enumerate().rev() {
            let keeps_name = number == 0 && upright;
            let device = self.node(plan, node, &written, keeps_name)?;
            written[number] = Some(Written { device, frame: node.placement.frame() });
        }
        if let Some(Some(root)) = written.into_iter().next() {
            self.anchors.insert(key, root.device);
        }
        Ok(())
    }

    fn node(&mut self, plan: &Plan, node: &Node, below: &[Option<Written>], keeps_name: bool) -> Result<Device> {
        let original = self.layout.cells.list[node.cell].device.clone();
        let mut form = Form { layout: self.layout, plan, node, changed: node.placement.is_baked() };
        let mut cell = original.redrawn(original.name());
        form.polygons(&original, &mut cell, &mut self.counts)?;
        form.labels(&original, &mut cell);
        form.references(&original, &mut cell, below, &self.anchors, &mut self.counts)?;
        if !form.changed {
            return Ok(original);
        }
        form.ports(&original, &mut cell)?;
        let device = cell.build().map_err(|error| unfit(&original, &error))?;
        if keeps_name {
            return Ok(device);
        }
        let digest = device.drawing_hash();
        let known = (original.ptr_id(), digest);
        if let Some(form) = self.known.get(&known) {
            return Ok(form.clone());
        }
        let name = form_name(original.name(), digest, self.name_limit);
        let device = device.renamed(&name);
        self.forms.push(FormReport {
            name,
            cell: original.name().to_owned(),
            rotation: node.placement.linear.residue,
            magnification: node.placement.linear.magnification,
        });
        self.known.insert(known, device.clone());
        Ok(device)
    }
}

/// The name of a cell, as much of it as fits, with the first digits of what the form draws.
fn form_name(base: &str, digest: Digest, limit: usize) -> String {
    let digits = &digest.to_string()[..DIGITS];
    let room = limit.saturating_sub(DIGITS + 2);
    let cut = base.char_indices().map(|(at, c)| at + c.len_utf8()).take_while(|end| *end <= room).last().unwrap_or(0);
    format!("{}_w{digits}", &base[..cut])
}

fn unfit(cell: &Device, error: &phidl_core::Error) -> IoError {
    IoError::Device { place: cell.name().into(), source: Box::new(error.clone()) }
}

/// One cell on its way into a form.
struct Form<'f> {
    layout: &'f Layout<'f>,
    plan: &'f Plan,
    node: &'f Node,
    changed: bool,
}

impl Form<'_> {
    fn placement(&self) -> &Placement {
        &self.node.placement
    }

    /// A grid point of the anchor's frame, in the frame of the form (µm).
    fn local(&self, corner: Corner) -> Point {
        let (orientation, origin) = self.placement().frame();
        let [x, y] = orientation.inverse().apply([corner[0] - origin[0], corner[1] - origin[1]]);
        Point::new(self.layout.grid.um(x), self.layout.grid.um(y))
    }

    fn polygons(&mut self, original: &Device, cell: &mut DeviceBuilder, counts: &mut Counts) -> Result<()> {
        let truth = self.placement().matrix;
        for polygon in original.polygons() {
            let placed: Vec<Point> = polygon.points.iter().map(|p| truth.apply(*p)).collect();
            let near = match (self.plan.classes.is_empty(), Rect::around(placed.iter().copied())) {
                (false, Some(rect)) => self.plan.classes.near(&rect.grown(self.layout.reach)),
                _ => Vec::new(),
            };
            let placement = &self.node.placement;
            let mut corners = None;
            if placement.is_baked() || !near.is_empty() {
                let rounded: Vec<Corner> =
                    polygon.points.iter().map(|p| placement.corner(*p, self.layout.grid)).collect();
                let welded = match near.is_empty() {
                    true => Welded::Unchanged,
                    false => polygon::weld(&placed, &rounded, polygon.layer, &near, self.layout.reach),
                };
                corners = match welded {
                    Welded::Changed(corners, inserted) => {
                        counts.inserted_vertices += inserted;
                        self.changed = true;
                        Some(corners)
                    }
                    Welded::Squeezed => {
                        counts.squeezed += 1;
                        placement.is_baked().then_some(rounded)
                    }
                    Welded::Unchanged => placement.is_baked().then_some(rounded),
                };
            }
            let points: Vec<Point> = match corners {
                Some(corners) => corners.into_iter().map(|corner| self.local(corner)).collect(),
                None => polygon.points.to_vec(),
            };
            let key = cell.add_polygon(&points, polygon.layer).map_err(|error| unfit(original, &error))?;
            let properties: phidl_core::scene::Properties =
                polygon.properties().map(|(attribute, text)| (attribute, text.to_owned())).collect();
            if !properties.is_empty() {
                cell.set_properties(key, properties).map_err(|error| unfit(original, &error))?;
            }
        }
        Ok(())
    }

    /// A placement in the cell, as one in the frame of the form: linear part composed, origin on the grid.
    fn placed(&self, own: &Transform) -> Transform {
        if !self.placement().is_baked() {
            return *own;
        }
        let below = self.placement().below(own, self.layout.grid);
        let (orientation, _) = self.placement().frame();
        let linear = below.truth.then(&orientation.inverse().transform());
        Transform { origin: self.local(below.frame().1), ..linear }
    }

    fn labels(&self, original: &Device, cell: &mut DeviceBuilder) {
        for label in original.labels() {
            let transform = self.placed(label.transform());
            cell.add(label.clone().with_transform(transform));
        }
    }

    fn ports(&self, original: &Device, cell: &mut DeviceBuilder) -> Result<()> {
        use phidl_core::place::Transformable;
        let (orientation, origin) = self.placement().frame();
        let origin = Point::new(self.layout.grid.um(origin[0]), self.layout.grid.um(origin[1]));
        let frame = Transform { origin, ..orientation.transform() };
        let to_form = self.placement().truth.then(&frame.inverse());
        for port in original.ports() {
            let mut placed = port.clone();
            if self.placement().is_baked() {
                placed.transform_mut(&to_form);
            }
            cell.add_port(port.name(), placed).map_err(|error| unfit(original, &error))?;
        }
        Ok(())
    }

    fn references(
        &mut self,
        original: &Device,
        cell: &mut DeviceBuilder,
        below: &[Option<Written>],
        anchors: &HashMap<AnchorKey, Device>,
        counts: &mut Counts,
    ) -> Result<()> {
        let mut exposed: BTreeMap<usize, Vec<(Element, usize)>> = BTreeMap::new();
        for ((reference, element), child) in &self.node.exposed {
            exposed.entry(*reference).or_default().push((*element, *child));
        }
        for (number, reference) in original.references().iter().enumerate() {
            let taken = exposed.remove(&number).unwrap_or_default();
            for ((column, row), child) in &taken {
                let Some(written) = &below[*child] else { continue };
                let own = reference.element(*column, *row);
                let as_before = self.is_as_before(written, reference);
                let transform = if as_before { own } else { self.framed(written.frame) };
                self.changed |= !as_before;
                let mut placed = Reference::new(written.device.clone(), transform);
                placed.properties = reference.properties.clone();
                cell.add(placed);
            }
            let taken: Vec<(u32, u32)> = taken.into_iter().map(|(element, _)| element).collect();
            if !taken.is_empty() && reference.array().is_some() {
                counts.arrays_split += 1;
                self.changed = true;
            }
            for block in blocks_without(reference, &taken) {
                self.rest(&block, cell, anchors);
            }
        }
        Ok(())
    }

    /// Whether an exposed placement turned out to be written as it was.
    fn is_as_before(&self, written: &Written, reference: &Reference) -> bool {
        !self.placement().is_baked() && reference.array().is_none() && written.device.same_cell(reference.device())
    }

    /// The placement of a frame of the anchor in the frame of the form.
    fn framed(&self, (orientation, origin): (Orientation, Corner)) -> Transform {
        let (own, _) = self.placement().frame();
        Transform { origin: self.local(origin), ..orientation.then(own.inverse()).transform() }
    }

    /// Adds placements that are not exposed.
    fn rest(&mut self, block: &Reference, cell: &mut DeviceBuilder, anchors: &HashMap<AnchorKey, Device>) {
        let (device, transform) = match self.layout.rest(self.placement(), block) {
            Rest::AsIs => (block.device(), self.placed(block.transform())),
            Rest::Anchor { key, keeps_linear } => {
                let device = anchors.get(&key).unwrap_or(block.device());
                self.changed |= !device.same_cell(block.device());
                let below = self.placement().below(block.transform(), self.layout.grid);
                let transform = match keeps_linear {
                    true => self.placed(block.transform()),
                    false => {
                        self.changed = true;
                        self.framed(below.frame())
                    }
                };
                (device, transform)
            }
        };
        let mut placed = Reference::new(device.clone(), transform);
        if let Some(array) = block.array() {
            let step = |step: Point| self.array_step(block.placed_step(step), &transform);
            let (column_step, row_step) = match transform == *block.transform() {
                true => (array.column_step, array.row_step),
                false => (step(array.column_step), step(array.row_step)),
            };
            placed = placed.with_array(Array { column_step, row_step, ..*array });
        }
        placed.properties = block.properties.clone();
        cell.add(placed);
    }

    /// A step in the cell's frame as a step in the own frame of an array with this transform.
    fn array_step(&self, step: Point, transform: &Transform) -> Point {
        let placed = self.placement().truth.apply_vector(step);
        let (orientation, _) = self.placement().frame();
        let local = orientation.inverse().apply_vector(placed);
        Transform { magnification: 1.0, origin: Point::ORIGIN, ..*transform }.inverse().apply_vector(local)
    }
}

/// A reference without some of its elements, as references: rows that are whole together, runs in rows that are not.
fn blocks_without(reference: &Reference, taken: &[(u32, u32)]) -> Vec<Reference> {
    if taken.is_empty() {
        return vec![reference.clone()];
    }
    let Some(array) = reference.array().copied() else { return Vec::new() };
    let mut by_row: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for (column, row) in taken {
        by_row.entry(*row).or_default().push(*column);
    }
    let block = |column: u32, row: u32, columns: u32, rows: u32| {
        let mut part = Reference::new(reference.device().clone(), reference.element(column, row));
        part.properties = reference.properties.clone();
        (columns > 0 && rows > 0).then(|| part.with_array(Array { columns, rows, ..array }))
    };
    let mut blocks = Vec::new();
    let mut next_row = 0;
    for (row, mut columns) in by_row {
        blocks.extend(block(0, next_row, array.columns, row - next_row));
        columns.sort_unstable();
        let mut next = 0;
        for column in columns {
            blocks.extend(block(next, row, column - next, 1));
            next = column + 1;
        }
        blocks.extend(block(next, row, array.columns - next, 1));
        next_row = row + 1;
    }
    blocks.extend(block(0, next_row, array.columns, array.rows - next_row));
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_array_without_some_elements_is_the_others() {
        let mut d = Device::builder("dot");
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
        let array = d.build().unwrap().array(5, 4, (10, 20));
        let taken = [(0, 0), (2, 1), (4, 1), (3, 3)];
        let order = |a: &Point, b: &Point| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y));
        let mut left: Vec<Point> = blocks_without(&array, &taken)
            .iter()
            .flat_map(|block| block.elements().map(|element| element.origin).collect::<Vec<_>>())
            .collect();
        left.sort_by(order);
        let mut expected: Vec<Point> = (0..5)
            .flat_map(|column| (0..4).map(move |row| (column, row)))
            .filter(|element| !taken.contains(element))
            .map(|(column, row)| array.element(column, row).origin)
            .collect();
        expected.sort_by(order);
        assert_eq!(left, expected);
    }

    #[test]
    fn names_are_cut_to_fit() {
        let mut d = Device::builder("x");
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
        let digest = d.build().unwrap().drawing_hash();
        let name = form_name("a_very_long_name_of_a_cell_without_end", digest, 32);
        assert_eq!((name.len(), &name[..24]), (32, "a_very_long_name_of_a__w"));
    }
}
