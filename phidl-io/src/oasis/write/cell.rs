//! The elements of a cell as records.

use indexmap::IndexMap;
use phidl_core::layer::Layer;
use phidl_core::scene::Properties;

use super::super::record::{self, standard};
use super::super::repetition::Repetition;
use super::super::{encode, label, point_list};
use super::blocks::MOST_BYTES;
use super::groups::{Groups, Shape};
use super::modal::{Modal, set, set_bytes};
use super::options::EncodeOptions;
use super::repeats;
use super::strings::Tables;
use crate::model::{Cell, Corner, Path, PathEnd, Placement, Text};

/// The records of a cell, and what was done for them.
#[derive(Debug, Default)]
pub(super) struct Records {
    pub(super) bytes: Vec<u8>,
    /// Where a block may end: the last end of a record before each limit.
    pub(super) cuts: Vec<usize>,
    pub(super) records: u64,
    pub(super) repeats_merged: u64,
    pub(super) labels_simplified: u64,
    pub(super) paths_outlined: u64,
    pub(super) left_out: u64,
}

impl Records {
    /// The counts alone.
    pub(super) fn without_bytes(self) -> Self {
        Self { bytes: Vec::new(), cuts: Vec::new(), ..self }
    }
}

/// Writes the elements of a cell. `numbers` are those of the cell names, by their index in the layout.
pub(super) fn records(cell: &Cell, options: &EncodeOptions, tables: &Tables<'_>, numbers: &[u64]) -> Records {
    let mut writer =
        Writer { options, tables, numbers, modal: Modal::default(), out: Records::default(), scratch: Vec::new() };
    writer.placements(&cell.placements);
    writer.polygons(cell);
    writer.paths(&cell.paths);
    writer.texts(&cell.texts);
    writer.out.left_out += cell.nodes.len() as u64;
    writer.out
}

struct Writer<'a> {
    options: &'a EncodeOptions,
    tables: &'a Tables<'a>,
    numbers: &'a [u64],
    modal: Modal,
    out: Records,
    scratch: Vec<u8>,
}

/// What makes placements equal up to a shift.
#[derive(PartialEq, Eq, Hash)]
struct PlacementKey<'a> {
    child: u64,
    x_reflection: bool,
    magnification: u64,
    rotation: u64,
    properties: Option<&'a Properties>,
}

impl<'a> Writer<'a> {
    /// Begins a record: everything before it is whole.
    fn begin(&mut self, kind: u64) {
        let last = self.out.cuts.last().copied().unwrap_or(0);
        if self.out.bytes.len() - last > MOST_BYTES / 2 {
            self.out.cuts.push(self.out.bytes.len());
        }
        self.out.records += 1;
        encode::unsigned(kind, &mut self.out.bytes);
    }

    fn placements(&mut self, placements: &'a [Placement]) {
        let mut groups: IndexMap<PlacementKey<'_>, Vec<&Placement>> = IndexMap::new();
        for placement in placements {
            if placement.lattice.is_some() || !self.options.merge_repeats {
                self.lattice(placement);
                continue;
            }
            let key = PlacementKey {
                child: self.numbers[placement.child.index()],
                x_reflection: placement.x_reflection,
                magnification: placement.magnification.to_bits(),
                rotation: placement.rotation.to_bits(),
                properties: placement.properties.as_deref().filter(|properties| !properties.is_empty()),
            };
            groups.entry(key).or_default().push(placement);
        }
        for group in groups.into_values() {
            let positions: Vec<Corner> = group.iter().map(|placement| placement.origin).collect();
            let merged = positions.len() as u64;
            let mut records = 0;
            repeats::lists(positions, |at, repetition| {
                records += 1;
                self.placement(group[0], at, repetition);
            });
            self.out.repeats_merged += merged - records;
        }
    }

    /// Writes a single placement or an array. A lattice whose steps are not whole becomes its elements.
    fn lattice(&mut self, placement: &Placement) {
        let Some(lattice) = placement.lattice.as_deref() else {
            return self.placement(placement, placement.origin, None);
        };
        let (columns, rows) = (i64::from(lattice.columns), i64::from(lattice.rows));
        let step = |extent: [i64; 2], count: i64| extent.map(|length| length / count);
        let whole = |extent: [i64; 2], count: i64| extent.iter().all(|length| length % count == 0);
        if whole(lattice.column_extent, columns) && whole(lattice.row_extent, rows) {
            if columns == 1 && rows == 1 {
                return self.placement(placement, placement.origin, None);
            }
            let repetition = Repetition::Lattice {
                columns: u64::from(lattice.columns),
                rows: u64::from(lattice.rows),
                column_step: step(lattice.column_extent, columns),
                row_step: step(lattice.row_extent, rows),
            };
            return self.placement(placement, placement.origin, Some(&repetition));
        }
        let positions = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))).map(|(column, row)| {
            let at = |axis: usize| {
                let moved = lattice.column_extent[axis] as f64 * column as f64 / columns as f64
                    + lattice.row_extent[axis] as f64 * row as f64 / rows as f64;
                f64::from(placement.origin[axis]) + moved.round()
            };
            #[expect(clippy::cast_possible_truncation, reason = "elements of a lattice lie within 32 bits")]
            let at = [at(0) as i32, at(1) as i32];
            at
        });
        let positions: Vec<Corner> = positions.collect();
        repeats::lists(positions, |at, repetition| self.placement(placement, at, repetition));
    }

    fn placement(&mut self, placement: &Placement, at: Corner, repetition: Option<&Repetition>) {
        let quarters = [0.0, 90.0, 180.0, 270.0].iter().position(|quarter| *quarter == placement.rotation);
        let quarters = quarters.filter(|_| placement.magnification == 1.0);
        let child = self.numbers[placement.child.index()];
        self.begin(if quarters.is_some() { record::PLACEMENT } else { record::PLACEMENT_AT_ANY_ANGLE });
        let new_cell = set(&mut self.modal.placement_cell, child);
        let moved = moved(&mut self.modal.placement, at);
        let mut flags = u8::from(placement.x_reflection) | (u8::from(repetition.is_some()) << 3);
        flags |= (u8::from(moved[0]) << 5) | (u8::from(moved[1]) << 4);
        if new_cell {
            flags |= 0b1100_0000;
        }
        match quarters {
            Some(quarters) => flags |= u8::try_from(quarters).unwrap_or(0) << 1,
            None => {
                flags |= u8::from(placement.magnification != 1.0) << 2 | u8::from(placement.rotation != 0.0) << 1;
            }
        }
        let out = &mut self.out.bytes;
        out.push(flags);
        if new_cell {
            encode::unsigned(child, out);
        }
        if quarters.is_none() {
            if placement.magnification != 1.0 {
                encode::real(placement.magnification, out);
            }
            if placement.rotation != 0.0 {
                encode::real(placement.rotation, out);
            }
        }
        self.position(at, moved);
        self.repetition(repetition);
        if let Some(properties) = &placement.properties {
            self.properties(properties);
        }
    }

    fn polygons(&mut self, cell: &'a Cell) {
        let groups = Groups::of(&cell.polygons, self.options.shapes, self.options.merge_repeats);
        self.out.left_out += groups.empty;
        let (order, positions, ends) = groups.positions();
        for number in order {
            let group = &groups.groups[number];
            let start = number.checked_sub(1).map_or(0, |before| ends[before]);
            let positions = &positions[start..ends[number]];
            let mut write = |at, repetition: Option<&Repetition>| {
                match group.shape {
                    Shape::Rectangle(size) => self.rectangle(group.layer, size, at, repetition),
                    Shape::Polygon { start, end } => {
                        self.polygon(group.layer, &groups.vectors[start..end], at, repetition);
                    }
                }
                if let Some(properties) = group.properties {
                    self.properties(properties);
                }
            };
            match positions {
                [single] => write(*single, None),
                several => {
                    let mut records = 0;
                    repeats::each(several.to_vec(), |at, repetition| {
                        records += 1;
                        write(at, repetition);
                    });
                    self.out.repeats_merged += several.len() as u64 - records;
                }
            }
        }
        for element in &cell.boxes {
            let vectors: Vec<[i64; 2]> = vectors(&element.corners);
            if vectors.len() > 2 {
                self.polygon(element.layer, &vectors, element.corners[0], None);
                self.properties(&element.properties);
            } else {
                self.out.left_out += 1;
            }
        }
    }

    fn rectangle(&mut self, layer: Layer, [width, height]: [u64; 2], at: Corner, repetition: Option<&Repetition>) {
        self.begin(record::RECTANGLE);
        let square = width == height;
        let new_layer = self.set_layer(layer);
        let new_width = set(&mut self.modal.width, width);
        let new_height = set(&mut self.modal.height, height) && !square;
        let moved = moved(&mut self.modal.geometry, at);
        let mut flags = geometry_flags(new_layer, moved, repetition);
        flags |= (u8::from(square) << 7) | (u8::from(new_width) << 6) | (u8::from(new_height) << 5);
        self.out.bytes.push(flags);
        self.layer(layer, new_layer);
        if new_width {
            encode::unsigned(width, &mut self.out.bytes);
        }
        if new_height {
            encode::unsigned(height, &mut self.out.bytes);
        }
        self.position(at, moved);
        self.repetition(repetition);
    }

    fn polygon(&mut self, layer: Layer, vectors: &[[i64; 2]], at: Corner, repetition: Option<&Repetition>) {
        self.begin(record::POLYGON);
        let new_layer = self.set_layer(layer);
        let mut list = std::mem::take(&mut self.scratch);
        list.clear();
        point_list::write_polygon(vectors, &mut list);
        let new_list = set_bytes(&mut self.modal.polygon, &list);
        let moved = moved(&mut self.modal.geometry, at);
        self.out.bytes.push(geometry_flags(new_layer, moved, repetition) | (u8::from(new_list) << 5));
        self.layer(layer, new_layer);
        if new_list {
            self.out.bytes.extend_from_slice(&list);
        }
        self.scratch = list;
        self.position(at, moved);
        self.repetition(repetition);
    }

    fn paths(&mut self, paths: &[Path]) {
        for path in paths {
            let vectors = vectors(&path.points);
            let half = u64::try_from(path.width / 2).ok().filter(|half| path.width % 2 == 0 && *half > 0);
            match (half, extension(path.start).zip(extension(path.end))) {
                (Some(half), Some(ends)) if vectors.len() > 1 => {
                    self.path(path, half, [ends.0, ends.1], &vectors);
                }
                _ => self.outline(path),
            }
        }
    }

    fn path(&mut self, path: &Path, half: u64, ends: [(u8, Option<i64>); 2], vectors: &[[i64; 2]]) {
        self.begin(record::PATH);
        let new_layer = self.set_layer(path.layer);
        let new_half = set(&mut self.modal.half_width, half);
        let mut scheme = vec![(ends[0].0 << 2) | ends[1].0];
        for by in ends.into_iter().filter_map(|(_, by)| by) {
            encode::signed(by, &mut scheme);
        }
        let new_ends = set_bytes(&mut self.modal.extensions, &scheme);
        let mut list = Vec::new();
        point_list::write_path(vectors, &mut list);
        let new_list = set_bytes(&mut self.modal.path, &list);
        let at = path.points[0];
        let moved = moved(&mut self.modal.geometry, at);
        let flags = geometry_flags(new_layer, moved, None);
        let more = (u8::from(new_ends) << 7) | (u8::from(new_half) << 6) | (u8::from(new_list) << 5);
        self.out.bytes.push(flags | more);
        self.layer(path.layer, new_layer);
        if new_half {
            encode::unsigned(half, &mut self.out.bytes);
        }
        if new_ends {
            self.out.bytes.extend_from_slice(&scheme);
        }
        if new_list {
            self.out.bytes.extend_from_slice(&list);
        }
        self.position(at, moved);
        self.properties(&path.properties);
    }

    /// Writes the polygon of a path that the format cannot express.
    fn outline(&mut self, path: &Path) {
        let outlines = super::outlines(path);
        if outlines.is_empty() {
            self.out.left_out += 1;
            return;
        }
        self.out.paths_outlined += 1;
        for corners in outlines {
            self.polygon(path.layer, &vectors(&corners), corners[0], None);
            self.properties(&path.properties);
        }
    }

    fn texts(&mut self, texts: &'a [Text]) {
        type Key<'a> = (Layer, u64, Option<String>, &'a Properties);
        let mut groups: IndexMap<Key<'_>, Vec<Corner>> = IndexMap::new();
        for text in texts {
            let string = self.tables.texts.number(&label::shown(text));
            let description = label::describe(text);
            self.out.labels_simplified += u64::from(description.is_some());
            let key = (text.layer, string, description, &text.properties);
            if self.options.merge_repeats {
                groups.entry(key).or_default().push(text.origin);
            } else {
                self.text(key.0, key.1, text.origin, None);
                self.text_properties(key.2.as_deref(), key.3);
            }
        }
        for ((layer, string, description, properties), positions) in groups {
            let merged = positions.len() as u64;
            let mut records = 0;
            repeats::each(positions, |at, repetition| {
                records += 1;
                self.text(layer, string, at, repetition);
                self.text_properties(description.as_deref(), properties);
            });
            self.out.repeats_merged += merged - records;
        }
    }

    fn text(&mut self, layer: Layer, string: u64, at: Corner, repetition: Option<&Repetition>) {
        self.begin(record::TEXT);
        let new_string = set(&mut self.modal.text_string, string);
        let new_layer = set(&mut self.modal.textlayer, layer.number);
        let new_type = set(&mut self.modal.texttype, layer.datatype);
        let moved = moved(&mut self.modal.text, at);
        let mut flags = geometry_flags([new_layer, new_type], moved, repetition);
        if new_string {
            flags |= 0b0110_0000;
        }
        self.out.bytes.push(flags);
        if new_string {
            encode::unsigned(string, &mut self.out.bytes);
        }
        self.layer(layer, [new_layer, new_type]);
        self.position(at, moved);
        self.repetition(repetition);
    }

    fn text_properties(&mut self, description: Option<&str>, properties: &Properties) {
        self.properties(properties);
        if let Some(description) = description {
            let mut values = Vec::new();
            string_value(self.tables, description, &mut values);
            self.property(self.tables.property_names.number(label::NAME), false, 1, &values);
        }
    }

    fn properties(&mut self, properties: &Properties) {
        for (attribute, text) in properties {
            let mut values = vec![8];
            encode::unsigned(u64::from(*attribute), &mut values);
            string_value(self.tables, text, &mut values);
            self.property(self.tables.property_names.number(standard::GDS_PROPERTY), true, 2, &values);
        }
    }

    fn property(&mut self, name: u64, standard: bool, count: u8, values: &[u8]) {
        let new_name = set(&mut self.modal.property, (name, standard));
        let new_values = set_bytes(&mut self.modal.values, values);
        let out = &mut self.out.bytes;
        if !new_name && !new_values {
            return encode::unsigned(record::PROPERTY_REPEATED, out);
        }
        encode::unsigned(record::PROPERTY, out);
        let mut flags = u8::from(standard);
        flags |= if new_name { 0b0110 } else { 0 };
        flags |= if new_values { count << 4 } else { 0b1000 };
        out.push(flags);
        if new_name {
            encode::unsigned(name, out);
        }
        if new_values {
            out.extend_from_slice(values);
        }
    }

    fn set_layer(&mut self, layer: Layer) -> [bool; 2] {
        [set(&mut self.modal.layer, layer.number), set(&mut self.modal.datatype, layer.datatype)]
    }

    fn layer(&mut self, layer: Layer, new: [bool; 2]) {
        if new[0] {
            encode::unsigned(u64::from(layer.number), &mut self.out.bytes);
        }
        if new[1] {
            encode::unsigned(u64::from(layer.datatype), &mut self.out.bytes);
        }
    }

    fn position(&mut self, at: Corner, moved: [bool; 2]) {
        for (at, moved) in at.into_iter().zip(moved) {
            if moved {
                encode::signed(i64::from(at), &mut self.out.bytes);
            }
        }
    }

    fn repetition(&mut self, repetition: Option<&Repetition>) {
        let Some(repetition) = repetition else { return };
        let mut bytes = std::mem::take(&mut self.scratch);
        bytes.clear();
        repetition.write(&mut bytes);
        if set_bytes(&mut self.modal.repetition, &bytes) {
            self.out.bytes.extend_from_slice(&bytes);
        } else {
            self.out.bytes.push(0);
        }
        self.scratch = bytes;
    }
}

/// Flags that all geometries and texts share: position, repetition, datatype, layer.
fn geometry_flags([layer, datatype]: [bool; 2], moved: [bool; 2], repetition: Option<&Repetition>) -> u8 {
    (u8::from(moved[0]) << 4)
        | (u8::from(moved[1]) << 3)
        | (u8::from(repetition.is_some()) << 2)
        | (u8::from(datatype) << 1)
        | u8::from(layer)
}

/// Sets a modal position. Returns which coordinates have changed.
fn moved(last: &mut Corner, at: Corner) -> [bool; 2] {
    let moved = [last[0] != at[0], last[1] != at[1]];
    *last = at;
    moved
}

/// A string value by number: an a-string if it may be one, else bytes.
fn string_value(tables: &Tables<'_>, text: &str, out: &mut Vec<u8>) {
    out.push(if label::is_ascii(text) { 13 } else { 14 });
    encode::unsigned(tables.property_strings.number(text), out);
}

/// Corners from the first one, without those that repeat the one before.
fn vectors(corners: &[Corner]) -> Vec<[i64; 2]> {
    let Some(first) = corners.first() else { return Vec::new() };
    let vector = |corner: &Corner| [0, 1].map(|axis| i64::from(corner[axis]) - i64::from(first[axis]));
    let mut vectors: Vec<[i64; 2]> = corners.iter().map(vector).collect();
    vectors.dedup();
    vectors
}

/// The extension scheme of an end, with its length; `None` if the format does not have it.
fn extension(end: PathEnd) -> Option<(u8, Option<i64>)> {
    match end {
        PathEnd::Flush => Some((1, None)),
        PathEnd::Square => Some((2, None)),
        PathEnd::Extended(by) => Some((3, Some(by))),
        PathEnd::Round => None,
    }
}
