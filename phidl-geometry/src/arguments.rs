//! Spellings of parameters that several generators share: [`PerAxis`], [`PartialSize`], [`OneOrMany`],
//! [`LayerList`].
//!
//! They are types of their own, since what `#[device]` sees is a type, and "a number or a pair" is none that Rust has.
//! In JSON they are what a script would write; in a record they have one form only, so that equal calls are one cell.

use phidl_core::param::{ConversionError, IntoOption, Param, ParamType};
use phidl_core::prelude::*;

/// A length for each direction; one number stands for both.
///
/// ```
/// # use phidl_geometry::arguments::PerAxis;
/// assert_eq!(PerAxis::from(2), PerAxis::from((2.0, 2)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PerAxis {
    /// Along x.
    pub x: f64,
    /// Along y.
    pub y: f64,
}

macro_rules! both {
    ($($number:ty),*) => {$(
        impl From<$number> for PerAxis {
            fn from(length: $number) -> Self {
                Self { x: length.into(), y: length.into() }
            }
        }
    )*};
}

both!(f64, f32, i32, u32, i16, u16, i8, u8);

impl<X: Into<f64>, Y: Into<f64>> From<(X, Y)> for PerAxis {
    fn from((x, y): (X, Y)) -> Self {
        Self { x: x.into(), y: y.into() }
    }
}

impl<N: Into<f64>> From<[N; 2]> for PerAxis {
    fn from([x, y]: [N; 2]) -> Self {
        (x, y).into()
    }
}

impl Param for PerAxis {
    fn param_type() -> ParamType {
        ParamType::Other("number, or one number for x and one for y")
    }

    fn to_value(&self) -> Value {
        [self.x, self.y].into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        if value.as_list().is_none() {
            return Ok(f64::from_value(value)?.into());
        }
        match Vec::<f64>::from_value(value)?[..] {
            [both] => Ok(both.into()),
            [x, y] => Ok(Self { x, y }),
            _ => Err(ConversionError::new(value, "be one number, or one for x and one for y")),
        }
    }
}

/// Width and height (µm), of which one or both may be left open; given as a pair with `None` for an open one, or as `None`
/// for both.
///
/// ```
/// # use phidl_geometry::arguments::PartialSize;
/// assert_eq!(PartialSize::from((10, None)), PartialSize { width: Some(10.0), height: None });
/// assert_eq!(PartialSize::from(None), PartialSize::NONE);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PartialSize {
    /// Extent along x (µm).
    pub width: Option<f64>,
    /// Extent along y (µm).
    pub height: Option<f64>,
}

impl PartialSize {
    /// Neither is given.
    pub const NONE: Self = Self { width: None, height: None };
}

impl<W: IntoOption<f64>, H: IntoOption<f64>> From<(W, H)> for PartialSize {
    fn from((width, height): (W, H)) -> Self {
        Self { width: width.into_option(), height: height.into_option() }
    }
}

impl From<Option<Size>> for PartialSize {
    fn from(size: Option<Size>) -> Self {
        size.map_or(Self::NONE, Self::from)
    }
}

impl From<Size> for PartialSize {
    fn from(size: Size) -> Self {
        Self { width: Some(size.width), height: Some(size.height) }
    }
}

impl Param for PartialSize {
    fn param_type() -> ParamType {
        ParamType::Other("width and height, each a number or none")
    }

    fn to_value(&self) -> Value {
        vec![self.width.to_value(), self.height.to_value()].into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match Option::<Vec<Option<f64>>>::from_value(value)?.as_deref() {
            None => Ok(Self::NONE),
            Some([width, height]) => Ok(Self { width: *width, height: *height }),
            Some(_) => Err(ConversionError::new(value, "be a width and a height, null for an open one")),
        }
    }
}

/// A list of which one item may be given bare.
///
/// ```
/// # use phidl_geometry::arguments::OneOrMany;
/// assert_eq!(OneOrMany::<f64>::from(0.5), OneOrMany(vec![0.5]));
/// assert_eq!(OneOrMany::<f64>::from([1, 2]), OneOrMany(vec![1.0, 2.0]));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OneOrMany<T>(pub Vec<T>);

impl<T, U: Into<T>, const N: usize> From<[U; N]> for OneOrMany<T> {
    fn from(items: [U; N]) -> Self {
        Self(items.into_iter().map(Into::into).collect())
    }
}

impl<T, U: Into<T>> From<Vec<U>> for OneOrMany<T> {
    fn from(items: Vec<U>) -> Self {
        Self(items.into_iter().map(Into::into).collect())
    }
}

macro_rules! one {
    ($($item:ty: $($from:ty),+;)*) => {$($(
        impl From<$from> for OneOrMany<$item> {
            fn from(item: $from) -> Self {
                Self(vec![item.into()])
            }
        }
    )+)*};
}

one! {
    f64: f64, i32;
    bool: bool;
    Layer: Layer, u16, (u16, u16);
}

impl<T: Param> Param for OneOrMany<T> {
    fn param_type() -> ParamType {
        ParamType::List(Box::new(T::param_type()))
    }

    fn to_value(&self) -> Value {
        self.0.to_value()
    }

    /// A list, one bare item, or null for none.
    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Null => Ok(Self(Vec::new())),
            Value::List(_) => Vec::from_value(value).map(Self),
            item => Ok(Self(vec![T::from_value(item)?])),
        }
    }
}

/// Some layers. Unlike [`Layers`], a list of numbers is always a list of layers: `[3, 0]` are the layers 3 and 0, and
/// layer 3 with datatype 0 is `[[3, 0]]` in JSON, `(3, 0)` in Rust.
///
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry::arguments::LayerList;
/// assert_eq!(LayerList::from([3, 0]).0, Layers::from([3, 0]));
/// assert_eq!(LayerList::from((8, 2)).0, Layers::from((8, 2)));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LayerList(pub Layers);

impl<L: Into<Layers>> From<L> for LayerList {
    fn from(layers: L) -> Self {
        Self(layers.into())
    }
}

impl Param for LayerList {
    fn param_type() -> ParamType {
        ParamType::List(Box::new(ParamType::Layer))
    }

    fn to_value(&self) -> Value {
        Value::List(self.0.iter().map(Value::from).collect())
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::List(_) => Ok(Self(Vec::<Layer>::from_value(value)?.into())),
            other => Layers::from_value(other).map(Self),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_number_is_both_directions_in_every_spelling() {
        for value in [Value::from(3), Value::from([3]), Value::from([3, 3])] {
            assert_eq!(PerAxis::from_value(&value).unwrap(), PerAxis { x: 3.0, y: 3.0 });
        }
        assert!(PerAxis::from_value(&Value::from([1, 2, 3])).is_err());
        assert!(PerAxis::from_value(&Value::from("x")).is_err());
    }

    #[test]
    fn a_size_may_be_open_in_every_direction_and_spelling() {
        for size in [PartialSize::from((10, None)), (1, 2).into(), PartialSize::NONE] {
            assert_eq!(PartialSize::from_value(&size.to_value()).unwrap(), size);
        }
        assert_eq!(PartialSize::from_value(&Value::Null).unwrap(), PartialSize::NONE);
        assert_eq!((PartialSize::from(None), PartialSize::from((None, None))), (PartialSize::NONE, PartialSize::NONE));
        assert!(PartialSize::from_value(&vec![1.0].into()).is_err());
    }

    #[test]
    fn a_list_of_two_numbers_is_two_layers_and_a_nested_pair_is_one() {
        let layers = |value: Value| LayerList::from_value(&value).unwrap().0;
        assert_eq!(layers([3, 0].into()), Layers::from([3, 0]));
        assert_eq!(layers(vec![Value::from([3, 0])].into()), Layers::from((3, 0)));
        assert_eq!(layers(5.into()), Layers::from(5));
        assert_eq!(layers(Value::Null), Layers::NONE);
        for list in [LayerList::from((8, 2)), LayerList::from([1, 2]), LayerList(Layers::NONE)] {
            assert_eq!(LayerList::from_value(&list.to_value()).unwrap(), list);
        }
    }

    #[test]
    fn one_bare_item_is_a_list_and_null_an_empty_one() {
        assert_eq!(OneOrMany::<f64>::from_value(&Value::from(0.25)).unwrap(), OneOrMany(vec![0.25]));
        assert_eq!(OneOrMany::<bool>::from_value(&Value::Null).unwrap(), OneOrMany(Vec::new()));
        assert_eq!(OneOrMany::<Layer>::from_value(&Value::from([8, 2])).unwrap().0.len(), 2);
        assert_eq!(OneOrMany::<bool>::from(true), OneOrMany(vec![true]));
    }
}
