//! [`Generator`]: a set of parameters that can be drawn.

use std::collections::BTreeMap;

use super::{GeneratorInfo, ParamReader, ParamValues, build};
use crate::error::Result;
use crate::param::Value;
use crate::scene::Device;

/// The parameters of a generator, as `#[device]` declares them.
///
/// It is not meant to be implemented by hand: `#[device]` implements its hidden items, which may change.
pub trait Generator: Clone + std::fmt::Debug + PartialEq + Send + Sync + Sized + 'static {
    /// The entry of the generator in the registry.
    fn entry() -> &'static GeneratorInfo;

    /// The values of all parameters.
    fn record(&self) -> ParamValues;

    /// Takes every parameter from values, or its default.
    #[doc(hidden)]
    fn read(from: &ParamReader<'_>) -> Result<Self>;

    /// The defaults, in the generator's order.
    #[doc(hidden)]
    fn defaults() -> Vec<Option<Value>>;

    /// The parameters with which galleries and tests draw it.
    #[doc(hidden)]
    fn example() -> Result<Self> {
        Self::read(&ParamReader::new(Self::entry(), &BTreeMap::new())?)
    }

    /// Runs the body.
    #[doc(hidden)]
    fn draw(self) -> Result<Device>;

    /// The cell with these parameters: drawn when first asked for, then from the cache.
    ///
    /// # Errors
    /// A bound that a parameter breaks, [`Error::CyclicDependency`](crate::Error::CyclicDependency), and the errors of the body.
    fn build(&self) -> Result<Device> {
        build::build(self)
    }
}
