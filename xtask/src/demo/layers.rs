//! The layers of the demo process.

use phidl_core::prelude::*;

/// Silicon waveguides.
pub(crate) const WAVEGUIDE: Layer = Layer::new(1, 0);
/// Superconducting nanowires.
pub(crate) const NANOWIRE: Layer = Layer::new(2, 0);
/// Gold pads.
pub(crate) const PAD: Layer = Layer::new(3, 0);
/// Alignment marks, in the first metal.
pub(crate) const MARK: Layer = Layer::new(4, 0);
/// Dots of growing size for the exposure dose.
pub(crate) const DOSE: Layer = Layer::new(5, 1);
/// Names of devices; not on the mask.
pub(crate) const NAME: Layer = Layer::new(10, 0);
/// Edge of the die.
pub(crate) const FRAME: Layer = Layer::new(99, 0);

/// All layers with names and colors.
pub(crate) fn layer_set() -> Result<LayerSet> {
    let mut set = LayerSet::new();
    for (name, layer, color, description) in [
        ("waveguide", WAVEGUIDE, "royalblue", "220 nm silicon, fully etched"),
        ("nanowire", NANOWIRE, "crimson", "7 nm niobium nitride"),
        ("pad", PAD, "goldenrod", "50 nm gold, lift-off"),
        ("mark", MARK, "darkslategray", "alignment marks"),
        ("dose", DOSE, "mediumorchid", "exposure dose test"),
        ("name", NAME, "dimgray", "names of devices, not on the mask"),
        ("frame", FRAME, "black", "edge of the die"),
    ] {
        set.add(NamedLayer::new(name, layer).color(color.parse()?).description(description))?;
    }
    Ok(set)
}
