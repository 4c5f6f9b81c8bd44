//! [`ParamSpec`]: a parameter of a generator as `#[device]` states it.

use super::{Bounds, Param, ParamPath, ParamType, Unit, Value};
use crate::error::ParamError;

/// A parameter of a generator: name, documentation, type, unit and bounds. (Generated code makes it.)
#[derive(Debug)]
pub struct ParamSpec {
    name: &'static str,
    docs: &'static str,
    param_type: fn() -> ParamType,
    unit: Unit,
    bounds: Bounds,
}

impl ParamSpec {
    #[doc(hidden)]
    #[must_use]
    pub const fn new<T: Param>(name: &'static str, docs: &'static str, unit: Unit, bounds: Bounds) -> Self {
        Self { name, docs: docs.trim_ascii(), param_type: T::param_type, unit, bounds }
    }

    /// The name under which it is registered.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// Its documentation, in Markdown.
    #[must_use]
    pub fn docs(&self) -> &'static str {
        self.docs
    }

    /// The type of its values.
    #[must_use]
    pub fn param_type(&self) -> ParamType {
        (self.param_type)()
    }

    /// The unit of its numbers.
    #[must_use]
    pub fn unit(&self) -> Unit {
        self.unit
    }

    /// The range of its numbers.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Refuses a value with a number that is out of bounds or not finite.
    pub(crate) fn check(&self, device: &str, value: &Value) -> Result<(), ParamError> {
        let at = ParamPath { device, path: self.name, unit: self.unit.sign() };
        self.bounds.check(at, self.param_type, value)
    }
}
