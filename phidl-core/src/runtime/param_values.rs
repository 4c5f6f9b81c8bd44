//! [`ParamValues`]: the parameters of a call as values, and the identity of the call for the cache.

use std::any::TypeId;
use std::collections::BTreeMap;
use std::hash::{BuildHasher, Hash, Hasher};
use std::ops::Deref;

use rustc_hash::FxBuildHasher;
use triomphe::ThinArc;

use super::Generator;
use crate::param::Value;

/// The value of every parameter of a generator, by its registered name, in the generator's order.
///
/// The one walk over the parameters: the key of the cache, the [`Source`](crate::scene::Source) of the cell and what is
/// written to JSON are all made of it, so they cannot differ. A clone shares it. Two are equal if they belong to the same
/// generator and hold equal values, floats by their bits.
#[derive(Clone)]
pub struct ParamValues(ThinArc<Call, (&'static str, Value)>);

/// The key of the cache: its hash is computed once, before the lock of the cache is taken.
struct Call {
    generator: TypeId,
    hash: u64,
}

impl ParamValues {
    /// The values of a generator. (Generated code makes them.)
    #[doc(hidden)]
    #[must_use]
    pub fn of<G: Generator, const N: usize>(mut params: [(&'static str, Value); N]) -> Self {
        Self::new(TypeId::of::<G>(), &mut params)
    }

    fn new(generator: TypeId, params: &mut [(&'static str, Value)]) -> Self {
        let mut hasher = FxBuildHasher.build_hasher();
        generator.hash(&mut hasher);
        params.iter().for_each(|(_, value)| value.hash(&mut hasher));
        let call = Call { generator, hash: hasher.finish() };
        // One by one out of the caller's array, which as a whole would be moved twice.
        let params = params.iter_mut().map(|(name, value)| (*name, std::mem::replace(value, Value::Null)));
        Self(ThinArc::from_header_and_iter(call, params))
    }

    /// The parameters as they are given to [`GeneratorInfo::build`](super::GeneratorInfo::build).
    #[must_use]
    pub fn by_name(&self) -> BTreeMap<String, Value> {
        self.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect()
    }

    fn call(&self) -> &Call {
        &self.0.header.header
    }
}

impl<const N: usize> From<[(&'static str, Value); N]> for ParamValues {
    /// Values that belong to no generator.
    fn from(mut params: [(&'static str, Value); N]) -> Self {
        Self::new(TypeId::of::<()>(), &mut params)
    }
}

impl Deref for ParamValues {
    type Target = [(&'static str, Value)];

    fn deref(&self) -> &Self::Target {
        &self.0.slice
    }
}

impl PartialEq for ParamValues {
    fn eq(&self, other: &Self) -> bool {
        let (a, b) = (self.call(), other.call());
        let values = || self.iter().zip(other.iter()).all(|((_, a), (_, b))| a == b);
        a.hash == b.hash && a.generator == b.generator && values()
    }
}

impl Eq for ParamValues {}

impl Hash for ParamValues {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.call().hash.hash(state);
    }
}

impl std::fmt::Debug for ParamValues {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_map().entries(self.iter().map(|(name, value)| (name, value))).finish()
    }
}
