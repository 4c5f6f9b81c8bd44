//! [`compass_multi`].

use std::collections::BTreeMap;

use phidl_core::num::count::linspace;
use phidl_core::prelude::*;
use phidl_macros::device;

use crate::basic::rectangle;

/// The sides in the order in which their ports are added, with the directions that they look to.
const SIDES: [(&str, f64); 4] = [("N", 90.0), ("S", 270.0), ("E", 0.0), ("W", 180.0)];

/// Draws a rectangle around the origin with several ports on each side.
///
/// The rectangle is a reference to one [`rectangle`](fn@rectangle).
///
/// # Ports
/// On every side in `ports`, the given number: equal widths that together fill the side, facing outwards. Their names are
/// the side and a number, counted to the right (`N1`, `N2`, …, `S1`, …) or upwards (`E1`, …, `W1`, …).
///
/// # Errors
/// `ports` names another side than `N`, `S`, `E`, `W`.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let pad = pg::compass_multi((40, 20), [("N", 4), ("W", 1)], 1)?;
/// assert_eq!((pad.port("N1")?.midpoint(), pad.port("N1")?.width()), (Point::new(-15.0, 10.0), 10.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `compass_multi`.
#[device(picture = "docs/compass_multi.svg")]
pub fn compass_multi(
    /// Width and height.
    #[default((4, 2))]
    #[param(unit = "um", min = 0.0)]
    size: Size,
    /// How many ports there are on a side.
    #[default([("N", 3), ("S", 4)])]
    #[param(min = 1, max = 1000000)]
    ports: BTreeMap<String, usize>,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    for side in ports.keys() {
        let known = SIDES.iter().any(|(name, _)| name == side);
        check.that("ports", format_args!("a map with the side {side:?}"), known, "have no sides but N, S, E, W")?;
    }
    let mut d = Device::builder("compass_multi");
    d.add(rectangle(size, layer)?.place().moved_by((-size.width / 2.0, -size.height / 2.0)));
    for (side, orientation) in SIDES {
        let count = ports.get(side).copied().unwrap_or_default();
        for (i, port) in side_ports(size, orientation, count).enumerate() {
            d.add_port(format!("{side}{}", i + 1), port)?;
        }
    }
    d.build()
}

/// Ports that share the side which looks to `orientation`, from left to right or upwards.
fn side_ports(size: Size, orientation: f64, count: usize) -> impl Iterator<Item = Port> {
    let level = orientation == 90.0 || orientation == 270.0;
    let along = if level { size.width } else { size.height };
    let width = along / count as f64;
    let last = (along - width) / 2.0;
    let out = Point::polar(1.0, orientation);
    linspace(-last, last, count).map(move |at| {
        let midpoint = if level { (at, out.y * size.height / 2.0) } else { (out.x * size.width / 2.0, at) };
        Port::new(midpoint, width, orientation)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_port_on_every_side_makes_a_compass() {
        let multi = compass_multi((4, 2), SIDES.map(|(side, _)| (side, 1)), 0).unwrap();
        let compass = crate::connect::compass((4, 2), 0).unwrap();
        for port in compass.ports() {
            let ours = multi.port(&format!("{}1", port.name())).unwrap();
            let all = |port: &Port| (port.midpoint(), port.width(), port.orientation());
            assert_eq!(all(ours), all(port));
        }
    }

    #[test]
    fn sides_that_a_rectangle_does_not_have_and_sides_without_ports_are_refused() {
        let error = compass_multi((4, 2), [("n", 1)], 0).unwrap_err().to_string();
        assert_eq!(
            error,
            "compass_multi: ports is a map with the side \"n\", but it must have no sides but N, S, E, W"
        );
        let error = compass_multi((4, 2), [("N", 0)], 0).unwrap_err().to_string();
        assert_eq!(error, "compass_multi: ports[\"N\"] is 0, but it must be at least 1");
    }
}
