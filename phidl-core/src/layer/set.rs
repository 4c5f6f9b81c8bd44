//! [`LayerSet`]: the layers of a process, by name, with their colors and patterns.
//!
//! A set is an ordinary value, passed to the functions that draw pictures. PHIDL keeps a global table instead, in which a
//! refused layer, or a copy without a color, replaces the intended one.

use indexmap::IndexMap;

use super::{Color, Layer};
use crate::error::{Error, ItemKind, Result};

/// A layer with its name and its appearance.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedLayer {
    /// The name, unique in its set.
    pub name: String,
    /// The numbers in the file.
    pub layer: Layer,
    /// Its purpose.
    pub description: String,
    /// Fill color in pictures; without one, pictures choose.
    pub color: Option<Color>,
    /// Opacity in pictures, 0 to 1.
    pub alpha: f64,
    /// Whether the drawn parts stay when the layer is written (a dark-field mask).
    pub inverted: bool,
    /// Name of a fill pattern for viewers that have them.
    pub dither: Option<String>,
}

impl NamedLayer {
    /// A layer of this name and numbers, without a color, 60 % opaque.
    #[must_use]
    pub fn new(name: impl Into<String>, layer: impl Into<Layer>) -> Self {
        Self {
            name: name.into(),
            layer: layer.into(),
            description: String::new(),
            color: None,
            alpha: 0.6,
            inverted: false,
            dither: None,
        }
    }

    /// The same with a fill color.
    #[must_use]
    pub fn color(self, color: Color) -> Self {
        Self { color: Some(color), ..self }
    }

    /// The same with another opacity in pictures, from 0 to 1.
    #[must_use]
    pub fn alpha(self, alpha: f64) -> Self {
        Self { alpha, ..self }
    }

    /// The same with a fill pattern of a viewer.
    #[must_use]
    pub fn dither(self, dither: impl Into<String>) -> Self {
        Self { dither: Some(dither.into()), ..self }
    }

    /// The same as a dark-field layer.
    #[must_use]
    pub fn inverted(self) -> Self {
        Self { inverted: true, ..self }
    }

    /// The same with a description.
    #[must_use]
    pub fn description(self, description: impl Into<String>) -> Self {
        Self { description: description.into(), ..self }
    }
}

/// Named layers in the order in which they were added.
///
/// ```
/// # use phidl_core::layer::{Color, LayerSet, NamedLayer};
/// let mut set = LayerSet::new();
/// set.add(NamedLayer::new("nb", 5).color("gold".parse()?))?;
/// assert_eq!(set.get("nb")?.layer.number, 5);
/// assert!(set.get("au").is_err());
/// # Ok::<(), phidl_core::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LayerSet {
    layers: IndexMap<String, NamedLayer>,
}

impl LayerSet {
    /// A set without layers.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a layer at the end.
    ///
    /// # Errors
    /// [`Error::Duplicate`] if the name is taken, [`Error::Invalid`] if the opacity is not between 0 and 1.
    pub fn add(&mut self, layer: NamedLayer) -> Result<&mut Self> {
        if self.layers.contains_key(&layer.name) {
            return Err(Error::Duplicate {
                device: "layer set".into(),
                kind: ItemKind::Layer,
                name: layer.name.into(),
            });
        }
        if !(0.0..=1.0).contains(&layer.alpha) {
            let problem =
                format!("the alpha of the layer \"{}\" is {}, but it must be from 0 to 1", layer.name, layer.alpha);
            return Err(Error::invalid("layer set", problem));
        }
        self.layers.insert(layer.name.clone(), layer);
        Ok(self)
    }

    /// The layer of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that are there.
    pub fn get(&self, name: &str) -> Result<&NamedLayer> {
        self.layers.get(name).ok_or_else(|| Error::Unknown {
            owner: "layer set".into(),
            kind: ItemKind::Layer,
            name: name.into(),
            known: self.layers.keys().cloned().collect(),
        })
    }

    /// The first layer with these numbers.
    #[must_use]
    pub fn find(&self, layer: Layer) -> Option<&NamedLayer> {
        self.iter().find(|named| named.layer == layer)
    }

    /// The layers, in the order in which they were added.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &NamedLayer> {
        self.layers.values()
    }

    /// The number of layers.
    #[must_use]
    pub fn len(&self) -> usize {
        self.layers.len()
    }

    /// Whether there is no layer.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.layers.is_empty()
    }
}

impl std::ops::Index<&str> for LayerSet {
    type Output = NamedLayer;

    /// The layer of this name.
    ///
    /// # Panics
    /// If there is none; [`LayerSet::get`] returns an error instead.
    fn index(&self, name: &str) -> &NamedLayer {
        match self.get(name) {
            Ok(layer) => layer,
            Err(error) => panic!("{error}"),
        }
    }
}

impl std::fmt::Display for LayerSet {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let layers: Vec<String> = self.iter().map(|named| format!("{} {}", named.name, named.layer)).collect();
        write!(f, "LayerSet ({})", layers.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_are_reached_by_name_and_listed() {
        let mut set = LayerSet::new();
        set.add(NamedLayer::new("au", 1).alpha(0.2).dither("I5").inverted())
            .unwrap()
            .add(NamedLayer::new("nb", (2, 1)))
            .unwrap();
        assert_eq!((set["nb"].layer, set["au"].alpha, set.len()), (Layer::new(2, 1), 0.2, 2));
        assert_eq!(set.to_string(), "LayerSet (au 1/0, nb 2/1)");
        assert_eq!(set.get("ua").unwrap_err().to_string(), "layer set: there is no layer \"ua\"; known are au, nb");
    }

    #[test]
    fn a_refused_layer_changes_nothing() {
        let mut set = LayerSet::new();
        set.add(NamedLayer::new("au", 1)).unwrap();
        assert!(matches!(set.add(NamedLayer::new("au", 2)), Err(Error::Duplicate { .. })));
        let glassy = NamedLayer { alpha: 1.5, ..NamedLayer::new("nb", 3) };
        assert!(set.add(glassy).is_err());
        assert_eq!(set.iter().map(|l| l.layer.number).collect::<Vec<_>>(), [1]);
    }
}
