//! [`Layers`]: the layers that an element is drawn on.

use std::sync::Arc;

use super::{Layer, LayerSet, NamedLayer};

/// One layer, several, or none: what every shape takes for `layer`.
///
/// ```
/// # use phidl_core::layer::{Layer, Layers};
/// assert_eq!(Layers::from(7), Layers::from((7, 0)));
/// assert_eq!(Layers::from([(1, 0), (3, 5)]).iter().count(), 2);
/// assert!(Layers::NONE.is_empty());
/// ```
///
/// For layers of several types, see [`layers!`](crate::layers). Several layers keep their order; a layer given twice counts once. A shape on several layers draws one copy on each,
/// and on none it draws nothing but still has its ports.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Layers(Inner);

#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum Inner {
    /// By far the most common case, without an allocation.
    One(Layer),
    /// None, or at least two different ones.
    Several(Arc<[Layer]>),
    None,
}

impl Layers {
    /// No layer: nothing is drawn.
    pub const NONE: Self = Self(Inner::None);

    /// Exactly one layer.
    #[must_use]
    pub const fn one(layer: Layer) -> Self {
        Self(Inner::One(layer))
    }

    /// The layers, in the order in which they were given.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Layer> + '_ {
        self.as_slice().iter().copied()
    }

    /// The layers as a list.
    #[must_use]
    pub fn as_slice(&self) -> &[Layer] {
        match &self.0 {
            Inner::One(layer) => std::slice::from_ref(layer),
            Inner::Several(layers) => layers,
            Inner::None => &[],
        }
    }

    /// The layer, if it is exactly one.
    #[must_use]
    pub fn single(&self) -> Option<Layer> {
        match self.0 {
            Inner::One(layer) => Some(layer),
            _ => None,
        }
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        matches!(self.0, Inner::None)
    }

    /// Whether a layer is among them.
    #[must_use]
    pub fn contains(&self, layer: impl Into<Layer>) -> bool {
        self.as_slice().contains(&layer.into())
    }
}

impl Default for Layers {
    /// Layer 0, the default of every shape.
    fn default() -> Self {
        Self::one(Layer::default())
    }
}

impl std::fmt::Debug for Layers {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}

impl std::fmt::Display for Layers {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.0 {
            Inner::One(layer) => layer.fmt(f),
            Inner::None => f.write_str("no layer"),
            Inner::Several(layers) => {
                let names: Vec<String> = layers.iter().map(ToString::to_string).collect();
                write!(f, "{{{}}}", names.join(", "))
            }
        }
    }
}

impl<L: Into<Layer>> FromIterator<L> for Layers {
    fn from_iter<I: IntoIterator<Item = L>>(layers: I) -> Self {
        let mut distinct: Vec<Layer> = Vec::new();
        for layer in layers {
            let layer = layer.into();
            if !distinct.contains(&layer) {
                distinct.push(layer);
            }
        }
        match distinct[..] {
            [] => Self::NONE,
            [layer] => Self::one(layer),
            _ => Self(Inner::Several(distinct.into())),
        }
    }
}

impl From<u16> for Layers {
    fn from(number: u16) -> Self {
        Self::one(number.into())
    }
}

impl From<(u16, u16)> for Layers {
    fn from(pair: (u16, u16)) -> Self {
        Self::one(pair.into())
    }
}

impl From<Layer> for Layers {
    fn from(layer: Layer) -> Self {
        Self::one(layer)
    }
}

impl From<Option<Layer>> for Layers {
    fn from(layer: Option<Layer>) -> Self {
        layer.map_or(Self::NONE, Self::one)
    }
}

impl From<&NamedLayer> for Layers {
    fn from(named: &NamedLayer) -> Self {
        Self::one(named.layer)
    }
}

impl From<&LayerSet> for Layers {
    fn from(set: &LayerSet) -> Self {
        set.iter().map(|named| named.layer).collect()
    }
}

impl From<&Layers> for Layers {
    fn from(layers: &Layers) -> Self {
        layers.clone()
    }
}

impl<L: Into<Layer>, const N: usize> From<[L; N]> for Layers {
    fn from(layers: [L; N]) -> Self {
        layers.into_iter().collect()
    }
}

impl<L: Into<Layer>> From<Vec<L>> for Layers {
    fn from(layers: Vec<L>) -> Self {
        layers.into_iter().collect()
    }
}

impl From<&[Layer]> for Layers {
    fn from(layers: &[Layer]) -> Self {
        layers.iter().copied().collect()
    }
}

/// [`Layers`] of numbers, pairs and named layers together.
///
/// ```
/// use phidl_core::prelude::*;
/// let layers = layers![7, 8, (9, 25)];
/// assert_eq!(layers.to_string(), "{7/0, 8/0, 9/25}");
/// ```
#[macro_export]
macro_rules! layers {
    ($($layer:expr),* $(,)?) => {
        <$crate::layer::Layers as ::std::iter::FromIterator<$crate::layer::Layer>>::from_iter([
            $($crate::layer::Layer::from($layer)),*
        ])
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_pairs_and_lists_are_layers() {
        assert_eq!(Layers::from([1, 2, 1]).as_slice(), [Layer::new(1, 0), Layer::new(2, 0)]);
        assert_eq!(Layers::from([(3, 5)]), Layers::from((3, 5)));
        assert_eq!(Layers::from(Vec::<Layer>::new()), Layers::NONE);
        assert_eq!(Layers::from([1, 2]).to_string(), "{1/0, 2/0}");
    }

    #[test]
    fn numbers_pairs_and_named_layers_stand_in_one_list() {
        let gold = NamedLayer::new("gold", (4, 2));
        assert_eq!(layers![7, (9, 25), &gold].as_slice(), [Layer::new(7, 0), Layer::new(9, 25), Layer::new(4, 2)]);
        assert_eq!(layers![], Layers::NONE);
        assert_eq!(Layer::try_from(7_i32).unwrap(), Layer::new(7, 0));
        let error = Layer::try_from(-1_i32).unwrap_err().to_string();
        assert_eq!(error, "layer: the number is -1, but it must be from 0 to 65535");
    }

    #[test]
    fn several_layers_have_no_single_layer() {
        assert_eq!(Layers::from(4).single(), Some(Layer::new(4, 0)));
        assert_eq!(Layers::from([4, 5]).single(), None);
        assert!(Layers::from([4, 5]).contains(5) && !Layers::from([4, 5]).contains((5, 1)));
    }
}
