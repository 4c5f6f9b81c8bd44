//! [`Cell`]: what a cell holds, open or finished.

use std::collections::BTreeMap;

use smol_str::SmolStr;

use super::named_list::{Named, NamedList};
use super::polygon_store::PolygonStore;
use super::{Label, Reference, Source};
use crate::error::{Error, ItemKind, Result};
use crate::geom::{Rect, Transform};
use crate::param::Value;
use crate::place::{Bounded, Transformable};
use crate::port::Port;

/// The content of a cell. The builder edits it; the device shares it and adds what it remembers about it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Cell {
    pub(crate) name: SmolStr,
    pub(crate) polygons: PolygonStore,
    pub(crate) references: Vec<Reference>,
    pub(crate) labels: Vec<Label>,
    pub(crate) ports: NamedList<Port>,
    pub(crate) aliases: NamedList<Alias>,
    pub(crate) info: BTreeMap<String, Value>,
    pub(crate) source: Option<Source>,
}

/// A name for a reference.
#[derive(Debug, Clone)]
pub(crate) struct Alias {
    pub(crate) name: SmolStr,
    /// The index in `references`.
    pub(crate) index: usize,
}

impl Named for Alias {
    fn name(&self) -> &SmolStr {
        &self.name
    }
}

impl Cell {
    pub(crate) fn port(&self, name: &str) -> Result<&Port> {
        self.ports.get(name).ok_or_else(|| self.unknown(ItemKind::Port, name, self.ports.names()))
    }

    /// The index of the reference with this alias.
    pub(crate) fn alias(&self, alias: &str) -> Result<usize> {
        let found = self.aliases.get(alias).map(|alias| alias.index);
        found.ok_or_else(|| self.unknown(ItemKind::Alias, alias, self.aliases.names()))
    }

    pub(crate) fn bbox(&self) -> Option<Rect> {
        let references = self.references.iter().map(Bounded::bbox);
        Rect::union_all(references.chain([self.polygons.bbox()]))
    }

    pub(crate) fn transform_mut(&mut self, by: &Transform) {
        let matrix = by.matrix();
        self.polygons.all_points_mut().iter_mut().for_each(|p| *p = matrix.apply(*p));
        self.references.iter_mut().for_each(|reference| reference.transform_mut(by));
        self.labels.iter_mut().for_each(|label| label.transform_mut(by));
        self.ports.iter_mut().for_each(|port| port.transform_mut(by));
    }

    pub(crate) fn unknown<'a>(&self, kind: ItemKind, name: &str, known: impl Iterator<Item = &'a str>) -> Error {
        let known = known.map(str::to_owned).collect();
        Error::Unknown { owner: self.name.as_str().into(), kind, name: name.into(), known }
    }
}
