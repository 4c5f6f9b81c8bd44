//! [`Group`]: several elements handled as one.

use super::{Device, Label, Polygon, Reference};
use crate::geom::{Point, Rect, Transform};
use crate::place::{Align, Bounded, DeferredError, Transformable};

/// An element of a cell.
#[derive(Debug, Clone, PartialEq)]
#[expect(missing_docs, reason = "the variants hold what they are called")]
pub enum Element {
    Reference(Reference),
    Polygon(Polygon),
    Label(Label),
    Group(Group),
}

/// Several elements handled as one, in their order. `a + b` makes a group. A group in a group is one member: it is moved,
/// aligned and distributed as a whole. (`group + element` adds to the group on the left, as in PHIDL.)
///
/// For elements that are in an open cell already, see [`DeviceBuilder::group`](super::DeviceBuilder::group).
///
/// ```
/// # use phidl_core::prelude::*;
/// let square = Polygon::new([(0, 0), (2, 0), (2, 2), (0, 2)], 1);
/// let mut pair = square.clone() + square.moved_by((10, 0));
/// pair.rotate(90).set_xmin(0);
/// assert_eq!(pair.bbox(), Some(Rect::new((0, 0), (2, 12))));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Group {
    members: Vec<Element>,
    deferred: Option<Box<DeferredError>>,
}

impl Group {
    /// A group without members.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds an element, which may be a group, at the end.
    pub fn add(&mut self, member: impl Into<Element>) -> &mut Self {
        self.members.push(member.into());
        self
    }

    /// The members, in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &Element> {
        self.members.iter()
    }

    /// How many members there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.members.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    pub(crate) fn deferred(&self) -> Option<DeferredError> {
        self.deferred.as_deref().copied()
    }
}

impl std::ops::Index<usize> for Group {
    type Output = Element;

    fn index(&self, index: usize) -> &Element {
        &self.members[index]
    }
}

impl std::ops::IndexMut<usize> for Group {
    fn index_mut(&mut self, index: usize) -> &mut Element {
        &mut self.members[index]
    }
}

impl IntoIterator for Group {
    type Item = Element;
    type IntoIter = std::vec::IntoIter<Element>;

    fn into_iter(self) -> Self::IntoIter {
        self.members.into_iter()
    }
}

impl FromIterator<Element> for Group {
    fn from_iter<I: IntoIterator<Item = Element>>(members: I) -> Self {
        Self { members: members.into_iter().collect(), deferred: None }
    }
}

impl<E: Into<Element>> std::ops::Add<E> for Group {
    type Output = Self;
    fn add(mut self, other: E) -> Self {
        self += other;
        self
    }
}

impl<E: Into<Element>> std::ops::AddAssign<E> for Group {
    fn add_assign(&mut self, other: E) {
        Group::add(self, other);
    }
}

impl Extend<Element> for Group {
    fn extend<I: IntoIterator<Item = Element>>(&mut self, members: I) {
        self.members.extend(members);
    }
}

impl Bounded for Group {
    fn bbox(&self) -> Option<Rect> {
        Rect::union_all(self.members.iter().map(Bounded::bbox))
    }
}

impl Transformable for Group {
    fn transform_mut(&mut self, by: &Transform) {
        self.members.iter_mut().for_each(|member| member.transform_mut(by));
    }

    fn defer(&mut self, error: DeferredError) {
        self.deferred.get_or_insert(Box::new(error));
    }
}

impl Align for Group {
    fn member_boxes(&self) -> Vec<Option<Rect>> {
        self.members.iter().map(Bounded::bbox).collect()
    }

    fn move_member(&mut self, index: usize, by: Point) {
        self.members[index].transform_mut(&Transform::translation(by));
    }

    fn defer_align_error(&mut self, error: DeferredError) {
        self.defer(error);
    }
}

impl Bounded for Element {
    fn bbox(&self) -> Option<Rect> {
        match self {
            Self::Reference(reference) => reference.bbox(),
            Self::Polygon(polygon) => polygon.bbox(),
            Self::Label(label) => label.bbox(),
            Self::Group(group) => group.bbox(),
        }
    }
}

impl Transformable for Element {
    fn transform_mut(&mut self, by: &Transform) {
        match self {
            Self::Reference(reference) => reference.transform_mut(by),
            Self::Polygon(polygon) => polygon.transform_mut(by),
            Self::Label(label) => label.transform_mut(by),
            Self::Group(group) => group.transform_mut(by),
        }
    }

    fn defer(&mut self, error: DeferredError) {
        match self {
            Self::Reference(reference) => reference.defer(error),
            Self::Polygon(polygon) => polygon.defer(error),
            Self::Label(label) => label.defer(error),
            Self::Group(group) => group.defer(error),
        }
    }
}

impl From<Reference> for Element {
    fn from(reference: Reference) -> Self {
        Self::Reference(reference)
    }
}

impl From<Device> for Element {
    fn from(device: Device) -> Self {
        Self::Reference(device.place())
    }
}

impl From<&Device> for Element {
    fn from(device: &Device) -> Self {
        Self::Reference(device.place())
    }
}

impl From<Polygon> for Element {
    fn from(polygon: Polygon) -> Self {
        Self::Polygon(polygon)
    }
}

impl From<Label> for Element {
    fn from(label: Label) -> Self {
        Self::Label(label)
    }
}

impl From<Group> for Element {
    fn from(group: Group) -> Self {
        Self::Group(group)
    }
}

impl From<Element> for Group {
    fn from(member: Element) -> Self {
        Self { members: vec![member], deferred: None }
    }
}

macro_rules! group_of_one {
    ($($member:ty),*) => {$(
        impl From<$member> for Group {
            fn from(member: $member) -> Self {
                Element::from(member).into()
            }
        }
    )*};
}

group_of_one!(Reference, Device, &Device, Polygon, Label);
