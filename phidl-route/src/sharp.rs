//! [`route_sharp`].

use phidl_core::prelude::*;
use phidl_macros::device;
use phidl_path::Path;

use crate::draw::{RouteDrawing, overlaps};
use crate::path_type::{WaypointRule, turns};
use crate::port_pair::PortPair;
use crate::{PathType, RouteWidth};

/// Draws a wire between two ports, with mitered corners.
///
/// ```text
///            ┌──────┐
///   port1 ├──┘      │
///                   ┴ port2
/// ```
///
/// The legs of a Manhattan route have room for two widths of the wider port.
///
/// # Ports
/// `1` on `port1` and `2` on `port2`, facing them, as wide as the route is there, with their info. With a cross-section:
/// those of its sections.
///
/// # Info
/// `length` (µm), `bends`, and `smallest_radius`: 0 µm, or null without a corner. A Manhattan route that has no room for
/// its fewest corners takes more, as in PHIDL, and then records `detour` (µm beyond the ports) and `detour_reason`.
///
/// # Errors
/// The route must leave `port1` forwards and enter `port2` from the front. A length that the path type does not have, a
/// layer beside a cross-section, and ports of width 0 without a `width` are refused. A wire that overlaps itself, because a
/// leg is too short for its width or a corner turns by more than 168.5°, is refused, and a wire that runs over itself unless
/// `allow_crossings` is set.
///
/// # Numerics
/// Without a `width`, the width changes from that of `port1` to that of `port2` in proportion to the length, along all
/// legs.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{PathType, route_sharp};
/// let wire = route_sharp(((0, 0), 2, 0), ((30, 20), 4, 270), None, PathType::Manhattan, 0)?;
/// assert_eq!(wire.polygons().next().unwrap().points.len(), 6);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `route_sharp`.
#[device(picture = "docs/route_sharp.svg", example = RouteSharpParams::new(((0, 0), 2, 0), ((30, -20), 4, 270)))]
pub fn route_sharp(
    /// Where it starts.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// Width: a number, a pair from start to end, or a cross-section; none for those of the ports.
    #[default(None)]
    #[param(unit = "um")]
    width: Option<RouteWidth>,
    /// The shape of the route.
    #[default(PathType::Manhattan)]
    path_type: PathType,
    /// Where it is drawn; to be left out with a cross-section, whose sections have layers of their own.
    #[default(0)]
    layer: Layers,
    /// The waypoints of a manual route, from port to port.
    #[default(None)]
    #[param(unit = "um", named)]
    manual_path: Option<Vec<Point>>,
    /// Length of the first leg of a U, J (200 if not given), C or Z (100).
    #[default(None)]
    #[param(unit = "um", named)]
    length1: Option<f64>,
    /// Length of the last leg of a J (200 if not given), C or Z (100).
    #[default(None)]
    #[param(unit = "um", named)]
    length2: Option<f64>,
    /// First side step of a C to the left (100 if not given); to the right if negative.
    #[default(None)]
    #[param(unit = "um", named)]
    left1: Option<f64>,
    /// Whether the wire may run over itself.
    #[default(false)]
    #[param(named)]
    allow_crossings: bool,
) -> Result<Device> {
    const NAME: &str = "route_sharp";
    let pair = PortPair::new(NAME, &port1, &port2)?;
    let radius = port1.width().max(port2.width());
    let manual_path = manual_path.as_deref();
    let rule = WaypointRule { what: NAME, path_type, manual_path, length1, length2, left1, radius };
    let (points, detour) = rule.points(&pair)?;
    let bends = turns(&points).len();
    let drawing = RouteDrawing {
        what: NAME,
        path: &Path::from_points(points)?,
        finer: None,
        layer: &layer,
        width: width.as_ref(),
        bends,
        smallest_radius: (bends > 0).then_some(0.0),
        overlaps: overlaps(allow_crossings),
    };
    let mut d = drawing.between_ports(&pair)?;
    detour.iter().for_each(|detour| detour.record(&mut d));
    d.build()
}
