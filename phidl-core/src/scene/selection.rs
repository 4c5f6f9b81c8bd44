//! [`Selection`]: some elements of an open cell, handled as one.

use std::collections::HashSet;

use super::{DeviceBuilder, Key, Target};
use crate::error::{Error, Result};
use crate::geom::{Point, Rect, Transform};
use crate::place::{Align, Bounded, DeferredError, Reason, Transformable};

/// Some elements of an open cell, handled as one: they move together, or are aligned and distributed.
///
/// ```
/// # use phidl_core::prelude::*;
/// # let mut d = Device::builder("dot");
/// # d.add_polygon([(0, 0), (1, 0), (0, 1)], 1)?;
/// # let dot = d.build()?;
/// let mut d = Device::builder("row");
/// let keys = [d.add(&dot), d.add(&dot), d.add(&dot)];
/// d.group(keys).distribute(Direction::X, 4).rotate(90); // or d.distribute(keys, Direction::X, 4).rotate(keys, 90)
/// assert_eq!(d[keys[2]].transform().origin, Point::new(0.0, 10.0));
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// An invalid call is a deferred error of the open cell.
#[derive(Debug)]
pub struct Selection<'a> {
    cell: &'a mut DeviceBuilder,
    members: Vec<Vec<Key>>,
    /// Whether ports move as well.
    is_whole_cell: bool,
}

impl DeviceBuilder {
    /// Some elements of this cell, handled as one. A key given twice counts once. A key or alias that finds nothing or
    /// belongs to another cell is a deferred error, and nothing is selected.
    pub fn group(&mut self, target: impl Target) -> Selection<'_> {
        let is_whole_cell = target.is_whole_cell();
        match target.members(self).and_then(|members| self.checked(members)) {
            Ok(members) => Selection { cell: self, members, is_whole_cell },
            Err(error) => {
                self.defer_error(error);
                Selection { cell: self, members: Vec::new(), is_whole_cell: false }
            }
        }
    }

    /// One element of this cell, with all placement methods: `d.select(key).rotate(45)`.
    pub fn select(&mut self, key: impl Into<Key>) -> Selection<'_> {
        self.group(key.into())
    }

    /// All polygons and references of this cell, polygons first.
    pub fn select_all(&mut self) -> Selection<'_> {
        let members = self.polygon_keys().map(Key::from).chain(self.reference_keys().map(Key::from));
        let members = members.map(|key| vec![key]).collect();
        Selection { cell: self, members, is_whole_cell: false }
    }

    /// Members whose keys all find an element, each key once.
    fn checked(&self, mut members: Vec<Vec<Key>>) -> Result<Vec<Vec<Key>>> {
        let mut seen = HashSet::new();
        for member in &mut members {
            member.iter().try_for_each(|key| self.bbox_of_key(*key).map(drop))?;
            member.retain(|key| seen.insert(*key));
        }
        members.retain(|member| !member.is_empty());
        Ok(members)
    }

    pub(super) fn bbox_of_key(&self, key: Key) -> Result<Option<Rect>> {
        Ok(match key {
            Key::Reference(key) => self.reference(key)?.bbox(),
            Key::Label(key) => self.label(key)?.bbox(),
            Key::Polygon(key) => {
                let indices = self.polygon_indices(key)?;
                let view = indices.first().map(|index| self.cell.polygons.get(*index));
                view.and_then(|view| Rect::around(view.points.iter().copied()))
            }
        })
    }

    fn transform_key(&mut self, key: Key, by: &Transform) {
        match key {
            Key::Reference(key) => {
                if let Ok(reference) = self.reference_mut(key) {
                    reference.transform_mut(by);
                }
            }
            Key::Label(key) => {
                if let Ok(index) = self.label_index(key) {
                    self.cell.labels[index].transform_mut(by);
                }
            }
            Key::Polygon(key) => {
                let matrix = by.matrix();
                for index in self.polygon_indices(key).unwrap_or_default() {
                    self.cell.polygons.points_mut(index).iter_mut().for_each(|p| *p = matrix.apply(*p));
                }
            }
        }
    }
}

impl Selection<'_> {
    /// An element as error texts name it.
    fn describe(&self, key: Key) -> String {
        match key {
            Key::Polygon(_) => "the polygon".to_owned(),
            Key::Label(key) => {
                self.cell.label(key).map_or_else(|_| "the label".to_owned(), |l| format!("the label \"{}\"", l.text))
            }
            Key::Reference(key) => match self.cell.reference(key) {
                Ok(reference) => format!("the reference to \"{}\"", reference.device().name()),
                Err(_) => "the reference".to_owned(),
            },
        }
    }

    /// A member as error texts name it.
    fn describe_member(&self, index: usize) -> String {
        match self.members[index][..] {
            [key] => self.describe(key),
            _ => format!("member {index} of the selection, counted from 0,"),
        }
    }
}

impl Bounded for Selection<'_> {
    fn bbox(&self) -> Option<Rect> {
        if self.is_whole_cell { self.cell.cell.bbox() } else { Rect::union_all(self.member_boxes()) }
    }
}

impl Transformable for Selection<'_> {
    fn transform_mut(&mut self, by: &Transform) {
        if self.is_whole_cell {
            return self.cell.cell.transform_mut(by);
        }
        for i in 0..self.members.len() {
            self.move_through(i, by);
        }
    }

    fn defer(&mut self, error: DeferredError) {
        let what = match &self.members[..] {
            _ if self.is_whole_cell => "the cell".to_owned(),
            [_] => self.describe_member(0),
            // A key that found nothing is the deferred error already.
            [] => return,
            _ => "the selection".to_owned(),
        };
        let device = self.cell.cell.name.as_str();
        let empty = self.cell.cell.references.iter().find(|reference| reference.bbox().is_none());
        let error = match empty {
            Some(empty) if error.reason.is_nan() => Error::invalid(
                device,
                format!(
                    "the argument of {} for {what} is NaN, but it must be finite; the reference to \"{}\" is empty, so its \
                     edges are NaN",
                    error.method,
                    empty.device().name()
                ),
            ),
            _ => error.into_error(device, &what),
        };
        self.cell.defer_error(error);
    }
}

impl Selection<'_> {
    fn move_through(&mut self, member: usize, by: &Transform) {
        for i in 0..self.members[member].len() {
            self.cell.transform_key(self.members[member][i], by);
        }
    }
}

impl Align for Selection<'_> {
    fn member_boxes(&self) -> Vec<Option<Rect>> {
        let of_key = |key: &Key| self.cell.bbox_of_key(*key).ok().flatten();
        self.members.iter().map(|keys| Rect::union_all(keys.iter().map(of_key))).collect()
    }

    fn move_member(&mut self, index: usize, by: Point) {
        self.move_through(index, &Transform::translation(by));
    }

    fn defer_align_error(&mut self, error: DeferredError) {
        let DeferredError { method, reason: Reason::EmptyMember(index) } = error else { return self.defer(error) };
        let (device, what) = (self.cell.cell.name.as_str().into(), self.describe_member(index).into());
        self.cell.defer_error(Error::EmptyGeometry { device, method, what });
    }
}
