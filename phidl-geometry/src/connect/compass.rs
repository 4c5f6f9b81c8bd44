//! [`compass`].

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::basic::rectangle;

/// Draws a rectangle around the origin with a port on each side.
///
/// The rectangle is a reference to one [`rectangle`](fn@rectangle).
///
/// # Ports
/// `N`, `S`, `E`, `W` in the middle of the sides, as wide as these, facing outwards.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let pad = pg::compass((4, 2), 1)?;
/// assert_eq!((pad.port("E")?.midpoint(), pad.port("E")?.width()), (Point::new(2.0, 0.0), 2.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `compass`.
#[device(picture = "docs/compass.svg")]
pub fn compass(
    /// Width and height.
    #[default((4, 2))]
    #[param(unit = "um", min = 0.0)]
    size: Size,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let (x, y) = (size.width / 2.0, size.height / 2.0);
    let mut d = Device::builder("compass");
    d.add(rectangle(size, layer)?.place().moved_by((-x, -y)));
    d.add_port("N", ((0, y), size.width, 90))?;
    d.add_port("S", ((0, -y), size.width, 270))?;
    d.add_port("E", ((x, 0), size.height, 0))?;
    d.add_port("W", ((-x, 0), size.height, 180))?;
    d.build()
}
