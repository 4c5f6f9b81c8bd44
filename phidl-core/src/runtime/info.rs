//! [`GeneratorInfo`]: a generator as the registry lists it.

use std::collections::BTreeMap;

use super::{Generator, ParamReader, ParamValues};
use crate::error::Result;
use crate::param::{Bounds, Check, ParamSpec, ParamType, Unit, Value};
use crate::scene::{Device, Source};

/// A generator that is linked into the program.
pub struct GeneratorInfo {
    /// The name under which it is registered.
    pub name: &'static str,
    /// The path of its module.
    pub module: &'static str,
    /// The version of its crate.
    pub version: &'static str,
    /// Its documentation, in Markdown, without its drawing.
    pub docs: &'static str,
    /// The file of its drawing, from the folder of its crate.
    pub picture: Option<&'static str>,
    /// The parameters of its [`example`](GeneratorInfo::example) as Rust source, `RingParams::default()`; empty if there
    /// is none.
    pub example_source: &'static str,
    /// The template of the names of its cells in files, `snspd_W{wire_width}_P{wire_pitch}`, if it has one.
    pub cell_name: Option<&'static str>,
    rows: &'static [ParamSpec],
    defaults: fn() -> Vec<Option<Value>>,
    example: fn() -> Result<ParamValues>,
    record: fn(&ParamReader<'_>) -> Result<ParamValues>,
    build: fn(&ParamReader<'_>) -> Result<Device>,
    cached: bool,
}

/// A parameter of a generator.
#[derive(Debug, Clone, PartialEq)]
pub struct ParamInfo {
    /// The name under which it is registered.
    pub name: &'static str,
    /// Its documentation, in Markdown.
    pub docs: &'static str,
    /// The type of its values.
    pub kind: ParamType,
    /// The unit of its numbers, spelled as in `#[param(unit = …)]`.
    pub unit: Option<&'static str>,
    /// The range of its numbers.
    pub bounds: Bounds,
    /// Its value if none is given; `None` if it must be given.
    pub default: Option<Value>,
}

impl GeneratorInfo {
    #[doc(hidden)]
    #[must_use]
    pub const fn new<G: Generator>(
        name: &'static str,
        module: &'static str,
        version: &'static str,
        docs: &'static str,
        rows: &'static [ParamSpec],
    ) -> Self {
        Self {
            name,
            module,
            version,
            docs: docs.trim_ascii(),
            picture: None,
            example_source: "",
            cell_name: None,
            rows,
            defaults: G::defaults,
            example: || Ok(G::example()?.record()),
            record: |from| Ok(G::read(from)?.record()),
            build: |from| G::read(from)?.build(),
            cached: true,
        }
    }

    #[doc(hidden)]
    #[must_use]
    pub const fn pictured(self, file: &'static str) -> Self {
        Self { picture: Some(file), ..self }
    }

    #[doc(hidden)]
    #[must_use]
    pub const fn naming_cells(self, template: &'static str) -> Self {
        Self { cell_name: Some(template), ..self }
    }

    #[doc(hidden)]
    #[must_use]
    pub const fn called(self, example: &'static str) -> Self {
        Self { example_source: example, ..self }
    }

    #[doc(hidden)]
    #[must_use]
    pub const fn uncached(self) -> Self {
        Self { cached: false, ..self }
    }

    /// Whether its cells are kept in the cache: unless it says `#[device(no_cache)]`.
    #[must_use]
    pub fn is_cached(&self) -> bool {
        self.cached
    }

    /// The parameters, in the generator's order.
    #[must_use]
    pub fn params(&self) -> Vec<ParamInfo> {
        let info = |(row, default): (&ParamSpec, _)| ParamInfo {
            name: row.name(),
            docs: row.docs(),
            kind: row.param_type(),
            unit: (row.unit() != Unit::NONE).then_some(row.unit().name()),
            bounds: row.bounds(),
            default,
        };
        self.rows.iter().zip((self.defaults)()).map(info).collect()
    }

    /// The parameters with which galleries and tests draw it: those of `#[device(example = …)]`, or the defaults.
    ///
    /// # Errors
    /// [`ParamError`](crate::error::ParamError) if a parameter has no default and no example was given, and what the
    /// example says.
    pub fn example(&self) -> Result<ParamValues> {
        (self.example)()
    }

    /// Every parameter of a call with these ones, the others at their defaults: checked, but not drawn. (A parameter
    /// that is a device is drawn.)
    ///
    /// # Errors
    /// [`Error::Unknown`](crate::Error::Unknown) for a parameter that is not there,
    /// [`ParamError`](crate::error::ParamError) for one that is missing, of another type or out of its bounds.
    pub fn record(&'static self, params: &BTreeMap<String, Value>) -> Result<ParamValues> {
        let record = (self.record)(&ParamReader::new(self, params)?)?;
        self.check_bounds(&record)?;
        Ok(record)
    }

    /// The cell with these parameters, the others at their defaults.
    ///
    /// # Errors
    /// As for [`GeneratorInfo::record`], and what the generator says.
    pub fn build(&'static self, params: &BTreeMap<String, Value>) -> Result<Device> {
        (self.build)(&ParamReader::new(self, params)?)
    }

    /// The registered names of the parameters.
    pub(super) fn names(&self) -> impl Iterator<Item = &'static str> {
        self.rows.iter().map(ParamSpec::name)
    }

    pub(super) fn row(&self, index: usize) -> &'static ParamSpec {
        &self.rows[index]
    }

    /// The rules of the generator, for functions beside its body. The body itself finds them under the name `check`.
    #[must_use]
    pub fn check(&self) -> Check<'static> {
        Check::of(self.name, self.rows)
    }

    /// What a cell records that was drawn with these parameters.
    pub(super) fn source(&self, params: ParamValues) -> Source {
        Source { generator: self.name, module: self.module, version: self.version, params }
    }

    /// Refuses a number that is out of its bounds or not finite.
    pub(super) fn check_bounds(&self, record: &ParamValues) -> Result<()> {
        for (row, (_, value)) in self.rows.iter().zip(record.iter()) {
            row.check(self.name, value)?;
        }
        Ok(())
    }
}

impl std::fmt::Debug for GeneratorInfo {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "GeneratorInfo({}::{})", self.module, self.name)
    }
}
