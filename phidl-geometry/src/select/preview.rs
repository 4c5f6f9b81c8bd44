//! [`preview_layerset`]: a sample of every layer.

use phidl_core::num::count;
use phidl_core::param::{ConversionError, Param, ParamType};
use phidl_core::prelude::*;
use phidl_macros::device;

use crate::basic::rectangle;
use crate::text::{Justify, text};

/// The layers of a [`LayerSet`] by name, for a preview; in JSON an object of names and layers.
#[derive(Debug, Clone, PartialEq)]
pub struct SampleLayers(Vec<(String, Layer)>);

impl SampleLayers {
    /// Sorted by layer; layers of equal numbers by name.
    fn new(mut layers: Vec<(String, Layer)>) -> Self {
        layers.sort_by(|a, b| a.1.cmp(&b.1).then_with(|| a.0.cmp(&b.0)));
        Self(layers)
    }
}

impl From<&LayerSet> for SampleLayers {
    fn from(set: &LayerSet) -> Self {
        Self::new(set.iter().map(|named| (named.name.clone(), named.layer)).collect())
    }
}

impl From<LayerSet> for SampleLayers {
    fn from(set: LayerSet) -> Self {
        (&set).into()
    }
}

impl<N: Into<String>, L: Into<Layer>, const M: usize> From<[(N, L); M]> for SampleLayers {
    fn from(layers: [(N, L); M]) -> Self {
        Self::new(layers.into_iter().map(|(name, layer)| (name.into(), layer.into())).collect())
    }
}

impl Param for SampleLayers {
    fn param_type() -> ParamType {
        ParamType::Map(Box::new(ParamType::Layer))
    }

    fn to_value(&self) -> Value {
        Value::Map(self.0.iter().map(|(name, layer)| (name.clone(), (*layer).into())).collect())
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let layers = std::collections::BTreeMap::<String, Layer>::from_value(value)?;
        Ok(Self::new(layers.into_iter().collect()))
    }
}

/// Draws a square on every layer of a set, with the layer's name and numbers below, in rows from the top left.
///
/// ```text
///   ┌──────┐  ┌──────┐
///   │      │  │      │   size
///   └──────┘  └──────┘
///     gold      pads     name
///    1 / 0     2 / 5     layer / datatype
/// ```
///
/// The layers are sorted by their numbers. The first square has its lower left corner at the origin.
///
/// # Ports
/// None.
///
/// # Numerics
/// `⌈√n⌉` columns; with `c = size / 100`, squares of `100 c` at a pitch of `(100 + spacing) c`. So the spacing is in
/// hundredths of the size.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let mut set = LayerSet::new();
/// set.add(NamedLayer::new("gold", 1))?.add(NamedLayer::new("pads", (2, 5)))?;
/// let samples = pg::preview_layerset(&set, 100, 100)?;
/// assert_eq!(samples.layers(), [Layer::new(1, 0), Layer::new(2, 5)]);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `preview_layerset`.
#[device(picture = "docs/preview_layerset.svg", example = PreviewLayersetParams::new([("gold", (1, 0)), ("pads", (2, 5)), ("via", (3, 0))]))]
pub fn preview_layerset(
    /// The layers.
    ls: SampleLayers,
    /// Side of a square.
    #[default(100)]
    #[param(unit = "um", above = 0)]
    size: f64,
    /// Between two squares, in hundredths of `size`.
    #[default(100)]
    #[param(min = 0)]
    spacing: f64,
) -> Result<Device> {
    let scale = size / 100.0;
    let columns = count::up((ls.0.len() as f64).sqrt()).max(1);
    let pitch = (100.0 + spacing) * scale;
    let mut d = Device::builder("layerset");
    for (n, (name, layer)) in ls.0.iter().enumerate() {
        let at = Point::new(pitch * (n % columns) as f64, -pitch * (n / columns) as f64);
        d.add(rectangle((100.0 * scale, 100.0 * scale), *layer)?.place().moved_by(at));
        let caption = format!("{name}\n{} / {}", layer.number, layer.datatype);
        let text = text(caption, 20.0 * scale, Justify::Center, *layer, "DEPLOF")?;
        d.add(text.place().moved_by((50.0 * scale, -20.0 * scale)).moved_by(at));
    }
    d.build()
}
