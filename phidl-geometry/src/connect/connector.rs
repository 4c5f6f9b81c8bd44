//! [`connector`].

use phidl_core::prelude::*;
use phidl_macros::device;

/// Makes two ports back to back without any polygon: an adapter between two cells, or the start of a chain.
///
/// # Ports
/// `1` at `midpoint`, facing `orientation`, and `2` at the same position, facing the opposite direction; both `width` wide.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let start = pg::connector((10, 5), 2, 30)?;
/// let mut wire = pg::straight((2, 40), 1)?.place();
/// wire.connect("1", start.port("2")?)?;
/// assert_eq!(wire.port("1")?.orientation(), 30.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `connector`.
#[device(picture = "docs/connector.svg")]
pub fn connector(
    /// Where both ports are.
    #[default((0, 0))]
    #[param(unit = "um")]
    midpoint: Point,
    /// Width of both ports.
    #[default(1.0)]
    #[param(unit = "um", min = 0.0)]
    width: f64,
    /// Direction that port `1` faces.
    #[default(0.0)]
    #[param(unit = "deg")]
    orientation: f64,
) -> Result<Device> {
    let port = Port::new(midpoint, width, orientation);
    let mut d = Device::builder("connector");
    let back = port.flipped();
    d.add_port("1", port)?;
    d.add_port("2", back)?;
    d.build()
}
