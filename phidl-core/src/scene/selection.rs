//! [`Selection`]: some elements of an open cell, handled as one.

use super::{DeviceBuilder, Key, LabelKey, PolygonKey, ReferenceKey};
use crate::error::{Error, Result};
use crate::geom::{Point, Rect, Transform};
use crate::place::{Align, Bounded, DeferredError, Reason, Transformable};

/// Keys of elements: one key, or a list of keys.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a key of an open cell, nor a list of keys",
    note = "`add` returns the key of the element that it adds"
)]
pub trait Keys {
    /// The keys, in order.
    fn into_keys(self) -> Vec<Key>;
}

impl<I: IntoIterator<Item: Into<Key>>> Keys for I {
    fn into_keys(self) -> Vec<Key> {
        self.into_iter().map(Into::into).collect()
    }
}

macro_rules! single_keys {
    ($($key:ty),*) => {$(
        impl Keys for $key {
            fn into_keys(self) -> Vec<Key> {
                vec![self.into()]
            }
        }
    )*};
}

single_keys!(Key, ReferenceKey, PolygonKey, LabelKey);

/// Some elements of an open cell, handled as one: they move together, or are aligned and distributed.
///
/// ```
/// # use phidl_core::prelude::*;
/// # let mut d = Device::builder("dot");
/// # d.add_polygon([(0, 0), (1, 0), (0, 1)], 1)?;
/// # let dot = d.build()?;
/// let mut d = Device::builder("row");
/// let keys = [d.add(&dot), d.add(&dot), d.add(&dot)];
/// d.group(keys).distribute(Direction::X, 4).rotate(90);
/// assert_eq!(d[keys[2]].transform().origin, Point::new(0.0, 10.0));
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// An invalid call is a deferred error of the open cell.
#[derive(Debug)]
pub struct Selection<'a> {
    cell: &'a mut DeviceBuilder,
    keys: Vec<Key>,
}

impl DeviceBuilder {
    /// Some elements of this cell, handled as one. A key given twice counts once; a key that finds nothing or belongs to
    /// another cell is a deferred error.
    pub fn group(&mut self, keys: impl Keys) -> Selection<'_> {
        let mut seen = std::collections::HashSet::new();
        let mut selection = Selection { cell: self, keys: Vec::new() };
        for key in keys.into_keys() {
            match selection.bbox_of(key) {
                Ok(_) if seen.insert(key) => selection.keys.push(key),
                Ok(_) => {}
                Err(error) => selection.cell.defer_error(error),
            }
        }
        selection
    }

    /// One element of this cell, with all placement methods: `d.select(key).rotate(45)`.
    pub fn select(&mut self, key: impl Into<Key>) -> Selection<'_> {
        self.group([key.into()])
    }

    /// All polygons and references of this cell, polygons first.
    pub fn select_all(&mut self) -> Selection<'_> {
        let mut keys: Vec<Key> = self.polygon_keys().map(Key::from).collect();
        keys.extend(self.reference_keys().map(Key::from));
        Selection { cell: self, keys }
    }
}

impl Selection<'_> {
    fn bbox_of(&self, key: Key) -> Result<Option<Rect>> {
        Ok(match key {
            Key::Reference(key) => self.cell.reference(key)?.bbox(),
            Key::Label(key) => self.cell.label(key)?.bbox(),
            Key::Polygon(key) => {
                let indices = self.cell.polygon_indices(key)?;
                let view = indices.first().map(|index| self.cell.cell.polygons.get(*index));
                view.and_then(|view| Rect::around(view.points.iter().copied()))
            }
        })
    }

    fn transform_one(&mut self, key: Key, by: &Transform) {
        match key {
            Key::Reference(key) => {
                if let Ok(reference) = self.cell.reference_mut(key) {
                    reference.transform_mut(by);
                }
            }
            Key::Label(key) => {
                if let Ok(index) = self.cell.label_index(key) {
                    self.cell.cell.labels[index].transform_mut(by);
                }
            }
            Key::Polygon(key) => {
                let matrix = by.matrix();
                for index in self.cell.polygon_indices(key).unwrap_or_default() {
                    self.cell.cell.polygons.points_mut(index).iter_mut().for_each(|p| *p = matrix.apply(*p));
                }
            }
        }
    }

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

    fn defer_for(&mut self, error: DeferredError, what: &str) {
        let error = error.into_error(&self.cell.cell.name, what);
        self.cell.defer_error(error);
    }
}

impl Bounded for Selection<'_> {
    fn bbox(&self) -> Option<Rect> {
        Rect::union_all(self.member_boxes())
    }
}

impl Transformable for Selection<'_> {
    fn transform_mut(&mut self, by: &Transform) {
        for i in 0..self.keys.len() {
            self.transform_one(self.keys[i], by);
        }
    }

    fn defer(&mut self, error: DeferredError) {
        let what = match self.keys[..] {
            [key] => self.describe(key),
            _ => "the selection".to_owned(),
        };
        self.defer_for(error, &what);
    }
}

impl Align for Selection<'_> {
    fn member_boxes(&self) -> Vec<Option<Rect>> {
        self.keys.iter().map(|key| self.bbox_of(*key).ok().flatten()).collect()
    }

    fn move_member(&mut self, index: usize, by: Point) {
        self.transform_one(self.keys[index], &Transform::translation(by));
    }

    fn defer_align_error(&mut self, error: DeferredError) {
        let DeferredError { method, reason: Reason::EmptyMember(index) } = error else { return self.defer(error) };
        let error = Error::EmptyGeometry {
            device: self.cell.cell.name.as_str().into(),
            method,
            what: self.describe(self.keys[index]).into(),
        };
        self.cell.defer_error(error);
    }
}
