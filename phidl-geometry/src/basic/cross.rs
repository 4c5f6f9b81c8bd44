//! [`cross`].

use phidl_core::prelude::*;
use phidl_macros::device;

use super::rectangle;

/// Draws a cross of two equal bars around the origin: an alignment mark.
///
/// The bars are two references to one [`rectangle`](fn@rectangle) and overlap in the middle.
///
/// # Ports
/// None.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let mark = pg::cross(10, 3, 1)?;
/// assert_eq!(mark.size(), Size::new(10.0, 10.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `cross`.
#[device(picture = "docs/cross.svg")]
pub fn cross(
    /// Length of both bars.
    #[default(10.0)]
    #[param(unit = "um")]
    length: f64,
    /// Width of both bars.
    #[default(3.0)]
    #[param(unit = "um")]
    width: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let bar = rectangle((width, length), layer)?;
    let mut d = Device::builder("cross");
    if !bar.is_empty() {
        d.add(bar.place().rotated(90).centered((0, 0)));
        d.add(bar.place().centered((0, 0)));
    }
    d.build()
}
