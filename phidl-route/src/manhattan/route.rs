//! [`route_manhattan`] and [`route_manhattan_auto`]: wires at right angles.

use phidl_core::param::Param as _;
use phidl_core::prelude::*;
use phidl_macros::device;
use phidl_path::{Overlaps, Path};

use super::RouteBend;
use super::footprint::Footprint;
use super::router::{Allowed, RoutedPath, Router};
use crate::draw::RouteDrawing;
use crate::path_type::turns;
use crate::port_pair::{PortPair, micrometers, title};
use crate::width::{RouteWidth, wire_width};

/// Overlap of two routes that is accepted as rounding (µm).
const NOISE: f64 = 1e-6;

/// Draws a wire of straight pieces and bends between two ports that are turned by a multiple of 90° against each other.
///
/// ```text
///            ╭──────╮
///   port1 ├──╯      │        as wide as port1
///                   ┴ port2
/// ```
///
/// The waypoints are those of [`path_manhattan`](super::path_manhattan) with the room that the bends need. Where the drawn
/// wire would overlap itself or the keep-out behind a port (as wide as the port and as long as a bend extends), it is the
/// shortest clear line of up to six corners.
///
/// # Ports
/// `1` on `port1` and `2` on `port2`, facing them, as wide as the wire there. With a cross-section they are as wide as the
/// given ports, and the ports of the sections are added.
///
/// # Info
/// `length` (µm); `bends`; `smallest_radius` (µm; null without a bend), which is `radius`; `crossings`, the number of pairs of
/// its straight pieces and bends that overlap, and `over_ports`, the number of keep-outs that it overlaps: both 0 unless
/// `allow_crossings` is set. A detour records `detour` (µm beyond the ports) and `detour_reason`.
///
/// # Errors
/// The ports must be at right angles to each other (to 0.0005°) and equally wide unless a `width` is given, and the radius at
/// least half the width. A detour is refused unless `allow_detour` is set: a route with more corners than the ports call
/// for, because its bends have no room. A wire that runs over itself or over a keep-out is refused unless `allow_crossings`
/// is set. Errors name both ports and the missing length.
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
#[device(picture = "docs/route_manhattan.svg", example = RouteManhattanParams::new(((0, 0), 2, 0), ((80, -30), 2, 0)).allow_detour(true))]
pub fn route_manhattan(
    /// Where it starts.
    port1: Port,
    /// Where it ends.
    port2: Port,
    /// The bends.
    #[default(RouteBend::Circular)]
    bend: RouteBend,
    /// Smallest radius of the bends, on the centerline.
    #[default(20.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Where it is drawn; to be left out with a cross-section, whose sections have layers of their own.
    #[default(0)]
    layer: Layers,
    /// Width: a number, a pair from start to end, or a cross-section; that of both ports if not given.
    #[default(None)]
    #[param(unit = "um", named)]
    width: Option<RouteWidth>,
    /// Whether the route may take more corners than the ports call for.
    #[default(false)]
    #[param(named)]
    allow_detour: bool,
    /// Whether the wire may run over itself and over what lies behind the ports.
    #[default(false)]
    #[param(named)]
    allow_crossings: bool,
) -> Result<Device> {
    let pair = PortPair::new("route_manhattan", &port1, &port2)?;
    let wire = ManhattanWire { pair: &pair, bend, radius, width: width.as_ref(), layer: &layer };
    let route = wire.router()?.route()?;
    route.check(&pair, Allowed { detour: allow_detour, crossings: allow_crossings })?;
    wire.draw(&route)?.build()
}

impl RouteManhattanParams {
    /// The centerline of the route, with bends at the corners.
    ///
    /// # Errors
    /// As for [`route_manhattan`](fn@route_manhattan).
    pub fn centerline(&self) -> Result<Path> {
        let pair = PortPair::new("route_manhattan", &self.port1, &self.port2)?;
        let (bend, radius, width) = (self.bend, self.radius, self.width.as_ref());
        let route = ManhattanWire { pair: &pair, bend, radius, width, layer: &self.layer }.router()?.route()?;
        route.check(&pair, Allowed { detour: self.allow_detour, crossings: self.allow_crossings })?;
        Path::smooth(route.points, radius, bend)
    }
}

/// Draws wires between pairs of ports, the first to the second, the third to the fourth, each as
/// [`route_manhattan`](fn@route_manhattan) draws it.
///
/// Every pair is routed independently: a wire does not go around another one, so it does not move when a pair is added. The
/// drawn wires are then checked against each other.
///
/// # Ports
/// `1`, `2`, `3`, …: one on each of the ports, in their order, facing it.
///
/// # Info
/// `length`, `bends`, `crossings` and `over_ports`, of all routes together, and `smallest_radius`.
///
/// # Errors
/// The number of ports must be even. Routes that overlap are refused with the ports of both and the depth of the overlap,
/// unless `allow_crossings` is set. The error of a single route is the error of all.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_route::{RouteBend, route_manhattan_auto};
/// let ports = [((0, 0), 2, 0), ((90, 50), 2, 180), ((0, -10), 2, 0), ((90, 20), 2, 180)];
/// let error = route_manhattan_auto(ports, RouteBend::Circular, 10, 1).unwrap_err();
/// assert!(error.to_string().contains("overlaps the route from"));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL 1.5's `route_manhattan_auto`, which draws crossings silently.
#[device(picture = "docs/route_manhattan_auto.svg", example = RouteManhattanAutoParams::new([((0, 0), 2, 0), ((90, 50), 2, 180), ((0, -60), 2, 0), ((90, -90), 2, 90)]))]
pub fn route_manhattan_auto(
    /// The ports, an even number of them.
    ports: Vec<Port>,
    /// The bends.
    #[default(RouteBend::Circular)]
    bend: RouteBend,
    /// Radius of the bends, as in a single route.
    #[default(20.0)]
    #[param(unit = "um", above = 0.0)]
    radius: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
    /// Width of all wires: a number, a pair from start to end, or a cross-section; that of the ports if not given.
    #[default(None)]
    #[param(unit = "um", named)]
    width: Option<RouteWidth>,
    /// Whether routes may take more corners than their ports call for.
    #[default(false)]
    #[param(named)]
    allow_detour: bool,
    /// Whether wires may run over each other, over themselves and over what lies behind their ports.
    #[default(false)]
    #[param(named)]
    allow_crossings: bool,
) -> Result<Device> {
    const NAME: &str = "route_manhattan_auto";
    let (pairs, rest) = ports.as_chunks::<2>();
    if !rest.is_empty() {
        let given = if ports.len() == 1 { "1 port is".to_owned() } else { format!("{} ports are", ports.len()) };
        return Err(Error::custom(NAME, format!("ports are joined in pairs, but {given} given")));
    }
    if !allow_crossings {
        check_distances(pairs, bend, radius, width.as_ref(), allow_detour)?;
    }
    let mut d = Device::builder(NAME);
    let (mut length, mut smallest, mut counts) = (0.0, None, [("bends", 0), ("crossings", 0), ("over_ports", 0)]);
    for (pair, [port1, port2]) in pairs.iter().enumerate() {
        let params = RouteManhattanParams::new(port1, port2).bend(bend).radius(radius).layer(&layer);
        let params = params.width(width.clone()).allow_detour(allow_detour).allow_crossings(allow_crossings);
        let route = params.build()?;
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
/// let path = manhattan_centerline(((0, 0), 2, 0), ((80, -60), 2, 0), RouteBend::Gradual, 10)?;
/// let wavy = path.extrude(&CrossSection::from(Section::new(|t: f64| 1.0 + 0.2 * (60.0 * t).sin())))?;
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Errors
/// As for [`route_manhattan`](fn@route_manhattan) without detours and crossings, which [`RouteManhattanParams::centerline`]
/// may allow. The width is that of the wider port.
pub fn manhattan_centerline(
    port1: impl Into<Port>,
    port2: impl Into<Port>,
    bend: RouteBend,
    radius: impl Into<f64>,
) -> Result<Path> {
    let (port1, port2, radius) = (port1.into(), port2.into(), radius.into());
    let pair = PortPair::new("manhattan_centerline", &port1, &port2)?;
    let width = port1.width().max(port2.width());
    let route = Router::new(&pair, bend, radius, width)?.route()?;
    route.check(&pair, Allowed::default())?;
    Path::smooth(route.points, radius, bend)
}

/// A wire before it is routed: its ports, bends and width.
#[derive(Clone, Copy)]
pub(crate) struct ManhattanWire<'a> {
    pub(crate) pair: &'a PortPair<'a>,
    pub(crate) bend: RouteBend,
    pub(crate) radius: f64,
    pub(crate) width: Option<&'a RouteWidth>,
    pub(crate) layer: &'a Layers,
}

impl<'a> ManhattanWire<'a> {
    pub(crate) fn router(&self) -> Result<Router<'a>> {
        Router::new(self.pair, self.bend, self.radius, wire_width(self.pair, self.width)?)
    }

    /// Refuses a radius at which the inner edge of a bend would overlap itself.
    pub(crate) fn check_radius(&self) -> Result<()> {
        self.pair.check_room("the radius", self.radius, wire_width(self.pair, self.width)? / 2.0)
    }

    /// The wire along a route, with bends at the corners.
    pub(crate) fn draw(&self, route: &RoutedPath) -> Result<DeviceBuilder> {
        let bends = turns(&route.points).len();
        if bends > 0 {
            self.check_radius()?;
        }
        let as_ports = RouteWidth::Constant(self.pair.port1.width());
        let drawing = RouteDrawing {
            what: self.pair.what(),
            path: &Path::smooth(&route.points, self.radius, self.bend)?,
            finer: None,
            layer: self.layer,
            width: Some(self.width.unwrap_or(&as_ports)),
            bends,
            smallest_radius: (bends > 0).then_some(self.radius),
            // The router has looked for crossings.
            overlaps: Overlaps::Refuse,
        };
        let mut d = drawing.between_ports(self.pair)?;
        self.add_missing_ports(&mut d)?;
        d.info("crossings", route.crossings).info("over_ports", route.over_ports);
        route.detour.iter().for_each(|detour| detour.record(&mut d));
        Ok(d)
    }

    /// With a cross-section, adds the ports `1` and `2` unless a section has them.
    fn add_missing_ports(&self, d: &mut DeviceBuilder) -> Result<()> {
        for (name, port) in [("1", self.pair.port1), ("2", self.pair.port2)] {
            if d.port(name).is_err() {
                d.add_port(name, port.flipped())?;
            }
        }
        Ok(())
    }
}

/// Refuses routes that overlap.
fn check_distances(
    pairs: &[[Port; 2]],
    bend: RouteBend,
    radius: f64,
    width: Option<&RouteWidth>,
    allow_detour: bool,
) -> Result<()> {
    const NAME: &str = "route_manhattan_auto";
    let layer = Layers::default();
    let mut wires: Vec<(&[Port; 2], Vec<Footprint>)> = Vec::with_capacity(pairs.len());
    for ports in pairs {
        let pair = PortPair::new(NAME, &ports[0], &ports[1])?;
        let mut router = ManhattanWire { pair: &pair, bend, radius, width, layer: &layer }.router()?;
        let route = router.route()?;
        route.check(&pair, Allowed { detour: allow_detour, crossings: false })?;
        let footprints = router.footprints(&route.points)?;
        for (other, before) in &wires {
            let depths = footprints.iter().flat_map(|footprint| before.iter().map(|other| footprint.depth(other)));
            let depth = depths.fold(0.0, f64::max);
            if depth > NOISE {
                return Err(pair.error(format_args!(
                    "it overlaps the route from {} to {} by {}",
                    title("a port", &other[0]),
                    title("a port", &other[1]),
                    micrometers(depth)
                )));
            }
        }
        wires.push((ports, footprints));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_path::{CrossSection, Section};

    #[test]
    fn pairs_are_joined_in_their_order() {
        let ports = [((0, 0), 2, 0), ((90, 50), 2, 180), ((0, -60), 3, 0), ((90, -90), 3, 90)];
        let d = route_manhattan_auto(ports, RouteBend::Circular, 10, 1).unwrap();
        assert_eq!(d.references().len(), 2);
        let port = |name: &str| d.port(name).map(|p| (p.midpoint(), p.width(), p.orientation())).unwrap();
        assert_eq!(port("3"), (Point::new(0.0, -60.0), 3.0, 180.0));
        assert_eq!(port("4"), (Point::new(90.0, -90.0), 3.0, 270.0));
        assert_eq!(d.info()["bends"].as_f64(), Some(3.0));
    }

    #[test]
    fn routes_that_overlap_are_refused_unless_allowed() {
        let ports: Vec<Port> =
            [(0, 0, 0), (60, 0, 180), (30, 30, 270), (30, -30, 90)].map(|(x, y, o)| Port::new((x, y), 2, o)).into();
        let error = route_manhattan_auto(ports.clone(), RouteBend::Circular, 10, 1).unwrap_err();
        assert!(error.to_string().contains("it overlaps the route from a port at (0, 0)"));
        assert!(error.to_string().ends_with("by 2 µm"), "{error}");
        let params = RouteManhattanAutoParams::new(ports).allow_crossings(true);
        assert_eq!(params.build().unwrap().references().len(), 2);
    }

    #[test]
    fn a_pair_is_routed_independently() {
        // The second wire could pass below the first, but it is the one that it would be without the first.
        let ports: [Port; 4] =
            [(0, 0, 0), (90, 50, 180), (0, -10, 0), (90, 20, 180)].map(|(x, y, o)| Port::new((x, y), 2, o));
        let both = RouteManhattanAutoParams::new(ports.to_vec()).radius(10).allow_crossings(true).build().unwrap();
        let alone = RouteManhattanParams::new(&ports[2], &ports[3]).radius(10).allow_crossings(true).build().unwrap();
        let second = &both.references()[1];
        assert!(second.device().same_cell(&alone));
    }

    #[test]
    fn drawn_wires_are_compared_and_not_their_waypoints() {
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
        assert!(error.to_string().ends_with("ports are joined in pairs, but 1 port is given"));
    }

    #[test]
    fn wires_too_wide_for_their_bends_are_refused() {
        let to = |width: i32| route_manhattan(((0, 0), width, 0), ((50, 50), width, 270), RouteBend::Circular, 5, 0);
        assert!(to(10).is_ok());
        let error = to(11).unwrap_err().to_string();
        assert!(error.contains("the radius is 5 µm, but must be at least 5.5 µm: 0.5 µm are"), "{error}");
    }

    #[test]
    fn detours_crossings_and_changes_of_width_are_refused_unless_allowed() {
        // Two ports of couplers, 25 µm aside, where two Euler bends of 10 µm need 37.6 µm.
        let coupler =
            || RouteManhattanParams::new(((0, 0), 1, 0), ((80, 25), 1, 180)).radius(10).bend(RouteBend::Euler);
        let error = coupler().build().unwrap_err().to_string();
        assert!(
            error.contains("two bends need 37.60") && error.contains("`allow_detour` draws a route of 4 bends"),
            "{error}"
        );
        let detour = coupler().allow_detour(true).build().unwrap();
        assert!(detour.info()["detour"].as_f64().unwrap() > 37.0 && detour.info().contains_key("detour_reason"));
        assert!(manhattan_centerline(((0, 0), 1, 0), ((80, 25), 1, 180), RouteBend::Euler, 10).is_err());
        let narrow = || RouteManhattanParams::new(((0, 0), 0.5, 0), ((80, 60), 5, 180)).radius(10);
        assert!(
            narrow().build().unwrap_err().to_string().contains("port1 is 0.5 µm wide and port2 5 µm; give a `width`")
        );
        let taper = narrow().width((0.5, 5)).build().unwrap();
        assert_eq!([taper.port("1").unwrap().width(), taper.port("2").unwrap().width()], [0.5, 5.0]);
        let close = || RouteManhattanParams::new(((0, 0), 1, 0), ((1, 1), 1, 270)).radius(5).allow_detour(true);
        assert!(close().build().is_err() && close().allow_crossings(true).build().is_ok());
    }

    #[test]
    fn cross_sections_keep_their_distance_to_themselves_and_to_others() {
        let guide = CrossSection::new()
            .add(Section::new(0.5).layer(1).ports("in", "out").named("core"))
            .add(Section::new(3).right_of("core").layer(2))
            .add(Section::new(3).left_of("core").layer(2));
        let ports =
            |gap: f64| [((0., 0.), 0.5, 0), ((90., 50.), 0.5, 180), ((0., -gap), 0.5, 0), ((90., 50. - gap), 0.5, 180)];
        let bus = |gap: f64| RouteManhattanAutoParams::new(ports(gap)).radius(10).width(&guide).build();
        let error = bus(6.0).unwrap_err().to_string();
        assert!(error.contains("it overlaps the route from"), "{error}");
        let one =
            RouteManhattanParams::new(((0, 0), 0.5, 0), ((90, 50), 0.5, 180)).radius(10).width(&guide).build().unwrap();
        assert_eq!(
            (one.port("in").unwrap().width(), one.port("2").unwrap().width(), one.polygons().len()),
            (0.5, 0.5, 3)
        );
        let tight = RouteManhattanParams::new(((0, 0), 0.5, 0), ((90, 50), 0.5, 180)).radius(3).width(&guide);
        assert!(tight.build().unwrap_err().to_string().contains("the radius is 3 µm, but must be at least 3.25 µm"));
    }
}
