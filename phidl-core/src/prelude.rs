//! The words that a layout program needs: `use phidl_core::prelude::*;`.

pub use crate::error::{Error, Result};
pub use crate::geom::{Outline, Point, Rect, Size, Transform};
pub use crate::layer::{Color, Layer, LayerSet, Layers, NamedLayer};
pub use crate::param::{Check, Value};
pub use crate::place::{Arrange, Bounded, Direction, Edge, Place, Transformable};
pub use crate::port::Port;
pub use crate::runtime::{Generator, Recipe};
pub use crate::scene::{
    Affects, Anchor, Array, Device, DeviceBuilder, Element, Group, Key, Label, LabelKey, Members, Polygon, PolygonKey,
    Properties, Reference, ReferenceKey,
};
pub use std::f64::consts::{PI, TAU};
