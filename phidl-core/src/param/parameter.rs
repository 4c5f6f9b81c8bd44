//! [`Param`]: what can be a parameter of a generator, and how it becomes a [`Value`] and comes back.
//!
//! One pair of functions per type carries a parameter everywhere: into the key of the cache, the record in the
//! finished cell, and to and from JSON. Deriving serde for the parameter structs was the alternative; it would have
//! tied the key to a format, doubled the code of every generator, and said nothing about the types and paths in errors.

use super::{ConversionError, ParamType, Value};
use crate::geom::{Point, Size};
use crate::layer::{Layer, Layers};
use crate::port::Port;

/// A type that a parameter of a generator can have.
///
/// A type of your own needs `#[derive(Choice)]` (an enum without fields) or an implementation by hand, where
/// `from_value(&to_value(x))` gives back `x` for every finite `x`, and different `x` have different values.
///
/// ```
/// use phidl_core::param::{ParamType, ConversionError, Param, Value};
///
/// /// A wafer orientation.
/// #[derive(Debug, Clone, PartialEq)]
/// struct Miller([i64; 3]);
///
/// impl Param for Miller {
///     fn param_type() -> ParamType {
///         ParamType::Other("three integers")
///     }
///     fn to_value(&self) -> Value {
///         self.0.into()
///     }
///     fn from_value(value: &Value) -> Result<Self, ConversionError> {
///         let list = Vec::<i64>::from_value(value)?;
///         list.try_into().map(Self).map_err(|_| ConversionError::new(value, "be three integers"))
///     }
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be a parameter of a device generator",
    label = "not a parameter",
    note = "parameters are numbers, bools, text, points, sizes, layers, ports, devices, partial applications of generators, values, lists, maps and options of them, and enums with `#[derive(Choice)]`"
)]
pub trait Param: Clone + std::fmt::Debug + PartialEq + Send + Sync + 'static {
    /// What it takes, for the registry.
    fn param_type() -> ParamType;

    /// The parameter as a value.
    fn to_value(&self) -> Value;

    /// The parameter from a value.
    ///
    /// # Errors
    /// [`ConversionError`] if the value has another type. Nothing is rounded or cut to make it fit.
    fn from_value(value: &Value) -> Result<Self, ConversionError>;

    /// The value inside an option, where null means none.
    #[doc(hidden)]
    fn to_some_value(&self) -> Value {
        self.to_value()
    }
}

impl Param for f64 {
    fn param_type() -> ParamType {
        ParamType::Number
    }

    fn to_value(&self) -> Value {
        Value::Float(*self)
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        /// Up to here every integer is a float.
        const EXACT: i64 = 1 << 53;
        match value {
            Value::Float(v) => Ok(*v),
            Value::Int(v) if (-EXACT..=EXACT).contains(v) => Ok(*v as Self),
            _ => Err(ConversionError::new(value, "be a number")),
        }
    }
}

/// The integer that a value holds; `3.0` is one.
fn integer(value: &Value) -> Option<i64> {
    /// From here on a float stands for several integers.
    const LIMIT: f64 = (1_u64 << 53) as f64;
    match value {
        Value::Int(v) => Some(*v),
        #[expect(clippy::cast_possible_truncation, reason = "integral and within ±2⁵³")]
        Value::Float(v) if v.fract() == 0.0 && v.abs() <= LIMIT => Some(*v as i64),
        _ => None,
    }
}

macro_rules! integers {
    ($($int:ty),*) => {$(
        impl Param for $int {
            fn param_type() -> ParamType {
                ParamType::Integer
            }

            fn to_value(&self) -> Value {
                (*self).into()
            }

            fn from_value(value: &Value) -> Result<Self, ConversionError> {
                integer(value).and_then(|v| Self::try_from(v).ok()).ok_or_else(|| {
                    let (min, max) = (Self::MIN, Self::MAX);
                    ConversionError::new(value, format!("be an integer from {min} to {max}"))
                })
            }
        }
    )*};
}

integers!(i8, i16, i32, i64, u8, u16, u32, usize);

impl Param for bool {
    fn param_type() -> ParamType {
        ParamType::Bool
    }

    fn to_value(&self) -> Value {
        Value::Bool(*self)
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Bool(v) => Ok(*v),
            _ => Err(ConversionError::new(value, "be true or false")),
        }
    }
}

impl Param for String {
    fn param_type() -> ParamType {
        ParamType::Text
    }

    fn to_value(&self) -> Value {
        Value::Text(self.clone())
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        value.as_str().map(Self::from).ok_or_else(|| ConversionError::new(value, "be text"))
    }
}

impl Param for char {
    fn param_type() -> ParamType {
        ParamType::Character
    }

    fn to_value(&self) -> Value {
        Value::Text(self.to_string())
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let mut letters = value.as_str().unwrap_or_default().chars();
        match (letters.next(), letters.next()) {
            (Some(letter), None) => Ok(letter),
            _ => Err(ConversionError::new(value, "be one character")),
        }
    }
}

/// Any value at all, for generators that pass parameters on.
impl Param for Value {
    fn param_type() -> ParamType {
        ParamType::Any
    }

    fn to_value(&self) -> Value {
        self.clone()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        Ok(value.clone())
    }
}

/// The two numbers of a pair.
fn pair(value: &Value, kind: &ParamType, rule: &str) -> Result<(f64, f64), ConversionError> {
    let Some([a, b]) = value.as_list() else {
        return Err(ConversionError::new(value, rule));
    };
    let number = |index, v| f64::from_value(v).map_err(|mismatch| mismatch.at(kind.component(index)));
    Ok((number(0, a)?, number(1, b)?))
}

impl Param for Point {
    fn param_type() -> ParamType {
        ParamType::Point
    }

    fn to_value(&self) -> Value {
        (*self).into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        pair(value, &ParamType::Point, "be a point, two numbers").map(Self::from)
    }
}

impl Param for Size {
    fn param_type() -> ParamType {
        ParamType::Size
    }

    fn to_value(&self) -> Value {
        (*self).into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        pair(value, &ParamType::Size, "be a size, two numbers").map(Self::from)
    }
}

impl Param for Layer {
    fn param_type() -> ParamType {
        ParamType::Layer
    }

    fn to_value(&self) -> Value {
        (*self).into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let number = |v| u16::from_value(v).ok();
        let layer = match value.as_list() {
            Some([layer, datatype]) => number(layer).zip(number(datatype)).map(Self::from),
            Some(_) => None,
            None => number(value).map(Self::from),
        };
        layer
            .ok_or_else(|| ConversionError::new(value, "be a layer, such as 7 or [7, 3], with numbers from 0 to 65535"))
    }
}

impl Param for Layers {
    fn param_type() -> ParamType {
        ParamType::Layers
    }

    fn to_value(&self) -> Value {
        self.into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Null => Ok(Self::NONE),
            Value::Map(map) => match (map.len(), map.get("layers").and_then(Value::as_list)) {
                (1, Some(list)) => list.iter().map(Layer::from_value).collect(),
                _ => Err(ConversionError::new(value, "be a layer, null for none, or {\"layers\": […]} for several")),
            },
            single => Layer::from_value(single).map(Self::one),
        }
    }

    /// "On no layer" and "no value for the layer" are two values.
    fn to_some_value(&self) -> Value {
        match self.to_value() {
            Value::Null => Value::Map([("layers".to_owned(), Value::List(Vec::new()))].into()),
            value => value,
        }
    }
}

/// The entry of a port whose placement was refused: the placement method. Without it, such a port would equal a valid
/// one as a key of the cache. [`Bounds`](super::Bounds) refuse the entry.
pub(super) const REFUSED: &str = "refused";

impl Param for Port {
    fn param_type() -> ParamType {
        ParamType::Port
    }

    fn to_value(&self) -> Value {
        match (self.into(), self.invalid_method()) {
            (Value::Map(mut map), Some(word)) => {
                map.insert(REFUSED.to_owned(), word.into());
                Value::Map(map)
            }
            (value, _) => value,
        }
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let rule = "be a port, {\"midpoint\": [x, y], \"width\": …, \"orientation\": …}";
        let Value::Map(map) = value else {
            return Err(ConversionError::new(value, rule));
        };
        let known = ["midpoint", "width", "orientation", "name", "info"];
        if let Some(unknown) = map.keys().find(|key| !known.contains(&key.as_str())) {
            return Err(ConversionError::new(value, format!("{rule}, without {unknown:?}")));
        }
        let get = |key: &str| map.get(key).ok_or_else(|| ConversionError::new(value, rule));
        let number = |key| f64::from_value(get(key)?).map_err(|mismatch| mismatch.at(format_args!(".{key}")));
        let midpoint = Point::from_value(get("midpoint")?).map_err(|mismatch| mismatch.at(".midpoint"))?;
        let mut port = Self::new(midpoint, number("width")?, number("orientation")?);
        if let Some(name) = map.get("name") {
            port = port.named(String::from_value(name).map_err(|mismatch| mismatch.at(".name"))?);
        }
        match map.get("info") {
            None => Ok(port),
            Some(Value::Map(info)) => {
                Ok(info.iter().fold(port, |port, (key, note)| port.with_info(key.as_str(), note.clone())))
            }
            Some(other) => Err(ConversionError::new(other, "be a map").at(".info")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn comes_back<T: Param>(parameter: T) {
        assert_eq!(T::from_value(&parameter.to_value()).unwrap(), parameter);
    }

    #[test]
    fn every_parameter_comes_back_from_its_value() {
        comes_back(0.1 + 0.2);
        comes_back(-7_i64);
        comes_back(usize::MAX >> 1);
        comes_back(true);
        comes_back("p".to_owned());
        comes_back('µ');
        comes_back(Point::new(1.0, -2.5));
        comes_back(Size::new(4.0, 2.0));
        comes_back(Layer::new(7, 3));
        for layers in [Layers::from(1), Layers::from((1, 2)), Layers::from([(1, 0), (3, 5)]), Layers::NONE] {
            comes_back(layers);
        }
        comes_back(Port::new((1, 2), 3, 90).named("in").with_info("loss", 0.5));
        comes_back(Value::from(vec![1, 2]));
    }

    #[test]
    fn integers_are_numbers_and_whole_numbers_integers() {
        assert_eq!(f64::from_value(&Value::Int(3)).unwrap(), 3.0);
        assert_eq!(usize::from_value(&Value::Float(3.0)).unwrap(), 3);
        assert!(usize::from_value(&Value::Float(3.5)).is_err());
        assert!(usize::from_value(&Value::Int(-1)).is_err());
        assert!(u16::from_value(&Value::Int(65_536)).is_err());
        assert!(f64::from_value(&Value::Int((1 << 53) + 1)).is_err(), "it would be rounded");
    }

    #[test]
    fn a_value_of_another_type_is_named_with_its_path() {
        let size = Value::from(vec![Value::from(1.0), Value::from("x")]);
        assert_eq!(Size::from_value(&size).unwrap_err().to_string(), ".height is \"x\", but it must be a number");
        let port = Value::Map([("midpoint".to_owned(), Value::from(vec![1, 2])), ("w".to_owned(), 1.into())].into());
        assert!(Port::from_value(&port).unwrap_err().to_string().ends_with("without \"w\""));
    }
}
