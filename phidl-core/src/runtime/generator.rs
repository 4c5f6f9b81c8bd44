//! [`Generator`]: a set of parameters that can be drawn.

use std::collections::BTreeMap;

use super::{GeneratorInfo, ParamReader, ParamValues, build};
use crate::error::Result;
use crate::param::Value;
use crate::scene::Device;

/// The parameters of a generator, as `#[device]` declares them.
///
/// It is not meant to be implemented by hand; its hidden items are what the macro fills in and may change.
pub trait Generator: Clone + std::fmt::Debug + PartialEq + Send + Sync + Sized + 'static {
    /// What the registry knows of the generator.
    fn entry() -> &'static GeneratorInfo;

    /// Every parameter as a plain value.
    fn record(&self) -> ParamValues;

    /// Takes every parameter from plain values, or its default.
    #[doc(hidden)]
    fn read(from: &ParamReader<'_>) -> Result<Self>;

    /// The defaults, in the generator's order.
    #[doc(hidden)]
    fn defaults() -> Vec<Option<Value>>;

    /// What galleries and tests draw.
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
    /// A bound that a parameter breaks, [`Error::CyclicDependency`](crate::Error::CyclicDependency), and what the body says.
    fn build(&self) -> Result<Device> {
        build::build(self)
    }
}
