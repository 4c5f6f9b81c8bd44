//! [`route_smooth`].

use phidl_core::prelude::*;
use phidl_macros::device;
use phidl_path::Path;

use crate::draw::{RouteDrawing, overlaps};
use crate::path_type::{WaypointRule, turns};
use crate::port_pair::{PortPair, refused};
use crate::{PathType, RouteWidth, SmoothOptions};

/// Draws a wire between two ports, with a bend at every corner.
///
/// ```text
///            ╭──────╮
///   port1 ├──╯      │
///                   ┴ port2
/// ```
///
/// # Ports
/// `1` on `port1` and `2` on `port2`, facing them, as wide as the route is there, with their info. With a cross-section:
/// those of its sections.
///
/// # Info
/// `length` (µm), `bends`, and `smallest_radius` (µm; null without a bend). By default this is about half of `radius`, which
/// is that of the arc with the same ends. A Manhattan route that has no room for its fewest corners takes more, as in
/// PHIDL, and then records `detour` (µm beyond the ports) and `detour_reason`.
///
/// # Errors
/// The route must leave `port1` forwards and enter `port2` from the front, and have room for its bends. A length that the
/// path type does not have, a layer beside a cross-section, and ports of width 0 without a `width` are refused. A Manhattan
/// route has room for bends as large as the arc of their radius; for others, set `use_eff`. A wire that overlaps itself at a
/// bend is refused with the radius and the width that would do, and a wire that runs over itself unless `allow_crossings`
/// is set.
///
/// # Numerics
/// Without a `width`, the width changes from that of `port1` to that of `port2` in proportion to the length. Edges are
/// miter offsets of the centerline; see [`Path::extrude`].
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{PathType, RouteSmoothParams, SmoothOptions, route_smooth};
/// let (a, b) = (Port::new((40, 0), 5, 180), Port::new((0, -40), 5, 270));
/// let wire = route_smooth(&a, &b, 5, None, PathType::Manhattan, 0)?;
/// let around = RouteSmoothParams::new(&a, &b).path_type(PathType::J).length1(60).length2(20).build()?;
/// let arcs = RouteSmoothParams::new(&a, &b).smooth_options(SmoothOptions::arc()).width((2.5, 1)).build()?;
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `route_smooth`.
#[device(picture = "docs/route_smooth.svg", example = RouteSmoothParams::new(((40, 0), 5, 180), ((0, -40), 5, 270)))]
pub fn route_smooth(
    /// Where it starts.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// Radius of the bends: of the arc with the same ends, unless `smooth_options` choose the smallest radius.
    #[default(5.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
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
    /// The bends.
    #[default(SmoothOptions::default())]
    #[param(named)]
    smooth_options: SmoothOptions,
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
    const NAME: &str = "route_smooth";
    if path_type == PathType::Manhattan && !smooth_options.is_as_large_as_its_arc() {
        let rule = "have use_eff on a Manhattan route, whose legs have room for the effective radius only";
        return Err(refused(NAME, "smooth_options", "an Euler bend by its smallest radius", rule));
    }
    let pair = PortPair::new(NAME, &port1, &port2)?;
    let manual_path = manual_path.as_deref();
    let rule = WaypointRule { what: NAME, path_type, manual_path, length1, length2, left1, radius };
    let (points, detour) = rule.points(&pair)?;
    let turns = turns(&points);
    let smooth = |options| {
        Path::smooth(&points, radius, options).map_err(|error| error.within(format!("the route {}", pair.between())))
    };
    let (path, finer) = (smooth(smooth_options)?, smooth_options.finer().map(smooth).transpose()?);
    let radii = turns.iter().map(|turn| smooth_options.smallest_radius(radius, *turn)).collect::<Result<Vec<_>>>()?;
    let drawing = RouteDrawing {
        what: NAME,
        path: &path,
        finer: finer.as_ref(),
        layer: &layer,
        width: width.as_ref(),
        bends: turns.len(),
        smallest_radius: radii.into_iter().reduce(f64::min),
        overlaps: overlaps(allow_crossings),
    };
    let mut d = drawing.between_ports(&pair)?;
    detour.iter().for_each(|detour| detour.record(&mut d));
    d.build()
}
