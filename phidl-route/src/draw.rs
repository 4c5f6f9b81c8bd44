//! From a centerline to a device: width, ports and info, in one way for all routes.
//!
//! There is one convention for ports: they lie on the ports that are joined, face them, and are as wide as the route is
//! there. (The reference takes them from the ports or from the ends of the path, depending on how the width is given.)

use phidl_core::Result;
use phidl_core::layer::Layers;
use phidl_core::port::Port;
use phidl_core::scene::DeviceBuilder;
use phidl_path::{CrossSection, Extrusion, Overlaps, Path, Section};

use crate::port_pair::{PortPair, refused};
use crate::width::RouteWidth;

/// A route on its way to a device.
pub(crate) struct RouteDrawing<'a> {
    pub(crate) what: &'a str,
    pub(crate) path: &'a Path,
    /// The same line with more points, if the path has few: its chords may fold where its curve does not.
    pub(crate) finer: Option<&'a Path>,
    pub(crate) layer: &'a Layers,
    pub(crate) width: Option<&'a RouteWidth>,
    /// How many corners it goes round.
    pub(crate) bends: usize,
    /// Its smallest radius of curvature (µm), if it is bent at all.
    pub(crate) smallest_radius: Option<f64>,
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

    /// The route with ports at the ends of its path, wherever these look.
    pub(crate) fn on_its_own(&self, pair: &PortPair<'_>) -> Result<DeviceBuilder> {
        let widths = self.port_widths([pair.port1, pair.port2])?;
        self.extruded(&Section::new(widths).layer(self.layer).ports("1", "2").into(), pair)
    }

    /// The route, unless one of its edges folds back.
    fn extruded(&self, x: &CrossSection, pair: &PortPair<'_>) -> Result<DeviceBuilder> {
        let drawing = Extrusion::new(self.path, x);
        let drawn = match self.finer {
            None => drawing.open(),
            Some(finer) => Extrusion::new(finer, x).open().and_then(|_| drawing.overlaps(Overlaps::Keep).open()),
        };
        let mut d = drawn.map_err(|error| error.within(format!("{} {}", self.what, pair.between())))?;
        d.rename(self.what);
        d.info("bends", self.bends).info("smallest_radius", self.smallest_radius);
        Ok(d)
    }

    /// The widths of the ports, of which none may be zero, since no width was given.
    fn port_widths(&self, ports: [&Port; 2]) -> Result<[f64; 2]> {
        for (name, port) in ["port1.width", "port2.width"].into_iter().zip(ports) {
            if port.width() <= 0.0 {
                return Err(refused(self.what, name, "0 µm", "be greater than 0 µm, or a width must be given"));
            }
        }
        Ok(ports.map(Port::width))
    }

    /// The sections, which have layers of their own.
    fn sections<'x>(&self, x: &'x CrossSection) -> Result<&'x CrossSection> {
        if *self.layer != Layers::default() {
            let given = format!("{:?} beside a cross-section", self.layer.as_slice());
            return Err(refused(self.what, "layer", given, "be left to the sections, which have their own"));
        }
        match self.width.is_none_or(RouteWidth::is_sound) {
            true => Ok(x),
            false => {
                let given = "a cross-section with functions or lists";
                Err(refused(
                    self.what,
                    "width",
                    given,
                    "be of numbers and pairs; extrude others along waypoints by hand",
                ))
            }
        }
    }
}
