//! Values of a cell into JSON, with every number as it is.
//!
//! JSON has no infinities and no NaN. A cell refuses them in its info; where a port's note still has one, it is written
//! as a text (`"NaN"`, `"inf"`), since null would say that nothing was noted.

use std::collections::BTreeMap;

use phidl_core::geom::Point;
use phidl_core::param::Value;
use phidl_core::scene::{Device, Source};
use serde_json::{Map, Number, json};

/// A value, with integers and floats told apart (`1` and `1.0`).
pub(super) fn value(value: &Value) -> serde_json::Value {
    match value {
        Value::Null => serde_json::Value::Null,
        Value::Bool(v) => (*v).into(),
        Value::Int(v) => (*v).into(),
        Value::Float(v) => float(*v),
        Value::Text(text) => text.as_str().into(),
        Value::List(list) => list.iter().map(self::value).collect(),
        Value::Map(entries) => map(entries).into(),
        Value::Device(device) => self::device(device),
    }
}

pub(super) fn map(entries: &BTreeMap<String, Value>) -> Map<String, serde_json::Value> {
    entries.iter().map(|(key, v)| (key.clone(), value(v))).collect()
}

pub(super) fn float(v: f64) -> serde_json::Value {
    Number::from_f64(v).map_or_else(|| v.to_string().into(), Into::into)
}

pub(super) fn point(p: Point) -> serde_json::Value {
    [float(p.x), float(p.y)].into_iter().collect()
}

pub(super) fn params(source: &Source) -> Map<String, serde_json::Value> {
    source.params.iter().map(|(name, v)| ((*name).to_owned(), value(v))).collect()
}

/// A cell as a parameter: how it was generated, or what it is.
fn device(device: &Device) -> serde_json::Value {
    match device.source() {
        Some(source) => json!({ "device": source.generator, "params": params(source) }),
        None => json!({ "cell": device.name(), "content_hash": device.content_hash().to_string() }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_with_the_same_bits() {
        for v in [0.1, 1.0 / 3.0, 5e-324, f64::MAX, -0.0, 123_456_789.123_456_79, 1e23] {
            let text = value(&Value::from(v)).to_string();
            let back: serde_json::Value = serde_json::from_str(&text).unwrap();
            assert_eq!(back.as_f64().unwrap().to_bits(), v.to_bits(), "{text}");
        }
    }

    #[test]
    fn values_keep_their_kind() {
        let list = Value::from(vec![Value::from(1), 1.0.into(), "a".into(), true.into(), Value::Null, f64::NAN.into()]);
        assert_eq!(value(&list).to_string(), r#"[1,1.0,"a",true,null,"NaN"]"#);
    }
}
