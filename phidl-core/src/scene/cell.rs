//! [`Cell`]: what a cell holds, open or finished.

use indexmap::IndexMap;
use rustc_hash::FxBuildHasher;
use std::collections::BTreeMap;

use super::outlines::Outlines;
use super::{Label, Reference, Source};
use crate::error::{Error, Noun, Result};
use crate::geom::{Rect, Transform};
use crate::param::Value;
use crate::place::{Bounded, Transformable};
use crate::port::Port;

/// Things with names, in the order in which they were added. Names come from the program itself: nobody makes them collide.
pub(crate) type ByName<T> = IndexMap<String, T, FxBuildHasher>;

/// The content of a cell. The builder edits it; the device shares it and adds what it remembers about it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cell {
    pub(crate) name: String,
    pub(crate) outlines: Outlines,
    pub(crate) references: Vec<Reference>,
    pub(crate) labels: Vec<Label>,
    pub(crate) ports: ByName<Port>,
    /// Alias → place in `references`.
    pub(crate) aliases: ByName<usize>,
    pub(crate) info: BTreeMap<String, Value>,
    pub(crate) source: Option<Source>,
}

impl Cell {
    pub(crate) fn port(&self, name: &str) -> Result<&Port> {
        self.ports.get(name).ok_or_else(|| self.unknown(Noun::Port, name, self.ports.keys()))
    }

    /// The place of the reference with this alias.
    pub(crate) fn alias(&self, alias: &str) -> Result<usize> {
        self.aliases.get(alias).copied().ok_or_else(|| self.unknown(Noun::Alias, alias, self.aliases.keys()))
    }

    pub(crate) fn bbox(&self) -> Option<Rect> {
        let references = self.references.iter().map(Bounded::bbox);
        Rect::union_all(references.chain([self.outlines.bbox()]))
    }

    pub(crate) fn transform_mut(&mut self, by: &Transform) {
        let matrix = by.matrix();
        self.outlines.all_points_mut().iter_mut().for_each(|p| *p = matrix.apply(*p));
        self.references.iter_mut().for_each(|reference| reference.transform_mut(by));
        self.labels.iter_mut().for_each(|label| label.transform_mut(by));
        self.ports.values_mut().for_each(|port| port.transform_mut(by));
    }

    pub(crate) fn unknown<'a>(&self, kind: Noun, name: &str, known: impl Iterator<Item = &'a String>) -> Error {
        Error::Unknown { owner: self.name.as_str().into(), kind, name: name.into(), known: known.cloned().collect() }
    }
}
