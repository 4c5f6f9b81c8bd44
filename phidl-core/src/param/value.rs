//! [`Value`]: what parameters and info records are made of.
//!
//! Core has its own value and not JSON's: it compares floats by their bits, which a cache key needs, and holds whole
//! devices. `serde` carries it into any format; phidl-io chooses JSON.

use std::collections::BTreeMap;
use std::hash::{Hash, Hasher};

use super::unit::Readable;
use crate::geom::{Point, Size};
use crate::layer::{Layer, Layers};
use crate::port::Port;
use crate::scene::Device;

/// A value: a parameter as a record of it, or an entry of a cell's info.
///
/// Two floats are equal if their bits are (`-0.0` counts as `0.0`), so a value can be a key.
#[derive(Debug, Clone)]
#[expect(missing_docs, reason = "the variants hold what they are called")]
pub enum Value {
    Null,
    Bool(bool),
    Int(i64),
    Float(f64),
    Text(String),
    List(Vec<Value>),
    Map(BTreeMap<String, Value>),
    /// A finished cell, by its content.
    Device(Device),
}

impl Value {
    /// The number, if it is one.
    #[must_use]
    pub fn as_f64(&self) -> Option<f64> {
        match self {
            Self::Float(v) => Some(*v),
            Self::Int(v) => Some(*v as f64),
            _ => None,
        }
    }

    /// The text, if it is one.
    #[must_use]
    pub fn as_str(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The list, if it is one.
    #[must_use]
    pub fn as_list(&self) -> Option<&[Value]> {
        match self {
            Self::List(list) => Some(list),
            _ => None,
        }
    }

    /// The value as part of a name: `0.5` is `0p5`, `-3` is `m3`, a list is `1x2`, text keeps its letters and digits.
    /// `None` for null, maps and devices, which have no short form.
    #[must_use]
    pub fn short(&self) -> Option<String> {
        match self {
            Self::Int(_) | Self::Float(_) => Some(self.to_string().replace('-', "m").replace('.', "p")),
            Self::Bool(v) => Some(v.to_string()),
            Self::Text(text) => Some(text.replace(|c: char| !c.is_ascii_alphanumeric(), "_")),
            Self::List(list) => {
                let parts: Option<Vec<String>> = list.iter().map(Self::short).collect();
                Some(parts?.join("x"))
            }
            Self::Null | Self::Map(_) | Self::Device(_) => None,
        }
    }

    /// Whether every number in it is finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Float(v) => v.is_finite(),
            Self::List(list) => list.iter().all(Self::is_finite),
            Self::Map(map) => map.values().all(Self::is_finite),
            _ => true,
        }
    }
}

/// The bits by which floats are compared and hashed: both zeros are one.
pub(crate) fn float_key(v: f64) -> u64 {
    if v == 0.0 { 0 } else { v.to_bits() }
}

impl PartialEq for Value {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Null, Self::Null) => true,
            (Self::Bool(a), Self::Bool(b)) => a == b,
            (Self::Int(a), Self::Int(b)) => a == b,
            (Self::Float(a), Self::Float(b)) => float_key(*a) == float_key(*b),
            (Self::Text(a), Self::Text(b)) => a == b,
            (Self::List(a), Self::List(b)) => a == b,
            (Self::Map(a), Self::Map(b)) => a == b,
            (Self::Device(a), Self::Device(b)) => a == b,
            _ => false,
        }
    }
}

impl Eq for Value {}

impl Hash for Value {
    fn hash<H: Hasher>(&self, state: &mut H) {
        std::mem::discriminant(self).hash(state);
        match self {
            Self::Null => {}
            Self::Bool(v) => v.hash(state),
            Self::Int(v) => v.hash(state),
            Self::Float(v) => float_key(*v).hash(state),
            Self::Text(v) => v.hash(state),
            Self::List(v) => v.hash(state),
            Self::Map(v) => v.hash(state),
            Self::Device(v) => v.content_hash().hash(state),
        }
    }
}

impl std::fmt::Display for Value {
    /// Writes the value as it would be written in a call.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Null => f.write_str("none"),
            Self::Bool(v) => v.fmt(f),
            Self::Int(v) => v.fmt(f),
            Self::Float(v) => Readable(*v).fmt(f),
            Self::Text(v) => write!(f, "{v:?}"),
            Self::List(list) => {
                f.write_str("[")?;
                for (i, v) in list.iter().enumerate() {
                    write!(f, "{}{v}", if i == 0 { "" } else { ", " })?;
                }
                f.write_str("]")
            }
            Self::Map(map) => {
                f.write_str("{")?;
                for (i, (key, v)) in map.iter().enumerate() {
                    write!(f, "{}{key}: {v}", if i == 0 { "" } else { ", " })?;
                }
                f.write_str("}")
            }
            Self::Device(device) => f.write_str(device.name()),
        }
    }
}

macro_rules! from_number {
    ($variant:ident($wide:ty): $($from:ty),*) => {$(
        impl From<$from> for Value {
            fn from(v: $from) -> Self {
                Self::$variant(<$wide>::from(v))
            }
        }
    )*};
}

from_number!(Int(i64): i8, i16, i32, i64, u8, u16, u32);
from_number!(Float(f64): f32, f64);
from_number!(Bool(bool): bool);
from_number!(Text(String): &str, String);

impl From<usize> for Value {
    /// A count; one beyond `i64` becomes the nearest float.
    fn from(v: usize) -> Self {
        i64::try_from(v).map_or(Self::Float(v as f64), Self::Int)
    }
}

impl From<Point> for Value {
    fn from(p: Point) -> Self {
        Self::List(vec![p.x.into(), p.y.into()])
    }
}

impl From<Size> for Value {
    fn from(size: Size) -> Self {
        Self::List(vec![size.width.into(), size.height.into()])
    }
}

impl From<Layer> for Value {
    /// `7` or `[7, 3]`.
    fn from(layer: Layer) -> Self {
        match layer.datatype {
            0 => layer.number.into(),
            datatype => Self::List(vec![layer.number.into(), datatype.into()]),
        }
    }
}

impl From<&Layers> for Value {
    /// As [`Layer`], `{"layers": […]}` for several, null for none.
    fn from(layers: &Layers) -> Self {
        match (layers.single(), layers.is_empty()) {
            (Some(layer), _) => layer.into(),
            (None, true) => Self::Null,
            (None, false) => {
                let list = Self::List(layers.iter().map(Self::from).collect());
                Self::Map(BTreeMap::from([("layers".to_owned(), list)]))
            }
        }
    }
}

impl From<&Port> for Value {
    /// `{"midpoint": […], "width": …, "orientation": …}`, with the name if it has one.
    fn from(port: &Port) -> Self {
        let mut map = BTreeMap::from([
            ("midpoint".to_owned(), port.midpoint().into()),
            ("width".to_owned(), port.width().into()),
            ("orientation".to_owned(), port.orientation().into()),
        ]);
        if !port.name().is_empty() {
            map.insert("name".to_owned(), port.name().into());
        }
        if !port.info().is_empty() {
            map.insert("info".to_owned(), Self::Map(port.info().clone()));
        }
        Self::Map(map)
    }
}

impl From<Device> for Value {
    fn from(device: Device) -> Self {
        Self::Device(device)
    }
}

impl<T: Into<Value>> From<Vec<T>> for Value {
    fn from(list: Vec<T>) -> Self {
        Self::List(list.into_iter().map(Into::into).collect())
    }
}

impl<T: Into<Value>, const N: usize> From<[T; N]> for Value {
    fn from(list: [T; N]) -> Self {
        Self::List(list.into_iter().map(Into::into).collect())
    }
}

impl<T: Into<Value>> From<Option<T>> for Value {
    fn from(v: Option<T>) -> Self {
        v.map_or(Self::Null, Into::into)
    }
}

impl From<BTreeMap<String, Value>> for Value {
    fn from(map: BTreeMap<String, Value>) -> Self {
        Self::Map(map)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_zeros_are_one_value_and_numbers_keep_their_type() {
        assert_eq!(Value::from(-0.0), Value::from(0.0));
        assert_ne!(Value::from(1), Value::from(1.0));
        assert_ne!(Value::from(0.1 + 0.2), Value::from(0.3));
    }

    #[test]
    fn layers_are_written_in_their_shortest_form() {
        assert_eq!(Value::from(&Layers::from(7)).to_string(), "7");
        assert_eq!(Value::from(&Layers::from((7, 3))).to_string(), "[7, 3]");
        assert_eq!(Value::from(&Layers::from([1, 2])).to_string(), "{layers: [1, 2]}");
        assert_eq!(Value::from(&Layers::NONE), Value::Null);
    }

    #[test]
    fn values_have_short_forms_for_names() {
        let cases = [(Value::from(0.5), "0p5"), ((-3).into(), "m3"), ([1, 2].into(), "1x2"), ("N E".into(), "N_E")];
        for (value, expected) in cases {
            assert_eq!(value.short().as_deref(), Some(expected));
        }
        assert_eq!(Value::Null.short(), None);
    }

    #[test]
    fn nan_is_found_at_any_depth() {
        assert!(!Value::from(vec![Value::from(1), Value::from(vec![f64::NAN])]).is_finite());
        assert!(Value::from(vec![1.0]).is_finite());
    }
}
