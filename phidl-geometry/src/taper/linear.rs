//! Linear changes of width: [`taper`] on both sides of a line, [`ramp`] on one.

use phidl_core::prelude::*;
use phidl_macros::device;

/// Width of a taper without `width1` and `port` (µm).
const DEFAULT_WIDTH: f64 = 5.0;

/// Draws a straight wire whose width changes linearly.
///
/// It lies along x, from (0, 0) to (`length`, 0), symmetric about the axis.
///
/// With `port`, the taper starts at that port, facing it.
///
/// # Ports
/// `1` at the start, `width1` wide, facing 180°; `2` at the end, `width2` wide, facing 0°.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let t = pg::taper(20, 3, 0.5, 1)?;
/// assert_eq!(t.port("2")?.width(), 0.5);
/// let on = pg::TaperParams::default().width2(2).port(Port::new((3, 4), 7, 90)).build()?;
/// assert_eq!(on.port("1")?.width(), 7.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `taper`.
#[device(picture = "docs/taper.svg", example = TaperParams::default().width2(1))]
pub fn taper(
    /// Length.
    #[default(10.0)]
    #[param(unit = "um", min = 0.0)]
    length: f64,
    /// Width at the start; without one, that of `port`, or 5 µm.
    #[default(None)]
    #[param(unit = "um", min = 0.0)]
    width1: Option<f64>,
    /// Width at the end; without one, that at the start.
    #[default(None)]
    #[param(unit = "um", min = 0.0)]
    width2: Option<f64>,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
    /// Where it starts.
    #[default(None)]
    #[param(named)]
    port: Option<Port>,
) -> Result<Device> {
    let width1 = width1.or(port.as_ref().map(Port::width)).unwrap_or(DEFAULT_WIDTH);
    let width2 = width2.unwrap_or(width1);
    let (start, end) = (width1 / 2.0, width2 / 2.0);

    let mut d = Device::builder("taper");
    d.add_polygon([(0.0, start), (length, end), (length, -end), (0.0, -start)], layer)?;
    d.add_port("1", ((0, 0), width1, 180))?;
    d.add_port("2", ((length, 0), width2, 0))?;
    if let Some(port) = port {
        d.rotate(.., port.orientation()).move_by(.., port.midpoint());
    }
    d.build()
}

/// Draws a straight wire with a flat lower edge whose width changes linearly.
///
/// It lies along x, with its lower edge from (0, 0) to (`length`, 0).
///
/// # Ports
/// `1` in the middle of the start, `width1` wide, facing 180°; `2` in the middle of the end, `width2` wide, facing 0°.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let r = pg::ramp(10, 5, 8, 1)?;
/// assert_eq!(r.port("2")?.midpoint(), Point::new(10.0, 4.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `ramp`.
#[device(picture = "docs/ramp.svg")]
pub fn ramp(
    /// Length.
    #[default(10.0)]
    #[param(unit = "um", min = 0.0)]
    length: f64,
    /// Width at the start.
    #[default(5.0)]
    #[param(unit = "um", min = 0.0)]
    width1: f64,
    /// Width at the end; without one, that at the start.
    #[default(8.0)]
    #[param(unit = "um", min = 0.0)]
    width2: Option<f64>,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let width2 = width2.unwrap_or(width1);
    let mut d = Device::builder("ramp");
    d.add_polygon([(0.0, width1), (length, width2), (length, 0.0), (0.0, 0.0)], layer)?;
    d.add_port("1", ((0.0, width1 / 2.0), width1, 180))?;
    d.add_port("2", ((length, width2 / 2.0), width2, 0))?;
    d.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_without_a_second_width_is_a_rectangle() {
        let r = ramp(10, 5, None, 0).unwrap();
        assert_eq!(r.bbox(), Some(Rect::new((0, 0), (10, 5))));
        assert_eq!(r.area(), 50.0);
    }

    #[test]
    fn the_ports_of_a_ramp_are_its_upright_edges() {
        let r = ramp(10, 2, 6, 0).unwrap();
        assert_eq!(r.port("1").unwrap().endpoints(), (Point::new(0.0, 0.0), Point::new(0.0, 2.0)));
        assert_eq!(r.port("2").unwrap().endpoints(), (Point::new(10.0, 6.0), Point::new(10.0, 0.0)));
    }
}
