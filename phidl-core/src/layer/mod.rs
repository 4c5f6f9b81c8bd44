//! Layers: one ([`Layer`]), several or none ([`Layers`]), and the named, colored [`LayerSet`].

mod color;
mod key;
mod layers;
mod set;

pub use color::Color;
pub use key::Layer;
pub use layers::Layers;
pub use set::{LayerSet, NamedLayer};
