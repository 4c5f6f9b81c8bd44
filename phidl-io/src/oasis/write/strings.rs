//! The strings of a file: texts, property names and property values, each once and numbered by their first use.

use std::collections::HashMap;

use phidl_core::scene::Properties;

use super::super::label;
use super::super::record::standard;
use super::options::EncodeOptions;
use crate::model::Layout;

/// Strings of one kind.
#[derive(Debug, Default)]
pub(super) struct Strings<'a> {
    numbers: HashMap<std::borrow::Cow<'a, str>, u64>,
    list: Vec<std::borrow::Cow<'a, str>>,
}

impl<'a> Strings<'a> {
    /// The number of a string, which is new or known.
    fn add(&mut self, string: impl Into<std::borrow::Cow<'a, str>>) -> u64 {
        let string = string.into();
        if let Some(number) = self.numbers.get(&string) {
            return *number;
        }
        let number = self.list.len() as u64;
        self.numbers.insert(string.clone(), number);
        self.list.push(string);
        number
    }

    /// The number of a string that was added.
    pub(super) fn number(&self, string: &str) -> u64 {
        *self.numbers.get(string).expect("invariant: all strings of a layout are added before it is written")
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &str> {
        self.list.iter().map(AsRef::as_ref)
    }
}

/// All strings of a layout.
#[derive(Debug, Default)]
pub(super) struct Tables<'a> {
    pub(super) texts: Strings<'a>,
    pub(super) property_names: Strings<'a>,
    pub(super) property_strings: Strings<'a>,
}

impl<'a> Tables<'a> {
    pub(super) fn of(layout: &'a Layout, tops: &'a [String]) -> Self {
        let mut tables = Self::default();
        for top in tops {
            tables.property_names.add(standard::TOP_CELL);
            tables.property_strings.add(top.as_str());
        }
        for cell in &layout.cells {
            for properties in cell.polygons.properties() {
                tables.add_properties(properties);
            }
            for text in &cell.texts {
                tables.texts.add(label::shown(text));
                if let Some(description) = label::describe(text) {
                    tables.property_names.add(label::NAME);
                    tables.property_strings.add(description);
                }
            }
            let properties = cell.texts.iter().map(|text| &text.properties);
            let properties = properties.chain(cell.paths.iter().map(|path| &path.properties));
            let properties = properties.chain(cell.boxes.iter().map(|element| &element.properties));
            let placed = cell.placements.iter().filter_map(|placement| placement.properties.as_deref());
            properties.chain(placed).for_each(|properties| tables.add_properties(properties));
        }
        tables
    }

    fn add_properties(&mut self, properties: &'a Properties) {
        for text in properties.values() {
            self.property_names.add(standard::GDS_PROPERTY);
            self.property_strings.add(text.as_str());
        }
    }

    /// Adds the names that the writer needs besides those of the layout.
    pub(super) fn add_standard(&mut self, options: &EncodeOptions) {
        self.property_names.add(standard::CELL_OFFSET);
        if options.bounding_boxes {
            self.property_names.add(standard::BOUNDING_BOXES_AVAILABLE);
            self.property_names.add(standard::BOUNDING_BOX);
        }
    }
}
