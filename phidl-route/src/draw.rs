//! From a centerline to a device: width, ports and info, shared by all routes.
//!
//! There is one convention for ports: they lie on the ports that are joined, face them, and are as wide as the route is
//! there. (PHIDL takes them from the ports or from the ends of the path, depending on how the width is given.)

use phidl_core::layer::Layers;
use phidl_core::port::Port;
use phidl_core::scene::DeviceBuilder;
use phidl_core::{Error, Result};
use phidl_path::{CrossSection, Extrusion, Overlaps, Path, Section};

use crate::port_pair::{PortPair, refused};
use crate::width::RouteWidth;

/// A route before it is drawn.
pub(crate) struct RouteDrawing<'a> {
    pub(crate) what: &'a str,
    pub(crate) path: &'a Path,
    /// The same line with more points, if the path has few: its chords may fold where its curve does not.
    pub(crate) finer: Option<&'a Path>,
    pub(crate) layer: &'a Layers,
    pub(crate) width: Option<&'a RouteWidth>,
    /// Number of its corners.
    pub(crate) bends: usize,
    /// Its smallest radius of curvature (µm), if it has a bend.
    pub(crate) smallest_radius: Option<f64>,
    /// Where it may run over itself.
    pub(crate) overlaps: Overlaps,
}

impl RouteDrawing<'_> {
    /// The route with ports on those that it joins.
    pub(crate) fn between_ports(&self, pair: &PortPair<'_>) -> Result<DeviceBuilder> {
        let ports = [pair.port1, pair.port2];
        let widths = match self.width {
            None => self.port_widths(ports).map(Some)?,
            Some(RouteWidth::Constant(width)) => Some([*width; 2]),
            Some(RouteWidth::Linear(from, to)) => Some([*from, *to]),
            Some(RouteWidth::Sections(_)) => None,
        };
        let x = match (self.width, widths) {
            (Some(RouteWidth::Sections(x)), _) => self.sections(x)?.clone(),
            (Some(RouteWidth::Constant(width)), _) => CrossSection::of_width(*width, self.layer),
            (_, Some(widths)) => CrossSection::of_width(widths, self.layer),
            (_, None) => CrossSection::new(),
        };
        let mut d = self.extruded(&x, pair)?;
        for ((name, port), width) in ["1", "2"].into_iter().zip(ports).zip(widths.into_iter().flatten()) {
            d.add_port(name, port.flipped().with_width(width))?;
        }
        Ok(d)
    }

    /// The route with ports at the ends of its path, in the directions of the path.
    pub(crate) fn on_its_own(&self, pair: &PortPair<'_>) -> Result<DeviceBuilder> {
        let widths = self.port_widths([pair.port1, pair.port2])?;
        self.extruded(&Section::new(widths).layer(self.layer).ports("1", "2").into(), pair)
    }

    /// The route, unless it runs over itself.
    pub(crate) fn extruded(&self, x: &CrossSection, pair: &PortPair<'_>) -> Result<DeviceBuilder> {
        let drawing = Extrusion::new(self.path, x).overlaps(self.overlaps);
        let drawn = match self.finer {
            None => drawing.open(),
            Some(finer) => {
                let checked = Extrusion::new(finer, x).overlaps(self.overlaps).open();
                checked.and_then(|_| drawing.overlaps(Overlaps::Keep).open())
            }
        };
        let mut d = drawn.map_err(|error| error.within(format!("the route {}", pair.between())))?;
        d.rename(self.what);
        d.info("bends", self.bends).info("smallest_radius", self.smallest_radius);
        Ok(d)
    }

    /// The widths of the ports. A width of 0 is refused: then the route has no width.
    fn port_widths(&self, ports: [&Port; 2]) -> Result<[f64; 2]> {
        for (name, port) in ["port1.width", "port2.width"].into_iter().zip(ports) {
            if port.width() <= 0.0 {
                return Err(refused(self.what, name, "0 µm", "be greater than 0 µm, unless `width` is given"));
            }
        }
        Ok(ports.map(Port::width))
    }

    /// The sections, which have layers of their own.
    fn sections<'x>(&self, x: &'x CrossSection) -> Result<&'x CrossSection> {
        if *self.layer != Layers::default() {
            let given = self.layer.iter().map(|layer| layer.to_string()).collect::<Vec<_>>().join(", ");
            let rule = "be left out with a cross-section, whose sections have layers of their own";
            return Err(refused(self.what, "layer", given, rule));
        }
        match self.width.is_none_or(RouteWidth::is_parameter) {
            true => Ok(x),
            false => {
                let message = "the cross-section has functions or lists, which cannot be compared as parameters; \
                               `route_custom` draws it";
                Err(Error::custom(self.what, message))
            }
        }
    }
}

/// The rule for a route that may or may not run over itself.
pub(crate) fn overlaps(allow_crossings: bool) -> Overlaps {
    if allow_crossings { Overlaps::Refuse } else { Overlaps::RefuseAll }
}
