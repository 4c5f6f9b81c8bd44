//! [`Cell`]: what a cell holds, open or finished.

use std::collections::BTreeMap;
use std::sync::Arc;

use indexmap::IndexMap;

use super::outlines::Outlines;
use super::{Label, Reference, Source};
use crate::error::{Error, Noun, Result};
use crate::geom::{Rect, Transform};
use crate::param::Value;
use crate::place::{Bounded, Transformable};
use crate::port::Port;

/// The content of a cell. The builder edits it; the device shares it and adds what it remembers about it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cell {
    pub(crate) name: String,
    pub(crate) outlines: Outlines,
    pub(crate) references: Vec<Reference>,
    pub(crate) labels: Vec<Label>,
    pub(crate) ports: IndexMap<String, Port>,
    /// Alias → place in `references`.
    pub(crate) aliases: IndexMap<String, usize>,
    pub(crate) info: BTreeMap<String, Value>,
    pub(crate) source: Option<Arc<Source>>,
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
