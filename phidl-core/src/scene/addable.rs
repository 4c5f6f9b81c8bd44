//! [`Addable`]: what can be added to an open cell.

use super::builder::check_label;
use super::{
    Device, DeviceBuilder, Element, Group, Key, Label, LabelKey, Polygon, PolygonKey, Reference, ReferenceKey,
};

/// What [`DeviceBuilder::add`] takes: references, devices, polygons, labels, groups, and lists of them.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be added to a cell",
    label = "not an element of a cell",
    note = "references, devices, polygons, labels, groups and lists of them can be added",
    note = "if this is a `Result`, add `?` to take the value out of it; if it is an open cell, finish it with `.build()?`"
)]
pub trait Addable {
    /// The key of the added element.
    type Key;

    /// Adds the element at the end of a cell.
    fn add_to(self, cell: &mut DeviceBuilder) -> Self::Key;
}

impl Addable for Reference {
    type Key = ReferenceKey;

    fn add_to(self, cell: &mut DeviceBuilder) -> ReferenceKey {
        let checked = self.check(&cell.cell.name);
        cell.defer_result(checked);
        let key = cell.keys.next_reference(&cell.cell);
        cell.cell.references.push(self);
        key
    }
}

impl Addable for Device {
    type Key = ReferenceKey;

    fn add_to(self, cell: &mut DeviceBuilder) -> ReferenceKey {
        Reference::from(self).add_to(cell)
    }
}

impl Addable for &Device {
    type Key = ReferenceKey;

    fn add_to(self, cell: &mut DeviceBuilder) -> ReferenceKey {
        Reference::from(self).add_to(cell)
    }
}

impl Addable for Polygon {
    type Key = PolygonKey;

    /// The key of a refused polygon finds nothing.
    fn add_to(self, cell: &mut DeviceBuilder) -> PolygonKey {
        let first = cell.cell.polygons.len();
        let added = match self.deferred {
            Some(error) => Err(error.into_error(&cell.cell.name, "the polygon")),
            None => cell.add_polygon(self.points, self.layers),
        };
        match added {
            Ok(key) => {
                for copy in first..cell.cell.polygons.len() {
                    cell.cell.polygons.set_properties(copy, self.properties.clone());
                }
                key
            }
            Err(error) => {
                cell.defer_error(error);
                cell.keys.no_polygon()
            }
        }
    }
}

impl Addable for Label {
    type Key = LabelKey;

    fn add_to(self, cell: &mut DeviceBuilder) -> LabelKey {
        let checked = check_label(&self, &cell.cell.name);
        cell.defer_result(checked);
        let key = cell.keys.next_label(&cell.cell);
        cell.cell.labels.push(self);
        key
    }
}

impl Addable for Element {
    type Key = Vec<Key>;

    /// One key, or those of all members of a group.
    fn add_to(self, cell: &mut DeviceBuilder) -> Vec<Key> {
        match self {
            Self::Reference(reference) => vec![reference.add_to(cell).into()],
            Self::Polygon(polygon) => vec![polygon.add_to(cell).into()],
            Self::Label(label) => vec![label.add_to(cell).into()],
            Self::Group(group) => group.add_to(cell),
        }
    }
}

impl Addable for Group {
    type Key = Vec<Key>;

    fn add_to(self, cell: &mut DeviceBuilder) -> Vec<Key> {
        if let Some(error) = self.deferred() {
            cell.defer_error(error.into_error(&cell.cell.name, "the group"));
        }
        self.into_iter().flat_map(|member| member.add_to(cell)).collect()
    }
}

impl<A: Addable> Addable for Vec<A> {
    type Key = Vec<A::Key>;

    fn add_to(self, cell: &mut DeviceBuilder) -> Vec<A::Key> {
        self.into_iter().map(|element| element.add_to(cell)).collect()
    }
}

impl<A: Addable, const N: usize> Addable for [A; N] {
    type Key = [A::Key; N];

    fn add_to(self, cell: &mut DeviceBuilder) -> [A::Key; N] {
        self.map(|element| element.add_to(cell))
    }
}
