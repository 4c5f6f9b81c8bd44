//! Parts of a layout: cells below a cell, some layers, layers with other numbers.

use std::str::FromStr;

use phidl_core::layer::Layer;

use crate::error::{IoError, Result};
use crate::model::{Cell, Layout, Polygons};

/// Which layers are kept, and their numbers in the result.
///
/// ```
/// use phidl_core::layer::Layer;
/// use phidl_io::layout::LayerMap;
/// let map: LayerMap = "1/0, 3, 2/0=10/5".parse()?;
/// assert_eq!(map.get(Layer::new(1, 0)), Some(Layer::new(1, 0)));
/// assert_eq!(map.get(Layer::new(3, 7)), Some(Layer::new(3, 7)));
/// assert_eq!(map.get(Layer::new(2, 0)), Some(Layer::new(10, 5)));
/// assert_eq!(map.get(Layer::new(2, 1)), None);
/// # Ok::<(), phidl_io::IoError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LayerMap(Vec<Rule>);

#[derive(Debug, Clone, PartialEq, Eq)]
struct Rule {
    number: u16,
    /// `None` stands for all datatypes.
    datatype: Option<u16>,
    to: Option<Layer>,
}

impl LayerMap {
    /// The layer in the result; `None` if it is left out. The first rule that fits counts.
    #[must_use]
    pub fn get(&self, layer: Layer) -> Option<Layer> {
        let fits = |rule: &&Rule| rule.number == layer.number && rule.datatype.is_none_or(|d| d == layer.datatype);
        self.0.iter().find(fits).map(|rule| rule.to.unwrap_or(layer))
    }
}

impl FromStr for LayerMap {
    type Err = IoError;

    /// Reads `1/0,2/0`, `3` or `3/*` (all datatypes), `1/0=10/0` (another number).
    fn from_str(text: &str) -> Result<Self> {
        let rules: Option<Vec<Rule>> = text.split(',').map(|part| Rule::parse(part.trim())).collect();
        let wrong = || IoError::option("layers", format_args!("{text:?}"), "be a list such as 1/0,3,4/*,2/0=10/0");
        rules.map(Self).ok_or_else(wrong)
    }
}

impl Rule {
    fn parse(text: &str) -> Option<Self> {
        let (from, to) = match text.split_once('=') {
            Some((from, to)) => (from.trim(), Some(layer(to.trim())?)),
            None => (text, None),
        };
        let (number, datatype) = match from.split_once('/') {
            Some((number, "*")) => (number, None),
            Some((number, datatype)) => (number, Some(datatype.parse().ok()?)),
            None => (from, None),
        };
        Some(Self { number: number.parse().ok()?, datatype, to })
    }
}

fn layer(text: &str) -> Option<Layer> {
    let (number, datatype) = text.split_once('/').unwrap_or((text, "0"));
    Some(Layer::new(number.parse().ok()?, datatype.parse().ok()?))
}

/// Keeps a cell and the cells below it.
pub(super) fn keep_below(layout: &mut Layout, top: usize) {
    let definitions = layout.definitions();
    let mut kept = vec![false; layout.cells.len()];
    let mut open = vec![top];
    while let Some(cell) = open.pop() {
        if std::mem::replace(&mut kept[cell], true) {
            continue;
        }
        let children = layout.cells[cell].placements.iter().filter_map(|p| definitions[p.child.index()]);
        open.extend(children.filter(|child| !kept[*child]));
    }
    let mut kept = kept.into_iter();
    layout.cells.retain(|_| kept.next().unwrap_or(false));
}

/// Keeps some layers and gives them their new numbers. Returns how many elements were left out.
pub(super) fn keep_layers(layout: &mut Layout, map: &LayerMap) -> u64 {
    layout.cells.iter_mut().map(|cell| keep_in_cell(cell, map)).sum()
}

fn keep_in_cell(cell: &mut Cell, map: &LayerMap) -> u64 {
    let before = count(cell);
    let mut polygons = Polygons::default();
    for polygon in cell.polygons.iter() {
        if let Some(layer) = map.get(polygon.layer) {
            polygons.push(layer, polygon.corners.iter().copied());
            if let Some(properties) = polygon.properties {
                polygons.set_properties(properties.clone());
            }
        }
    }
    cell.polygons = polygons;
    let keep = |layer: &mut Layer| match map.get(*layer) {
        Some(to) => {
            *layer = to;
            true
        }
        None => false,
    };
    cell.paths.retain_mut(|path| keep(&mut path.layer));
    cell.boxes.retain_mut(|element| keep(&mut element.layer));
    cell.nodes.retain_mut(|node| keep(&mut node.layer));
    cell.texts.retain_mut(|text| keep(&mut text.layer));
    before - count(cell)
}

fn count(cell: &Cell) -> u64 {
    (cell.polygons.len() + cell.paths.len() + cell.boxes.len() + cell.nodes.len() + cell.texts.len()) as u64
}
