//! Every generator that is linked into the program.
//!
//! A program only sees the generators of crates that it links; one whose items it never names may be left out by the
//! linker. A binary that only builds by name says `use that_crate as _;`.

use std::borrow::Cow;
use std::sync::LazyLock;

use super::GeneratorInfo;
use crate::error::{Error, ItemKind, Result};

/// A generator that `#[device]` registers.
#[doc(hidden)]
pub struct Registered(pub fn() -> &'static GeneratorInfo);

inventory::collect!(Registered);

static ENTRIES: LazyLock<Vec<&'static GeneratorInfo>> = LazyLock::new(|| {
    let mut entries: Vec<_> = inventory::iter::<Registered>.into_iter().map(|registered| (registered.0)()).collect();
    entries.sort_by_key(|entry| (entry.name, entry.module));
    entries
});

/// All generators, by name and then by module.
pub fn all() -> impl ExactSizeIterator<Item = &'static GeneratorInfo> {
    ENTRIES.iter().copied()
}

/// The generator with this name. `module::name` tells generators of several crates apart.
///
/// # Errors
/// [`Error::Unknown`] with the names that are there; [`Error::Invalid`] if the name alone does not say which one.
pub fn find(name: &str) -> Result<&'static GeneratorInfo> {
    let found: Vec<_> = all().filter(|entry| entry.name == name || path(entry.module, entry.name) == name).collect();
    match found[..] {
        [entry] => Ok(entry),
        [] => Err(Error::Unknown {
            owner: "registry".into(),
            kind: ItemKind::Generator,
            name: name.into(),
            known: all().map(|entry| entry.name.to_owned()).collect(),
        }),
        _ => {
            let paths: Vec<_> = found.iter().map(|entry| path(entry.module, entry.name)).collect();
            let problem =
                format!("several generators are called {name:?}: {}; name one with its path", paths.join(", "));
            Err(Error::invalid("registry", problem))
        }
    }
}

/// The shortest name under which [`find`] finds a generator.
pub(crate) fn address(name: &'static str, module: &str) -> Cow<'static, str> {
    match all().filter(|entry| entry.name == name).count() {
        0 | 1 => name.into(),
        _ => path(module, name).into(),
    }
}

fn path(module: &str, name: &str) -> String {
    format!("{module}::{name}")
}
