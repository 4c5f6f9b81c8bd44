//! Values of a cell into JSON, every number with the same bits.

use std::collections::BTreeMap;

use phidl_core::geom::Point;
use phidl_core::param::Value;
use phidl_core::scene::Source;
use serde_json::{Map, json};

/// One value. A device that is a parameter is given by the generator that drew it.
pub(super) fn value(value: &Value) -> serde_json::Value {
    serde_json::to_value(value).expect("invariant: keys are texts, and a finished cell holds finite numbers only")
}

/// What was noted under keys.
pub(super) fn map(entries: &BTreeMap<String, Value>) -> Map<String, serde_json::Value> {
    entries.iter().map(|(key, v)| (key.clone(), value(v))).collect()
}

/// `[x, y]`.
pub(super) fn point(p: Point) -> serde_json::Value {
    json!([p.x, p.y])
}

/// The parameters of a generator, in its order.
pub(super) fn params(source: &Source) -> Map<String, serde_json::Value> {
    source.params.iter().map(|(name, v)| ((*name).to_owned(), value(v))).collect()
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
        let list = Value::from(vec![Value::from(1), 1.0.into(), "a".into(), true.into(), Value::Null]);
        assert_eq!(value(&list).to_string(), r#"[1,1.0,"a",true,null]"#);
    }
}
