//! The layers of the process.

use phidl::prelude::*;

/// What stays as a waveguide: drawn, but not written by the beam.
pub const CORE: Layer = Layer::new(1, 0);
/// What is etched beside the waveguides.
pub const TRENCH: Layer = Layer::new(2, 0);
/// Squares that keep the density of the etch even.
pub const DUMMY: Layer = Layer::new(3, 0);
/// Names.
pub const NAME: Layer = Layer::new(4, 0);
/// Edge of the die; not on the mask.
pub const DIE: Layer = Layer::new(99, 0);

/// All of them with names and colors, for pictures.
pub fn layer_set() -> Result<LayerSet> {
    let mut set = LayerSet::new();
    for (name, layer, color) in [
        ("core", CORE, "royalblue"),
        ("trench", TRENCH, "lightsteelblue"),
        ("dummy", DUMMY, "silver"),
        ("name", NAME, "dimgray"),
        ("die", DIE, "black"),
    ] {
        set.add(NamedLayer::new(name, layer).color(color.parse()?))?;
    }
    Ok(set)
}
