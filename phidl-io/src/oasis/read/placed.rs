//! Placements and texts.

use phidl_core::layer::Layer;
use phidl_core::num::angle;

use super::super::cursor::{Cursor, Fault, Position, Result};
use super::super::repetition::Repetition;
use super::elements::{Flags, Target, corner, moved};
use super::file::Parser;
use super::modal;
use super::names::{self, Name};
use crate::model::{Lattice, Placement, ProblemKind, Text};

impl Parser<'_> {
    pub(super) fn placement(&mut self, any_angle: bool, cursor: &mut Cursor<'_>, start: Position) -> Result<Target> {
        let flags = Flags::read(cursor)?;
        if flags.has(7) {
            self.modal.placement_cell = Some(Name::read(cursor, flags.has(6))?);
        }
        let name = modal::needed(&self.modal.placement_cell, "placement cell", cursor)?;
        self.tables.cells.run.by_text |= matches!(name, Name::Text(_));
        let (mut magnification, mut rotation) = (1.0, 0.0);
        if any_angle {
            if flags.has(2) {
                magnification = cursor.real()?;
                if magnification <= 0.0 {
                    let problem = format!("a placement has the magnification {magnification}, but it must be positive");
                    return Err(Fault::new(start, problem));
                }
            }
            if flags.has(1) {
                rotation = angle::normalized(cursor.real()?);
            }
        } else {
            rotation = 90.0 * f64::from(flags.pair(1));
        }
        let modal = &mut self.modal;
        let present = [flags.has(5), flags.has(4)];
        let at = modal::position(&mut modal.placement, modal.relative, present, cursor)?;
        let repetition = self.repetition(flags.has(3), cursor)?;
        let child = self.cell_id(&name);
        let placement = Placement {
            x_reflection: flags.has(0),
            magnification,
            rotation,
            offset: start.file,
            ..Placement::new(child)
        };
        let first = self.open_cell().placements.len();
        self.place(placement, at, repetition, start)?;
        Ok(Target::Placements(first..self.open_cell().placements.len()))
    }

    /// Adds a placement, an array, or the placements of a list.
    fn place(
        &mut self,
        placement: Placement,
        at: [i64; 2],
        repetition: Option<Repetition>,
        start: Position,
    ) -> Result<()> {
        match repetition {
            None => {
                let origin = corner(at, start)?;
                self.open_cell().placements.push(Placement { origin, ..placement });
            }
            Some(Repetition::Lattice { columns, rows, column_step, row_step }) => {
                let lattice = lattice([columns, rows], [column_step, row_step], at, start)?;
                let origin = corner(at, start)?;
                let lattice = Some(Box::new(lattice));
                self.open_cell().placements.push(Placement { origin, lattice, ..placement });
            }
            Some(list) => {
                self.spend(list.count(), 1, start)?;
                let placements = &mut self.open_cell().placements;
                list.each(|vector| {
                    let origin = corner(moved(at, vector, start)?, start)?;
                    placements.push(Placement { origin, ..placement.clone() });
                    Ok(())
                })?;
            }
        }
        Ok(())
    }

    pub(super) fn text(&mut self, cursor: &mut Cursor<'_>, start: Position) -> Result<Target> {
        let flags = Flags::read(cursor)?;
        if flags.has(6) {
            self.modal.text_string = Some(Name::read(cursor, flags.has(5))?);
        }
        let name = modal::needed(&self.modal.text_string, "text string", cursor)?;
        self.tables.texts.run.by_text |= matches!(name, Name::Text(_));
        let modal = &mut self.modal;
        let layer = modal::update(&mut modal.textlayer, flags.has(0), "textlayer", cursor, modal::layer_number)?;
        let texttype = modal::update(&mut modal.texttype, flags.has(1), "texttype", cursor, modal::layer_number)?;
        let present = [flags.has(4), flags.has(3)];
        let at = modal::position(&mut modal.text, modal.relative, present, cursor)?;
        let repetition = self.repetition(flags.has(2), cursor)?;
        let string = match &name {
            Name::Text(bytes) => {
                let (string, latin1) = names::text(bytes);
                if latin1 {
                    self.problem(start, ProblemKind::Latin1);
                }
                self.spend(1, string.len() / 64, start)?;
                string
            }
            Name::Number(_) => String::new(),
        };
        let copies = repetition.as_ref().map_or(0, Repetition::count);
        self.spend(copies, 1 + string.len() / 64, start)?;
        let text = text(Layer::new(layer, texttype), string, start.file);
        let texts = &mut self.open_cell().texts;
        let first = texts.len();
        let mut add = |at| {
            texts.push(Text { origin: corner(at, start)?, ..text.clone() });
            Ok(())
        };
        match repetition {
            None => add(at)?,
            Some(repetition) => repetition.each(|vector| add(moved(at, vector, start)?))?,
        }
        let range = first..texts.len();
        if let Name::Number(_) = name {
            let cell = self.layout.cells.len() - 1;
            self.pending.strings.push((cell, range.clone(), name, start));
        }
        Ok(Target::Texts(range))
    }
}

/// A lattice whose elements are all in range.
fn lattice([columns, rows]: [u64; 2], steps: [[i64; 2]; 2], at: [i64; 2], start: Position) -> Result<Lattice> {
    let too_many =
        || Fault::new(start, format!("an array of {columns} by {rows} cells has more than 2³² in one direction"));
    let (columns, rows) = u32::try_from(columns).ok().zip(u32::try_from(rows).ok()).ok_or_else(too_many)?;
    let extent = |step: [i64; 2], count: u32| -> Option<[i64; 2]> {
        Some([step[0].checked_mul(i64::from(count))?, step[1].checked_mul(i64::from(count))?])
    };
    let [column_extent, row_extent] = [extent(steps[0], columns), extent(steps[1], rows)];
    for (across, up) in [(columns - 1, 0), (0, rows - 1), (columns - 1, rows - 1)] {
        let (across, up) = (extent(steps[0], across), extent(steps[1], up));
        let last = moved(moved(at, across, start)?, up, start)?;
        corner(last, start)?;
    }
    let extents = column_extent.zip(row_extent);
    let (column_extent, row_extent) = extents.ok_or_else(|| super::elements::out_of_range(start))?;
    Ok(Lattice { columns, rows, column_extent, row_extent })
}

/// A text as OASIS states it: centered, level, of the usual size.
fn text(layer: Layer, string: String, offset: usize) -> Text {
    Text {
        layer,
        string,
        origin: [0, 0],
        x_reflection: false,
        magnification: None,
        rotation: 0.0,
        anchor: Some(phidl_core::scene::Anchor::Center),
        font: 0,
        path_type: None,
        width: None,
        properties: Default::default(),
        offset,
    }
}
