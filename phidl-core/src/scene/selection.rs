//! [`Selection`]: some of the things in an open cell, handled as one.

use super::{DeviceBuilder, Key};
use crate::geom::{Point, Rect, Transform};
use crate::place::{Align, Bounded, DeferredError, Transformable};

/// Some things in an open cell, handled as one: they move together, or are aligned and distributed.
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
#[derive(Debug)]
pub struct Selection<'a> {
    cell: &'a mut DeviceBuilder,
    keys: Vec<Key>,
}

impl DeviceBuilder {
    /// Some things in this cell, handled as one. A key that finds nothing comes back as the error of the next fallible
    /// call.
    pub fn group<K: Into<Key>>(&mut self, keys: impl IntoIterator<Item = K>) -> Selection<'_> {
        let mut members = Selection { cell: self, keys: Vec::new() };
        for key in keys {
            let key = key.into();
            match members.bbox_of(key) {
                // A key given twice moves its thing once.
                Ok(_) if members.keys.contains(&key) => {}
                Ok(_) => members.keys.push(key),
                Err(error) => members.cell.keep(error),
            }
        }
        members
    }

    /// One thing in this cell, with all placement methods: `d.select(key).rotate(45)`.
    pub fn select(&mut self, key: impl Into<Key>) -> Selection<'_> {
        self.group([key.into()])
    }

    /// All polygons and references of this cell, polygons first.
    pub fn select_all(&mut self) -> Selection<'_> {
        use super::{PolygonKey, ReferenceKey};
        let count = self.removed_polygons.next_number(self.cell.outlines.len());
        let polygons = (0..count).filter(|n| self.removed_polygons.place(*n).is_some());
        let mut keys: Vec<Key> = polygons.map(|first| PolygonKey { first, copies: 1 }.into()).collect();
        let count = self.removed_references.next_number(self.cell.references.len());
        let references = (0..count).filter(|n| self.removed_references.place(*n).is_some());
        keys.extend(references.map(|number| Key::from(ReferenceKey(number))));
        Selection { cell: self, keys }
    }
}

impl Selection<'_> {
    fn bbox_of(&self, key: Key) -> crate::Result<Option<Rect>> {
        Ok(match key {
            Key::Reference(key) => self.cell.reference(key)?.bbox(),
            Key::Label(key) => self.cell.label(key)?.bbox(),
            Key::Polygon(key) => {
                let places = self.cell.polygon_places(key)?;
                let view = places.first().map(|place| self.cell.cell.outlines.get(*place));
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
                if let Ok(place) = self.cell.label_place(key) {
                    self.cell.cell.labels[place].transform_mut(by);
                }
            }
            Key::Polygon(key) => {
                let matrix = by.matrix();
                for place in self.cell.polygon_places(key).unwrap_or_default() {
                    self.cell.cell.outlines.points_mut(place).iter_mut().for_each(|p| *p = matrix.apply(*p));
                }
            }
        }
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

    fn refuse(&mut self, fault: DeferredError) {
        self.cell.refuse(fault);
    }
}

impl Align for Selection<'_> {
    fn member_boxes(&self) -> Vec<Option<Rect>> {
        self.keys.iter().map(|key| self.bbox_of(*key).ok().flatten()).collect()
    }

    fn move_member(&mut self, index: usize, by: Point) {
        self.transform_one(self.keys[index], &Transform::translation(by));
    }

    fn refuse_arrangement(&mut self, fault: DeferredError) {
        self.refuse(fault);
    }
}
