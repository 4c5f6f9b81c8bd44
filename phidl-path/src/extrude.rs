//! Path × cross-section → device.
//!
//! Both edges of a strip are miter offsets of the path, so neighboring sections of one cross-section share their corners
//! exactly. The plain form draws whatever comes out, as the reference does: where a bend is tighter than half the width,
//! the inner edge folds back and the polygon crosses itself. [`Path::extrude_checked`] refuses that and says where.

use std::borrow::Cow;

use phidl_core::Result;
use phidl_core::geom::{Outline, Point, simplified};
use phidl_core::layer::Layers;
use phidl_core::port::Port;
use phidl_core::scene::{Device, DeviceBuilder};

use crate::miters::Miters;
use crate::{CrossSection, Fold, Path, Profile, Section, Side, fold, rule};

/// A path and a cross-section on their way to a device, with options.
///
/// ```
/// # use phidl_path::{CrossSection, Extrusion, Path};
/// let (path, x) = (Path::arc(10, 90)?, CrossSection::of_width(1, 3));
/// let device = Extrusion::new(&path, &x).simplify(1e-2).build()?;
/// assert!(device.polygons().next().unwrap().points.len() < 80); // instead of 360
/// # Ok::<(), phidl_core::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Extrusion<'a> {
    path: &'a Path,
    cross_section: &'a CrossSection,
    simplify: Option<f64>,
    checked: bool,
}

impl Path {
    /// Draws every section of a cross-section along the path: a device named `extrude`, with the ports of the sections,
    /// what was recorded about the path, and its `length`.
    ///
    /// Every section is one polygon on each of its layers: its right edge forwards, then its left edge backwards. Points
    /// that repeat the one before count once; corners that turn by more than 168.5° are beveled.
    ///
    /// Where an edge bends more tightly than its distance from the path it folds back, and the polygon crosses itself;
    /// see [`Path::extrude_checked`].
    ///
    /// # Errors
    /// [`Error::Param`](phidl_core::Error::Param) if the path has no length, if a name or a port name is there twice, or
    /// if a width is not positive (where it changes: negative) or a number not finite; and what was kept before.
    pub fn extrude(&self, cross_section: &CrossSection) -> Result<Device> {
        Extrusion::new(self, cross_section).build()
    }

    /// Draws a single strip along the path: of one width (µm), from one to another (a pair), or of a width that is a
    /// function of the part of the length that lies behind. Ports have names, and here is none to give: a strip with ports
    /// is a [`CrossSection`] of one [`Section`](crate::Section).
    ///
    /// ```
    /// # use phidl_path::Path;
    /// let bend = Path::arc(10, 90)?;
    /// let taper = bend.extrude_width((2.5, 3), 1)?;
    /// let wavy = bend.extrude_width(|t: f64| 1.0 + 0.2 * (20.0 * t).cos(), 2)?;
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Path::extrude`].
    pub fn extrude_width(&self, width: impl Into<Profile>, layers: impl Into<Layers>) -> Result<Device> {
        self.extrude(&CrossSection::of_width(width, layers))
    }

    /// [`Path::extrude`] that refuses edges which fold back: where the path bends more tightly than half the width, say.
    ///
    /// # Errors
    /// As for [`Path::extrude`]; and [`Error::Param`](phidl_core::Error::Param) with the section, the side, and the
    /// length along the path at which an edge first folds back.
    pub fn extrude_checked(&self, cross_section: &CrossSection) -> Result<Device> {
        Extrusion::new(self, cross_section).checked().build()
    }
}

impl<'a> Extrusion<'a> {
    /// The extrusion of a cross-section along a path.
    #[must_use]
    pub fn new(path: &'a Path, cross_section: &'a CrossSection) -> Self {
        Self { path, cross_section, simplify: None, checked: false }
    }

    /// The same without the points that are not needed to stay within `tolerance` (µm) of an edge; each edge is
    /// [simplified] on its own.
    #[must_use]
    pub fn simplify(self, tolerance: impl Into<f64>) -> Self {
        Self { simplify: Some(tolerance.into()), ..self }
    }

    /// The same, but edges that fold back are refused.
    #[must_use]
    pub fn checked(self) -> Self {
        Self { checked: true, ..self }
    }

    /// Where the edges fold back: section by section, the right edge first.
    ///
    /// # Errors
    /// As for [`Path::extrude`].
    pub fn folds(&self) -> Result<Vec<Fold>> {
        let guide = self.guide()?;
        Ok(fold::of_strips(self.path, &guide.strips(self.cross_section)?))
    }

    /// The device.
    ///
    /// # Errors
    /// As for [`Path::extrude`], or if the tolerance is negative; and for folded edges, if they are
    /// [refused](Extrusion::checked).
    pub fn build(&self) -> Result<Device> {
        self.open()?.build()
    }

    /// The device as it is before it is built: for more ports and info, or another name.
    ///
    /// ```
    /// # use phidl_path::{CrossSection, Extrusion, Path};
    /// let (path, x) = (Path::arc(10, 90)?, CrossSection::of_width(1, 3));
    /// let mut d = Extrusion::new(&path, &x).checked().open()?;
    /// d.rename("bend").info("radius", 10.0);
    /// assert_eq!(d.build()?.name(), "bend");
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Extrusion::build`].
    pub fn open(&self) -> Result<DeviceBuilder> {
        let guide = self.guide()?;
        if let Some(tolerance) = self.simplify {
            rule::length("extrude", "simplify", tolerance)?;
        }
        let strips = guide.strips(self.cross_section)?;
        if self.checked
            && let Some(fold) = fold::of_strips(self.path, &strips).first()
        {
            return Err(fold.refused(self.cross_section));
        }
        let mut d = Device::builder("extrude");
        self.reserve(&mut d, guide.miters.len());
        for (strip, section) in strips.iter().zip(self.cross_section.sections()) {
            match self.simplify {
                Some(tolerance) => d.add_polygon(strip.simplified(tolerance), &section.layers)?,
                None => d.add_polygon(strip, &section.layers)?,
            };
            strip.add_ports(&mut d, section)?;
        }
        for (key, value) in self.path.info() {
            d.info(key, value.clone());
        }
        d.info("length", guide.miters.length);
        Ok(d)
    }

    fn reserve(&self, d: &mut DeviceBuilder, stations: usize) {
        let polygons: usize = self.cross_section.sections().iter().map(|section| section.layers.iter().len()).sum();
        let points = if self.simplify.is_none() { 2 * polygons * stations } else { 0 };
        d.reserve(polygons, points);
    }

    fn guide(&self) -> Result<Guide<'a>> {
        self.path.check_line("extrude")?;
        self.cross_section.check()?;
        let miters = Miters::of(self.path);
        rule::positive_length("extrude", "length of the path", miters.length)?;
        let constant = |section: &Section| section.width.constant().is_some() && section.offset.constant().is_some();
        let needed = !self.cross_section.sections().iter().all(constant);
        let fractions = if needed { self.path.fractions() } else { Vec::new() };
        Ok(Guide { path: self.path, miters, fractions })
    }
}

/// What all sections of a cross-section are measured from.
struct Guide<'a> {
    path: &'a Path,
    miters: Miters<'a>,
    /// The part of the length behind each point of the path; empty if no section changes along the way.
    fractions: Vec<f64>,
}

impl Guide<'_> {
    fn strips(&self, cross_section: &CrossSection) -> Result<Vec<Strip<'_>>> {
        let sections = cross_section.sections().iter().enumerate();
        sections.map(|(place, section)| self.strip(section, place)).collect()
    }

    fn strip(&self, section: &Section, place: usize) -> Result<Strip<'_>> {
        let (miters, offset, angles) = match section.offset.constant() {
            Some(offset) => (Cow::Borrowed(&self.miters), offset, self.path.raw_angles()),
            None => {
                let (path, sources) = self.path.offset_with_sources(&section.offset)?;
                let miters = Miters::of(&path).of_sources(sources).into_owned();
                (Cow::Owned(miters), 0.0, path.raw_angles())
            }
        };
        let widths = match section.width.constant() {
            Some(width) => Widths::Same(width),
            None => Widths::Each(miters.pick(section.widths(&section.title(place), &self.fractions)?)),
        };
        Ok(Strip { miters, offset, widths, angles })
    }
}

/// The widths of a strip at its stations.
enum Widths {
    Same(f64),
    Each(Vec<f64>),
}

/// A section along a path, before it is drawn.
pub(crate) struct Strip<'a> {
    pub(crate) miters: Cow<'a, Miters<'a>>,
    offset: f64,
    widths: Widths,
    /// Directions of the path at the ends (degrees).
    angles: (f64, f64),
}

impl Strip<'_> {
    /// The width at a station.
    fn width(&self, station: usize) -> f64 {
        match &self.widths {
            Widths::Same(width) => *width,
            Widths::Each(widths) => widths[station],
        }
    }

    /// How far to the right of a station an edge is.
    pub(crate) fn distance(&self, side: Side, station: usize) -> f64 {
        self.offset + side.sign() * self.width(station) / 2.0
    }

    /// How far to the right its edges are, the left one first, and of which line; if it is equally wide everywhere.
    pub(crate) fn constant(&self) -> Option<((f64, f64), &Miters<'_>)> {
        match (&self.widths, &self.miters) {
            (Widths::Same(_), Cow::Borrowed(miters)) => {
                Some(((self.distance(Side::Left, 0), self.distance(Side::Right, 0)), miters))
            }
            _ => None,
        }
    }

    /// The right edge forwards and the left edge backwards, with fewer points.
    fn simplified(&self, tolerance: f64) -> Vec<Point> {
        let mut edges = Vec::with_capacity(2 * self.miters.len());
        self.append_to(&mut edges);
        let (right, left) = edges.split_at_mut(self.miters.len());
        // Which points go depends on the direction in which an edge is gone through.
        left.reverse();
        let mut outline = simplified(right, tolerance);
        outline.extend(simplified(left, tolerance).into_iter().rev());
        outline
    }

    /// The ports at the ends. They take their places from the path and not from the edges: a port is exactly as wide as
    /// its section and faces exactly along the path, and a tip that is no wider than a point still faces somewhere.
    fn add_ports(&self, d: &mut DeviceBuilder, section: &Section) -> Result<()> {
        let last = self.miters.len() - 1;
        let ends = [(&section.start_port, 0, self.angles.0 + 180.0), (&section.end_port, last, self.angles.1)];
        for (name, station, orientation) in ends {
            if let Some(name) = name {
                let midpoint = self.miters.points[station] + self.miters.vectors[station] * self.offset;
                d.add_port(name.as_str(), Port::new(midpoint, self.width(station), orientation))?;
            }
        }
        Ok(())
    }
}

impl Outline for &Strip<'_> {
    /// The right edge forwards, then the left edge backwards.
    fn append_to(self, buffer: &mut Vec<Point>) {
        let stations = || self.miters.points.iter().zip(&self.miters.vectors);
        match &self.widths {
            Widths::Same(_) => {
                let (right, left) = (self.distance(Side::Right, 0), self.distance(Side::Left, 0));
                buffer.extend(stations().map(|(p, miter)| *p + *miter * right));
                buffer.extend(stations().rev().map(|(p, miter)| *p + *miter * left));
            }
            Widths::Each(widths) => {
                let at = |side: Side| {
                    let half = side.sign() / 2.0;
                    move |((p, miter), w): ((&Point, &Point), &f64)| *p + *miter * (self.offset + half * w)
                };
                buffer.extend(stations().zip(widths).map(at(Side::Right)));
                buffer.extend(stations().zip(widths).rev().map(at(Side::Left)));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::place::Bounded as _;

    fn outline(device: &Device) -> Vec<(f64, f64)> {
        device.polygons().next().unwrap().points.iter().map(|p| (p.x, p.y)).collect()
    }

    fn corner() -> Path {
        Path::from_points([(0, 0), (10, 0), (10, 10)]).unwrap()
    }

    #[test]
    fn a_strip_runs_forwards_on_the_right_and_back_on_the_left() {
        let strip = corner().extrude_width(2, 1).unwrap();
        assert_eq!(outline(&strip), [(0., -1.), (11., -1.), (11., 10.), (9., 10.), (9., 1.), (0., 1.)]);
        let taper = corner().extrude_width((2, 4), 1).unwrap();
        assert_eq!(outline(&taper), [(0., -1.), (11.5, -1.5), (12., 10.), (8., 10.), (8.5, 1.5), (0., 1.)]);
    }

    #[test]
    fn the_face_of_an_end_follows_its_direction() {
        let mut path = Path::from_points([(0, 0), (10, 0)]).unwrap();
        path.set_end_angle(45);
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let expected = [(0., -1.), (10. + half, -half), (10. - half, half), (0., 1.)];
        for (p, q) in outline(&path.extrude_width(2, 0).unwrap()).into_iter().zip(expected) {
            assert!((p.0 - q.0).abs() < 1e-12 && (p.1 - q.1).abs() < 1e-12);
        }
    }

    #[test]
    fn ports_face_outwards_and_are_as_wide_as_their_section() {
        let x = CrossSection::new()
            .add(Section::new(0.1).offset(2).layer(Layers::NONE).ports("a", "b"))
            .add(Section::new((1, 0)).layer(1).ports("in", "tip"));
        let path = Path::from_points([(0, 0), (0, 10)]).unwrap();
        let d = path.extrude(&x).unwrap();
        let port = |name: &str| {
            let port = d.port(name).unwrap();
            (port.midpoint(), port.width(), port.orientation())
        };
        assert_eq!(d.polygons().len(), 1);
        assert_eq!(port("a"), (Point::new(2.0, 0.0), 0.1, 270.0));
        assert_eq!(port("in"), (Point::new(0.0, 0.0), 1.0, 270.0));
        assert_eq!(port("tip"), (Point::new(0.0, 10.0), 0.0, 90.0));
        assert_eq!(d.info()["length"].as_f64(), Some(10.0));
    }

    #[test]
    fn repeated_points_leave_no_notch_and_sharp_points_no_spike() {
        let path = Path::from_points([(0, 0), (0, 10), (0, 10), (0, 20)]).unwrap();
        assert_eq!(
            outline(&path.extrude_width(2, 0).unwrap()),
            [(1., 0.), (1., 10.), (1., 20.), (-1., 20.), (-1., 10.), (-1., 0.)]
        );
        let sharp = Path::from_points([(0.0, 0.0), (10.0, 0.0), (0.0, 0.01)]).unwrap().extrude_width(1, 0).unwrap();
        assert!(sharp.xmax() < 10.001 && sharp.xmin() > -0.001, "{:?}", sharp.bbox());
    }

    #[test]
    fn a_wavy_strip_keeps_its_width_around_a_wavy_middle() {
        // The reference library's value for the area of this strip.
        let x = CrossSection::new().add(Section::new(1).offset(|t: f64| 3.0 + (6.0 * std::f64::consts::PI * t).cos()));
        let d = Path::straight(40).unwrap().extrude(&x).unwrap();
        assert!((d.polygons().next().unwrap().area() - 42.129_227).abs() < 1e-6);
    }

    #[test]
    fn what_cannot_be_drawn_is_refused() {
        let path = corner();
        assert!(Path::new().extrude_width(1, 0).is_err());
        assert!(Path::straight(0).unwrap().extrude_width(1, 0).is_err());
        assert!(path.extrude_width(0, 0).is_err() && path.extrude_width((1, -1), 0).is_err());
        assert!(path.extrude_width(|_: f64| f64::NAN, 0).is_err());
        assert!(path.extrude_width(vec![1.0, 2.0], 0).is_err());
        let x = CrossSection::of_width(1, 0);
        assert!(Extrusion::new(&path, &x).simplify(-1).build().is_err());
        let mut bad = Path::new();
        bad.append([(0, 0)]).append(&path);
        let error = bad.extrude_width(1, 0).unwrap_err();
        assert_eq!(error.to_string(), "path: points is 1 point, but it must be at least 2 points");
    }

    #[test]
    fn a_list_of_widths_goes_with_the_points() {
        let d = corner().extrude_width(vec![2.0, 4.0, 6.0], 0).unwrap();
        assert_eq!(outline(&d), [(0., -1.), (12., -2.), (13., 10.), (7., 10.), (8., 2.), (0., 1.)]);
    }
}
