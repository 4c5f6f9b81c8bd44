//! Lists, options and maps as parameters.

use std::collections::BTreeMap;

use super::{ConversionError, Param, ParamType, Value};

impl<T: Param> Param for Vec<T> {
    fn param_type() -> ParamType {
        ParamType::List(Box::new(T::param_type()))
    }

    fn to_value(&self) -> Value {
        Value::List(self.iter().map(T::to_value).collect())
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let Some(list) = value.as_list() else {
            return Err(ConversionError::new(value, format!("be a {}", Self::param_type())));
        };
        let item = |(i, v)| T::from_value(v).map_err(|mismatch| mismatch.at(format_args!("[{i}]")));
        list.iter().enumerate().map(item).collect()
    }
}

impl<T: Param> Param for Option<T> {
    fn param_type() -> ParamType {
        ParamType::Optional(Box::new(T::param_type()))
    }

    fn to_value(&self) -> Value {
        self.as_ref().map_or(Value::Null, T::to_some_value)
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Null => Ok(None),
            some => T::from_value(some).map(Some),
        }
    }
}

impl<T: Param> Param for BTreeMap<String, T> {
    fn param_type() -> ParamType {
        ParamType::Map(Box::new(T::param_type()))
    }

    fn to_value(&self) -> Value {
        Value::Map(self.iter().map(|(key, v)| (key.clone(), v.to_value())).collect())
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let Value::Map(map) = value else {
            return Err(ConversionError::new(value, format!("be a {}", Self::param_type())));
        };
        let entry = |(key, v): (&String, &Value)| {
            let v = T::from_value(v).map_err(|mismatch| mismatch.at(format_args!("[{key:?}]")))?;
            Ok((key.clone(), v))
        };
        map.iter().map(entry).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layer::Layers;

    #[test]
    fn lists_options_and_maps_come_back_from_their_values() {
        let list = vec![Some(1.0), None];
        assert_eq!(Vec::<Option<f64>>::from_value(&list.to_value()).unwrap(), list);
        let map = BTreeMap::from([("N".to_owned(), 3_usize), ("S".to_owned(), 4)]);
        assert_eq!(BTreeMap::<String, usize>::from_value(&map.to_value()).unwrap(), map);
    }

    #[test]
    fn no_layer_is_not_the_same_as_no_value() {
        for layers in [None, Some(Layers::NONE), Some(Layers::from(3))] {
            assert_eq!(Option::<Layers>::from_value(&layers.to_value()).unwrap(), layers);
        }
    }

    #[test]
    fn a_wrong_item_is_named_by_its_index() {
        let list = Value::from(vec![Value::from(1), Value::from("x")]);
        assert_eq!(Vec::<f64>::from_value(&list).unwrap_err().to_string(), "[1] is \"x\", but it must be a number");
        assert!(Vec::<f64>::from_value(&Value::from(1)).is_err());
    }
}
