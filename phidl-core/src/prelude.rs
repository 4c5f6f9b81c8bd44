//! The names that a layout program needs: `use phidl_core::prelude::*;`.

pub use crate::error::{Error, Result};
pub use crate::geom::{Outline, Point, Rect, Size, Transform};
pub use crate::layer::{Color, Layer, LayerSet, Layers, NamedLayer};
pub use crate::layers;
pub use crate::param::{Check, Value};
pub use crate::place::{Align, Bounded, Direction, Edge, Movable, Transformable};
pub use crate::port::Port;
pub use crate::runtime::{Generator, Partial};
pub use crate::scene::{
    Anchor, Array, Device, DeviceBuilder, Element, Group, Key, Label, LabelKey, LayerTarget, Polygon, PolygonKey,
    Properties, Reference, ReferenceKey, Selection,
};
pub use std::f64::consts::{PI, TAU};
