//! [`Key`]: which generator with which parameters, as the cache compares them.

use std::any::TypeId;
use std::hash::{BuildHasher, Hash, Hasher};
use std::sync::Arc;

use rustc_hash::FxBuildHasher;

use super::{Generator, Record};

/// The identity of a call: the type of the parameters and their record, floats by their bits.
///
/// The hash is computed once, before the lock of the cache is taken.
#[derive(Clone)]
pub(super) struct Key {
    hash: u64,
    generator: TypeId,
    pub(super) record: Arc<Record>,
}

impl Key {
    pub(super) fn of<G: Generator>(params: &G) -> Self {
        let (generator, record) = (TypeId::of::<G>(), params.record());
        let mut hasher = FxBuildHasher.build_hasher();
        generator.hash(&mut hasher);
        record.iter().for_each(|(_, value)| value.hash(&mut hasher));
        Self { hash: hasher.finish(), generator, record: Arc::new(record) }
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        let values = || self.record.iter().zip(other.record.iter()).all(|((_, a), (_, b))| a == b);
        self.hash == other.hash && self.generator == other.generator && values()
    }
}

impl Eq for Key {}

impl Hash for Key {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.hash.hash(state);
    }
}

#[cfg(test)]
impl Key {
    /// The key of a call that nothing else makes.
    pub(super) fn of_number(n: u32) -> Self {
        let record = Arc::new(vec![("n", n.into())]);
        Self { hash: n.into(), generator: TypeId::of::<u32>(), record }
    }
}
