//! The style of figures: colors that can be told apart on white and on black.

use phidl_core::prelude::*;

use crate::svg::FigureOptions;

/// By layer and datatype number, over and over.
const COLORS: [&str; 10] =
    ["#4a86c8", "#e2803b", "#3ea675", "#cf5468", "#8f6bc4", "#c9a227", "#2c9fae", "#b0698f", "#7f8c3b", "#6f7f8f"];
/// Opacity: shapes below stay visible, and lines of one pixel too.
const ALPHA: f64 = 0.85;

/// Gives every layer of a device a color, above the layers that have one.
///
/// # Errors
/// Never for the colors of this table; the layer set refuses names that it has.
pub fn add_layers(set: &mut LayerSet, device: &Device) -> Result<()> {
    for layer in device.layers() {
        if set.find(layer).is_none() {
            let color = COLORS[(usize::from(layer.number) + usize::from(layer.datatype)) % COLORS.len()];
            set.add(NamedLayer { alpha: ALPHA, ..NamedLayer::new(layer.to_string(), layer).color(color.parse()?) })?;
        }
    }
    Ok(())
}

/// How figures of the documentation are drawn.
///
/// # Errors
/// As for [`add_layers`].
pub fn figure_options(device: &Device) -> Result<FigureOptions> {
    let mut layers = LayerSet::new();
    add_layers(&mut layers, device)?;
    Ok(FigureOptions { layers, ..FigureOptions::default() })
}
