//! [`route_manhattan`] and [`route_manhattan_auto`]: wires at right angles.

use phidl_core::param::Param as _;
use phidl_core::prelude::*;
use phidl_macros::device;
use phidl_path::Path;

use super::RouteBend;
use super::footprint::Footprint;
use super::router::{RoutedPath, Router};
use crate::draw::RouteDrawing;
use crate::path_type::turns;
use crate::port_pair::{PortPair, micrometers, refused, title};
use crate::width::RouteWidth;

/// Routes may lie on one another by this much (µm): rounding.
const NOISE: f64 = 1e-6;

/// Draws a wire of straight pieces and bends between two ports turned by a multiple of 90° against each other, wherever
/// they are.
///
/// ```text
///            ╭──────╮
///   port1 ├──╯      │        as wide as port1
///                   ┴ port2
/// ```
///
/// The waypoints are those of [`path_manhattan`](super::path_manhattan), with as much room as the bends need, wherever
/// the wire as it is drawn is clear of itself and of what lies behind the ports (taken for a footprint of wire as wide as the
/// port and as long as a bend reaches). Elsewhere it is the shortest clear way of up to six corners.
///
/// # Ports
/// `1` on `port1` and `2` on `port2`, facing them, as wide as `port1`.
///
/// # Info
/// `length` (µm); `bends`; `smallest_radius` (µm; null without a bend), which is `radius`; and 0 for a sound route:
/// `crossings`, how many pairs of its straight pieces and bends lie on one another, and `over_ports`, over how many of the
/// two ports' footprints it runs. They are more only where the ports are closer together than a few bends, so that there is no
/// way without.
///
/// # Errors
/// The ports must be at right angles to each other (to 0.0005°), the radius at least half the width, so that no inner
/// edge folds back.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{RouteBend, route_manhattan};
/// let wire = route_manhattan(((0, 0), 2, 0), ((80, -50), 2, 0), RouteBend::Euler, 10, 1)?;
/// assert_eq!(wire.info()["bends"].as_f64(), Some(2.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL 1.5's `route_manhattan` in parameters, ports and bends, but for the size of Euler
/// bends: see [`RouteBend::Euler`].
#[device(picture = "docs/route_manhattan.svg", example = RouteManhattanParams::new(((0, 0), 2, 0), ((80, -30), 2, 0)))]
pub fn route_manhattan(
    /// Where it starts; its width is that of the route.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// What is drawn at the corners.
    #[default(RouteBend::Circular)]
    bend: RouteBend,
    /// Smallest radius of the bends, on the centerline.
    #[default(20.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let pair = PortPair::new("route_manhattan", &port1, &port2)?;
    let routed = Router::new(&pair, bend, radius)?.route()?;
    draw_wire(&pair, &routed, bend, radius, &layer)?.build()
}

/// Draws wires between ports taken in pairs, the first to the second, the third to the fourth, each as
/// [`route_manhattan`](fn@route_manhattan) draws it.
///
/// Every pair is routed as if it were alone: a wire does not go around another one, so that it stays where it is when a
/// pair is added. What they do to one another is checked afterwards, as they are drawn.
///
/// # Ports
/// `1`, `2`, `3`, …: one on each of the ports, in their order, facing it.
///
/// # Info
/// `length`, `bends`, `crossings` and `over_ports`, of all routes together, and `smallest_radius`.
///
/// # Errors
/// The number of ports must be even. Routes that would run over one another are refused with the ports of both and by how
/// much they would have to be apart, unless `allow_crossings` is set. What refuses a single route refuses all.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{RouteBend, route_manhattan_auto};
/// let ports = [((0, 0), 2, 0), ((90, 50), 2, 180), ((0, -10), 2, 0), ((90, 20), 2, 180)];
/// let error = route_manhattan_auto(ports, RouteBend::Circular, 10, 1).unwrap_err();
/// assert!(error.to_string().contains("not run over the route from"));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL 1.5's `route_manhattan_auto`, which draws crossings without a word.
#[device(picture = "docs/route_manhattan_auto.svg", example = RouteManhattanAutoParams::new([((0, 0), 2, 0), ((90, 50), 2, 180), ((0, -60), 2, 0), ((90, -90), 2, 90)]))]
pub fn route_manhattan_auto(
    /// The ports, an even number of them.
    ports: Vec<Port>,
    /// What is drawn at the corners.
    #[default(RouteBend::Circular)]
    bend: RouteBend,
    /// Radius of the bends, as in a single route.
    #[default(20.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
    /// Whether routes may run over one another.
    #[default(false)]
    #[param(named)]
    allow_crossings: bool,
) -> Result<Device> {
    const NAME: &str = "route_manhattan_auto";
    let (pairs, rest) = ports.as_chunks::<2>();
    if !rest.is_empty() {
        return Err(refused(NAME, "ports", format_args!("{} ports", ports.len()), "be an even number of ports"));
    }
    if !allow_crossings {
        check_apart(pairs, bend, radius)?;
    }
    let mut d = Device::builder(NAME);
    let (mut length, mut smallest, mut counts) = (0.0, None, [("bends", 0), ("crossings", 0), ("over_ports", 0)]);
    for (pair, [port1, port2]) in pairs.iter().enumerate() {
        let route = route_manhattan(port1, port2, bend, radius, &layer)?;
        let recorded = |key: &str| route.info().get(key).and_then(Value::as_f64);
        length += recorded("length").unwrap_or_default();
        smallest = smallest.into_iter().chain(recorded("smallest_radius")).reduce(f64::min);
        for (key, count) in &mut counts {
            *count += route.info().get(*key).map_or(0, |v| i64::from_value(v).unwrap_or_default());
        }
        for (i, name) in ["1", "2"].into_iter().enumerate() {
            d.add_port((2 * pair + i + 1).to_string(), route.port(name)?)?;
        }
        d.add(route);
    }
    d.info("length", length).info("smallest_radius", smallest);
    for (key, count) in counts {
        d.info(key, count);
    }
    d.build()
}

/// The centerline of [`route_manhattan`](fn@route_manhattan), for an extrusion by hand.
///
/// ```
/// # use phidl_path::{CrossSection, Section};
/// # use phidl_route::{RouteBend, manhattan_centerline};
/// let path = manhattan_centerline(((0, 0), 2, 0), ((80, -30), 2, 0), RouteBend::Gradual, 10)?;
/// let wavy = path.extrude(&CrossSection::from(Section::new(|t: f64| 1.0 + 0.2 * (60.0 * t).sin())))?;
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Errors
/// As for [`route_manhattan`](fn@route_manhattan), but that nothing is said of a width.
pub fn manhattan_centerline(
    port1: impl Into<Port>,
    port2: impl Into<Port>,
    bend: RouteBend,
    radius: impl Into<f64>,
) -> Result<Path> {
    let (port1, port2, radius) = (port1.into(), port2.into(), radius.into());
    let pair = PortPair::new("manhattan_centerline", &port1, &port2)?;
    Path::smooth(Router::new(&pair, bend, radius)?.route()?.points, radius, bend)
}

/// Waypoints with bends at their corners, drawn as wide as the first port.
pub(crate) fn draw_wire(
    pair: &PortPair<'_>,
    routed: &RoutedPath,
    bend: RouteBend,
    radius: f64,
    layer: &Layers,
) -> Result<DeviceBuilder> {
    let bends = turns(&routed.points).len();
    if bends > 0 {
        // Beyond this the inner edge folds back.
        pair.check_room("a radius", radius, pair.port1.width() / 2.0)?;
    }
    let drawing = RouteDrawing {
        what: pair.what(),
        path: &Path::smooth(&routed.points, radius, bend)?,
        finer: None,
        layer,
        width: Some(&RouteWidth::Constant(pair.port1.width())),
        bends,
        smallest_radius: (bends > 0).then_some(radius),
    };
    let mut d = drawing.between_ports(pair)?;
    d.info("crossings", routed.crossings).info("over_ports", routed.over_ports);
    Ok(d)
}

/// Refuses routes that lie on one another.
fn check_apart(pairs: &[[Port; 2]], bend: RouteBend, radius: f64) -> Result<()> {
    const NAME: &str = "route_manhattan_auto";
    let mut wires: Vec<(&[Port; 2], Vec<Footprint>)> = Vec::with_capacity(pairs.len());
    for ports in pairs {
        let pair = PortPair::new(NAME, &ports[0], &ports[1])?;
        let mut router = Router::new(&pair, bend, radius)?;
        let points = router.route()?.points;
        let footprints = router.footprints(&points)?;
        for (other, before) in &wires {
            let depths = footprints.iter().flat_map(|footprint| before.iter().map(|other| footprint.depth(other)));
            let depth = depths.fold(0.0, f64::max);
            if depth > NOISE {
                let route = format!("not run over the route from {}", title("a port", &other[0]));
                let rule = format!("{route} to {}: {} are missing", title("one", &other[1]), micrometers(depth));
                return Err(pair.refused("over another one", rule));
            }
        }
        wires.push((ports, footprints));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_joined_in_their_order() {
        let ports = [((0, 0), 2, 0), ((90, 50), 2, 180), ((0, -60), 3, 0), ((90, -90), 2, 90)];
        let d = route_manhattan_auto(ports, RouteBend::Circular, 10, 1).unwrap();
        assert_eq!(d.references().len(), 2);
        let port = |name: &str| d.port(name).map(|p| (p.midpoint(), p.width(), p.orientation())).unwrap();
        assert_eq!(port("3"), (Point::new(0.0, -60.0), 3.0, 180.0));
        assert_eq!(port("4"), (Point::new(90.0, -90.0), 3.0, 270.0));
        assert_eq!(d.info()["bends"].as_f64(), Some(3.0));
    }

    #[test]
    fn routes_that_touch_are_refused_unless_told_otherwise() {
        let ports: Vec<Port> =
            [(0, 0, 0), (60, 0, 180), (30, 30, 270), (30, -30, 90)].map(|(x, y, o)| Port::new((x, y), 2, o)).into();
        let error = route_manhattan_auto(ports.clone(), RouteBend::Circular, 10, 1).unwrap_err();
        assert!(
            error.to_string().contains("over another one, but it must not run over the route from a port at (0, 0)")
        );
        assert!(error.to_string().ends_with("2 µm are missing"), "{error}");
        let params = RouteManhattanAutoParams::new(ports).allow_crossings(true);
        assert_eq!(params.build().unwrap().references().len(), 2);
    }

    #[test]
    fn a_pair_is_routed_as_if_it_were_alone() {
        // The second wire could pass below the first, but it is the one that it would be without the first.
        let ports: [Port; 4] =
            [(0, 0, 0), (90, 50, 180), (0, -10, 0), (90, 20, 180)].map(|(x, y, o)| Port::new((x, y), 2, o));
        let both = RouteManhattanAutoParams::new(ports.to_vec()).radius(10).allow_crossings(true).build().unwrap();
        let alone = RouteManhattanParams::new(&ports[2], &ports[3]).radius(10).build().unwrap();
        let second = &both.references()[1];
        assert!(second.device().same_cell(&alone));
    }

    #[test]
    fn wires_are_apart_as_they_are_drawn_and_not_as_their_way_points_are() {
        // Two nested corners: the waypoints are 3 µm apart and the bends nearly √2 times as much.
        let nested = |width: f64| {
            let ports = [((0, 0), width, 0), ((60, 60), width, 270), ((0, 3), width, 0), ((57, 60), width, 270)];
            route_manhattan_auto(ports, RouteBend::Circular, 20, 1)
        };
        assert!(nested(2.9).is_ok() && nested(3.1).is_err());
        // One wire ends in the corner that the bend of the other one cuts off.
        let ports = [((0, 0), 2, 0), ((60, 60), 2, 270), ((100, 2), 2, 180), ((56, 2), 2, 0)];
        assert!(route_manhattan_auto(ports, RouteBend::Circular, 20, 1).is_ok());
    }

    #[test]
    fn neighbors_that_touch_by_their_widths_only_are_refused_too() {
        let beside = |gap: f64| {
            let ports =
                [((0.0, 0.0), 2, 0), ((60.0, 0.0), 2, 180), ((0.0, 2.0 + gap), 2, 0), ((60.0, 2.0 + gap), 2, 180)];
            route_manhattan_auto(ports, RouteBend::Circular, 10, 1)
        };
        assert!(beside(0.0).is_ok() && beside(-0.01).is_err());
    }

    #[test]
    fn a_port_without_a_partner_is_refused() {
        let error = route_manhattan_auto([((0, 0), 2, 0)], RouteBend::Circular, 10, 1).unwrap_err();
        assert!(error.to_string().ends_with("ports is 1 ports, but it must be an even number of ports"));
    }

    #[test]
    fn wires_too_wide_for_their_bends_are_refused() {
        let to = |width: i32| route_manhattan(((0, 0), width, 0), ((50, 50), 1, 270), RouteBend::Circular, 5, 0);
        assert!(to(10).is_ok());
        let error = to(11).unwrap_err().to_string();
        assert!(error.contains("a radius of 5 µm, but it must have at least 5.5 µm: 0.5 µm are"), "{error}");
    }
}
