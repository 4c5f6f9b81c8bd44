//! [`Partial`]: a generator with some of its parameters, not drawn yet; and devices that are drawn from values.

use std::collections::BTreeMap;

use super::{Generator, GeneratorInfo, ParamValues, registry};
use crate::error::Result;
use crate::param::{ConversionError, Param, ParamType, Value};
use crate::scene::Device;

/// A generator with some of its parameters: what a sweep draws many times, each time with others.
///
/// Where a generator takes one, the parameter struct of any other can be given for it. From JSON it is
/// `{"device": NAME, "params": {…}}` or, with every parameter at its default, `"NAME"`.
#[derive(Debug, Clone)]
pub struct Partial {
    entry: &'static GeneratorInfo,
    params: BTreeMap<String, Value>,
}

impl Partial {
    /// The registered generator with this name and some of its parameters.
    ///
    /// # Errors
    /// A generator or parameter that is not there. The values are checked when the cell is built.
    pub fn new(name: &str, params: BTreeMap<String, Value>) -> Result<Self> {
        let entry = registry::find(name)?;
        super::ParamReader::new(entry, &params)?;
        Ok(Self { entry, params })
    }

    /// The generator.
    #[must_use]
    pub fn entry(&self) -> &'static GeneratorInfo {
        self.entry
    }

    /// The parameters that are set.
    #[must_use]
    pub fn params(&self) -> &BTreeMap<String, Value> {
        &self.params
    }

    /// The same generator with more parameters set; they override those that are set already.
    ///
    /// # Errors
    /// [`Error::Unknown`](crate::Error::Unknown) for a parameter that is not there.
    pub fn with<K: Into<String>>(&self, params: impl IntoIterator<Item = (K, Value)>) -> Result<Self> {
        let mut all = self.params.clone();
        all.extend(params.into_iter().map(|(name, value)| (name.into(), value)));
        super::ParamReader::new(self.entry, &all)?;
        Ok(Self { entry: self.entry, params: all })
    }

    /// Every parameter, checked but not drawn.
    ///
    /// # Errors
    /// As for [`GeneratorInfo::record`].
    pub fn record(&self) -> Result<ParamValues> {
        self.entry.record(&self.params)
    }

    /// The cell.
    ///
    /// # Errors
    /// As for [`GeneratorInfo::build`].
    pub fn build(&self) -> Result<Device> {
        self.entry.build(&self.params)
    }
}

impl<G: Generator> From<G> for Partial {
    fn from(generator: G) -> Self {
        Self { entry: G::entry(), params: generator.record().by_name() }
    }
}

impl PartialEq for Partial {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.entry, other.entry) && self.params == other.params
    }
}

impl Param for Partial {
    fn param_type() -> ParamType {
        ParamType::Generator
    }

    fn to_value(&self) -> Value {
        let name = registry::address(self.entry.name, self.entry.module).into_owned();
        let params = Value::Map(self.params.clone());
        Value::Map([("device".to_owned(), Value::Text(name)), ("params".to_owned(), params)].into())
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let (name, params) = parts(value).ok_or_else(|| {
            ConversionError::new(value, "be a generator, {\"device\": NAME, \"params\": {…}} or its name")
        })?;
        Self::new(name, params).map_err(|error| ConversionError::caused_by(value, error))
    }
}

impl Param for Device {
    fn param_type() -> ParamType {
        ParamType::Device
    }

    fn to_value(&self) -> Value {
        Value::Device(self.clone())
    }

    /// Draws the device that the value names, unless it is one.
    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        if let Value::Device(device) = value {
            return Ok(device.clone());
        }
        let (name, params) = parts(value)
            .ok_or_else(|| ConversionError::new(value, "be a device, {\"device\": NAME, \"params\": {…}}"))?;
        let built = registry::find(name).and_then(|entry| entry.build(&params));
        built.map_err(|error| ConversionError::caused_by(value, error))
    }
}

/// Name and parameters of a generator as a value holds them.
fn parts(value: &Value) -> Option<(&str, BTreeMap<String, Value>)> {
    let Value::Map(map) = value else {
        return Some((value.as_str()?, BTreeMap::new()));
    };
    let name = map.get("device")?.as_str()?;
    match (map.len(), map.get("params")) {
        (1, None) => Some((name, BTreeMap::new())),
        (2, Some(Value::Map(params))) => Some((name, params.clone())),
        _ => None,
    }
}
