//! [`Value`] in any format that serde knows: floats stay floats, integers integers.

use std::collections::BTreeMap;
use std::error::Error as _;
use std::fmt;

use serde::de::{Deserialize, Deserializer, Error as _, MapAccess, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::{Param as _, Value};
use crate::runtime::{Partial, registry};
use crate::scene::Device;

impl Serialize for Value {
    /// A device is written as `{"device": generator, "params": {…}}`, or `{"device": name, "content": hash}` if no
    /// generator drew it.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Null => serializer.serialize_unit(),
            Self::Bool(v) => serializer.serialize_bool(*v),
            Self::Int(v) => serializer.serialize_i64(*v),
            Self::Float(v) => serializer.serialize_f64(*v),
            Self::Text(v) => serializer.serialize_str(v),
            Self::List(list) => serializer.collect_seq(list),
            Self::Map(map) => serializer.collect_map(map),
            Self::Device(device) => serialize_device(device, serializer),
        }
    }
}

fn serialize_device<S: Serializer>(device: &Device, serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(2))?;
    match device.source() {
        Some(source) => {
            map.serialize_entry("device", &registry::address(source.generator, source.module))?;
            map.serialize_entry("params", &Params(&source.params))?;
        }
        None => {
            map.serialize_entry("device", device.name())?;
            map.serialize_entry("content", &device.content_hash().to_string())?;
        }
    }
    map.end()
}

/// Parameters in the order of their generator.
struct Params<'a>(&'a [(&'static str, Value)]);

impl Serialize for Params<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

impl<'de> Deserialize<'de> for Value {
    /// A device is read as a map; the parameter that takes it draws it.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(ValueVisitor)
    }
}

impl<'de> Deserialize<'de> for Partial {
    /// `{"device": NAME, "params": {…}}` or `"NAME"`, of a generator that is linked in. Names are looked up, values only
    /// when it is drawn.
    ///
    /// ```
    /// # use phidl_core::prelude::*;
    /// let unknown: Result<Partial, _> = serde_json::from_str(r#"{"device": "rign", "params": {"radius": 20}}"#);
    /// assert!(unknown.unwrap_err().to_string().contains("there is no generator \"rign\""));
    /// ```
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        Self::from_value(&value).map_err(|mismatch| {
            let cause = mismatch.source().map(ToString::to_string);
            D::Error::custom(cause.unwrap_or_else(|| mismatch.to_string()))
        })
    }
}

struct ValueVisitor;

impl<'de> Visitor<'de> for ValueVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("null, true, false, a number, text, a list or a map with text keys")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_none<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_some<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        Value::deserialize(deserializer)
    }

    fn visit_bool<E>(self, v: bool) -> Result<Value, E> {
        Ok(Value::Bool(v))
    }

    fn visit_i64<E>(self, v: i64) -> Result<Value, E> {
        Ok(Value::Int(v))
    }

    fn visit_u64<E: serde::de::Error>(self, v: u64) -> Result<Value, E> {
        i64::try_from(v).map(Value::Int).map_err(|_| E::custom(format_args!("{v} is more than {}", i64::MAX)))
    }

    fn visit_f64<E>(self, v: f64) -> Result<Value, E> {
        Ok(Value::Float(v))
    }

    fn visit_str<E>(self, v: &str) -> Result<Value, E> {
        Ok(Value::Text(v.to_owned()))
    }

    fn visit_string<E>(self, v: String) -> Result<Value, E> {
        Ok(Value::Text(v))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Value, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = seq.next_element()? {
            list.push(item);
        }
        Ok(Value::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Value, A::Error> {
        let mut map = BTreeMap::new();
        while let Some((key, value)) = entries.next_entry::<String, Value>()? {
            if map.contains_key(&key) {
                return Err(A::Error::custom(format_args!("{key:?} is given twice")));
            }
            map.insert(key, value);
        }
        Ok(Value::Map(map))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_gives_back_the_same_value_with_the_same_bits() {
        let numbers = vec![Value::from(0.1 + 0.2), Value::from(1e-300), Value::from(3.0), Value::from(3)];
        let mut map = BTreeMap::from([("numbers".to_owned(), Value::List(numbers))]);
        map.insert("none".to_owned(), Value::Null);
        map.insert("text".to_owned(), Value::from("µ\"\n"));
        let value = Value::Map(map);
        let json = serde_json::to_string(&value).unwrap();
        assert_eq!(serde_json::from_str::<Value>(&json).unwrap(), value, "{json}");
    }

    #[test]
    fn a_device_without_generator_is_written_with_its_content() {
        let device = Device::builder("pad").build().unwrap();
        let json = serde_json::to_value(Value::from(device.clone())).unwrap();
        assert_eq!(json, serde_json::json!({"device": "pad", "content": device.content_hash().to_string()}));
    }

    #[test]
    fn numbers_out_of_range_and_repeated_keys_are_refused() {
        assert!(serde_json::from_str::<Value>("18446744073709551615").is_err());
        assert!(serde_json::from_str::<Value>("{\"a\": 1, \"a\": 2}").is_err());
    }
}
