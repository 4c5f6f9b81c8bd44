//! What a layer looks like: as a set says, or else in PHIDL's colors.

use phidl_core::layer::{Color, Layer, LayerSet};

/// Colors of layers without one, by layer number; those of PHIDL's viewer.
const PALETTE: [Color; 12] = [
    color(0x3d, 0xcc, 0x5c),
    color(0x2b, 0x0f, 0xff),
    color(0xcc, 0x3d, 0x3d),
    color(0xe5, 0xdd, 0x45),
    color(0x7b, 0x3d, 0xcc),
    color(0xcc, 0x86, 0x0c),
    color(0x73, 0xff, 0x0f),
    color(0x2d, 0xcc, 0xb4),
    color(0xff, 0x0f, 0xa3),
    color(0x0e, 0xc2, 0xe6),
    color(0x3d, 0x87, 0xcc),
    color(0xe5, 0x52, 0x0e),
];

/// Opacity of layers that are in no set.
const ALPHA: f64 = 0.6;

const fn color(red: u8, green: u8, blue: u8) -> Color {
    Color { red, green, blue }
}

/// The color of a layer that has none of its own.
pub(crate) fn palette(layer: Layer) -> Color {
    PALETTE[usize::from(layer.number) % PALETTE.len()]
}

/// Color and opacity of a layer.
pub(super) fn looks(layer: Layer, set: &LayerSet) -> (Color, f64) {
    let named = set.find(layer);
    let color = named.and_then(|named| named.color).unwrap_or_else(|| palette(layer));
    (color, named.map_or(ALPHA, |named| named.alpha))
}
