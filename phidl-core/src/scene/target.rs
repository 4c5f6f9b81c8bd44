//! [`Target`]: what the placement methods of an open cell act on.

use std::ops::RangeFull;

use super::{DeviceBuilder, Key, LabelKey, PolygonKey, ReferenceKey};
use crate::error::Result;
use crate::port::Port;

/// Elements of an open cell: a key, an alias, a list or tuple of these, or `..` for the whole cell with its ports.
///
/// In `align` and `distribute`, each entry of a list is one member, also an entry that is a list itself:
/// `d.distribute([[pad, name], [pad2, name2]], Direction::X, 5)` keeps each name at its pad.
#[diagnostic::on_unimplemented(
    message = "`{Self}` names no elements of an open cell",
    label = "not a key, an alias, a list of them, or `..`",
    note = "methods of an open cell take what they act on first: `d.rotate(key, 45)`, `d.rotate(\"alias\", 45)`, \
            `d.rotate([a, b], 45)`, or `d.rotate(.., 45)` for the whole cell"
)]
pub trait Target: Sized {
    /// The keys of the elements.
    ///
    /// # Errors
    /// An alias that does not exist.
    fn keys(self, cell: &DeviceBuilder) -> Result<Vec<Key>>;

    /// The keys of each member.
    ///
    /// # Errors
    /// As for [`Target::keys`].
    fn members(self, cell: &DeviceBuilder) -> Result<Vec<Vec<Key>>> {
        Ok(vec![self.keys(cell)?])
    }

    /// Whether the whole cell is meant, with its ports.
    fn is_whole_cell(&self) -> bool {
        false
    }
}

macro_rules! single_targets {
    ($($key:ty),*) => {$(
        impl Target for $key {
            fn keys(self, _: &DeviceBuilder) -> Result<Vec<Key>> {
                Ok(vec![self.into()])
            }
        }
    )*};
}

single_targets!(Key, &Key, ReferenceKey, PolygonKey, LabelKey);

impl Target for &str {
    fn keys(self, cell: &DeviceBuilder) -> Result<Vec<Key>> {
        Ok(vec![cell.key(self)?])
    }
}

impl Target for RangeFull {
    fn keys(self, cell: &DeviceBuilder) -> Result<Vec<Key>> {
        let labels = cell.label_keys().map(Key::from);
        Ok(self.members(cell)?.into_iter().flatten().chain(labels).collect())
    }

    /// Polygons and references, as in PHIDL: labels are not aligned.
    fn members(self, cell: &DeviceBuilder) -> Result<Vec<Vec<Key>>> {
        let polygons = cell.polygon_keys().map(Key::from);
        Ok(polygons.chain(cell.reference_keys().map(Key::from)).map(|key| vec![key]).collect())
    }

    fn is_whole_cell(&self) -> bool {
        true
    }
}

fn members_of<T: Target>(targets: impl IntoIterator<Item = T>, cell: &DeviceBuilder) -> Result<Vec<Vec<Key>>> {
    targets.into_iter().map(|target| target.keys(cell)).collect()
}

macro_rules! list_targets {
    ($([$($generics:tt)*] $list:ty, $iter:ident;)*) => {$(
        impl<$($generics)*> Target for $list {
            fn keys(self, cell: &DeviceBuilder) -> Result<Vec<Key>> {
                Ok(self.members(cell)?.concat())
            }

            fn members(self, cell: &DeviceBuilder) -> Result<Vec<Vec<Key>>> {
                members_of(self.$iter().cloned(), cell)
            }
        }
    )*};
}

list_targets! {
    [T: Target + Clone] Vec<T>, iter;
    [T: Target + Clone] &Vec<T>, iter;
    [T: Target + Clone] &[T], iter;
    [T: Target + Clone, const N: usize] [T; N], iter;
    [T: Target + Clone, const N: usize] &[T; N], iter;
}

macro_rules! tuple_targets {
    ($(($($member:ident),*))*) => {$(
        impl<$($member: Target),*> Target for ($($member,)*) {
            fn keys(self, cell: &DeviceBuilder) -> Result<Vec<Key>> {
                Ok(self.members(cell)?.concat())
            }

            #[expect(non_snake_case, reason = "the members are named by their types")]
            fn members(self, cell: &DeviceBuilder) -> Result<Vec<Vec<Key>>> {
                let ($($member,)*) = self;
                Ok(vec![$($member.keys(cell)?),*])
            }
        }
    )*};
}

tuple_targets!((A, B)(A, B, C)(A, B, C, D)(A, B, C, D, E)(A, B, C, D, E, F));

/// A port that something is connected to: a port, `(key, "port")`, `("alias", "port")`, or the name of a port of the open
/// cell.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a port",
    note = "a port, `(key, \"port\")`, `(\"alias\", \"port\")` and the name of a port of the open cell are taken",
    note = "if this is a `Result`, add `?` to take the port out of it"
)]
pub trait PortTarget {
    /// The port, in the coordinates of the open cell.
    ///
    /// # Errors
    /// A key, alias or port that does not exist.
    fn port(self, cell: &DeviceBuilder) -> Result<Port>;
}

impl PortTarget for Port {
    fn port(self, _: &DeviceBuilder) -> Result<Port> {
        Ok(self)
    }
}

impl PortTarget for &Port {
    fn port(self, _: &DeviceBuilder) -> Result<Port> {
        Ok(self.clone())
    }
}

impl PortTarget for &str {
    fn port(self, cell: &DeviceBuilder) -> Result<Port> {
        cell.port(self).cloned()
    }
}

impl PortTarget for (ReferenceKey, &str) {
    fn port(self, cell: &DeviceBuilder) -> Result<Port> {
        cell.reference(self.0)?.port(self.1)
    }
}

impl PortTarget for (&str, &str) {
    fn port(self, cell: &DeviceBuilder) -> Result<Port> {
        cell.get(self.0)?.port(self.1)
    }
}

/// One reference of an open cell: its key or its alias.
pub trait ReferenceTarget {
    /// The key of the reference.
    ///
    /// # Errors
    /// An alias that does not exist.
    fn reference_key(self, cell: &DeviceBuilder) -> Result<ReferenceKey>;
}

impl ReferenceTarget for ReferenceKey {
    fn reference_key(self, _: &DeviceBuilder) -> Result<ReferenceKey> {
        Ok(self)
    }
}

impl ReferenceTarget for &str {
    fn reference_key(self, cell: &DeviceBuilder) -> Result<ReferenceKey> {
        cell.alias_key(self)
    }
}
