//! [`ParamReader`]: the parameters of a generator taken from values by name.

use std::collections::BTreeMap;

use super::GeneratorInfo;
use crate::error::{Error, ItemKind, ParamError, Result};
use crate::param::{Param, Value};

/// Values from which a generator takes its parameters by name. (Generated code reads from it.)
pub struct ParamReader<'a> {
    entry: &'static GeneratorInfo,
    given: &'a BTreeMap<String, Value>,
}

impl<'a> ParamReader<'a> {
    /// Refuses names that the generator does not have.
    pub(super) fn new(entry: &'static GeneratorInfo, given: &'a BTreeMap<String, Value>) -> Result<Self> {
        match given.keys().find(|key| !entry.names().any(|name| name == key.as_str())) {
            None => Ok(Self { entry, given }),
            Some(name) => Err(Error::Unknown {
                owner: entry.name.into(),
                kind: ItemKind::Parameter,
                name: name.as_str().into(),
                known: entry.names().map(str::to_owned).collect(),
            }),
        }
    }

    #[doc(hidden)]
    pub fn or<T: Param>(&self, index: usize, default: fn() -> T) -> Result<T> {
        Ok(self.given(index)?.unwrap_or_else(default))
    }

    #[doc(hidden)]
    pub fn required<T: Param>(&self, index: usize) -> Result<T> {
        self.given(index)?.ok_or_else(|| {
            let rule = format!("be given: it has no default and takes {}", T::param_type());
            let (device, param) = (self.entry.name.to_owned(), self.entry.row(index).name().to_owned());
            ParamError { device, param, value: "missing".to_owned(), rule }.into()
        })
    }

    fn given<T: Param>(&self, index: usize) -> Result<Option<T>> {
        let name = self.entry.row(index).name();
        let value = self.given.get(name).map(T::from_value).transpose();
        value.map_err(|mismatch| mismatch.into_error(self.entry.name, name))
    }
}
