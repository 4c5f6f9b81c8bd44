//! Path × cross-section → device.
//!
//! An outline that crosses itself has no agreed area: tools fill it differently. So an extrusion refuses one where an edge
//! folds back at a tight bend, and [`Overlaps`] says what else may happen. (PHIDL draws the crossed outline.) Whole turns
//! that lie on one another are a matter of choice, since a waveguide may cross itself on purpose.

use phidl_core::Result;
use phidl_core::layer::Layers;
use phidl_core::scene::{Device, DeviceBuilder};

use crate::band::{Band, Baseline};
use crate::overlap::{self, SelfOverlap};
use crate::{CrossSection, Path, Profile, Section, rule};

/// What an extrusion does where a section covers an area twice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Overlaps {
    /// Refuses an edge that folds back, because the path bends too tightly for it. Turns of the path may lie on one
    /// another: a waveguide that crosses itself is drawn.
    #[default]
    Refuse,
    /// Refuses turns that lie on one another too: the arms of a spiral, a wire that crosses itself.
    RefuseAll,
    /// Draws a section that covers an area twice as several polygons, none of which crosses itself: one for each step
    /// of the path and one for each corner. The layer then shows their union; a boolean union makes them one polygon.
    Union,
    /// Draws one outline for each section, even if it crosses itself, as PHIDL does.
    Keep,
}

/// The extrusion of a cross-section along a path, with options.
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
    overlaps: Overlaps,
}

impl Path {
    /// Draws every section of a cross-section along the path: a device named `extrude`, with the ports of the sections,
    /// the info of the path, and its `length`.
    ///
    /// Every section is one polygon on each of its layers: its right edge forwards, then its left edge backwards. Repeated
    /// points count once; corners that turn by more than 168.5° are beveled.
    ///
    /// ```
    /// # use phidl_path::{CrossSection, Path};
    /// let error = Path::arc(5, 90)?.extrude(&CrossSection::of_width(12, 1)).unwrap_err().to_string();
    /// assert!(error.contains("a bend radius, or a leg between corners, of at least 6 µm"));
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Custom`](phidl_core::Error::Custom) if a section overlaps itself at a bend, with the position and the
    /// radius and width that would do; [`Extrusion::overlaps`] allows it. [`Error::Param`](phidl_core::Error::Param) if the
    /// path has no length, a name or a port name is used twice, a width is not positive (where it changes: negative), or
    /// a number is not finite; and the deferred error of the path.
    pub fn extrude(&self, cross_section: &CrossSection) -> Result<Device> {
        Extrusion::new(self, cross_section).build()
    }

    /// Draws one band along the path: of one width (µm), from one to another (a pair), or of a width that is a function of
    /// the fraction of the length. It has no ports, since these need names: a band with ports is a [`CrossSection`] of one
    /// [`Section`](crate::Section).
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
}

impl<'a> Extrusion<'a> {
    /// The extrusion of a cross-section along a path.
    #[must_use]
    pub fn new(path: &'a Path, cross_section: &'a CrossSection) -> Self {
        Self { path, cross_section, simplify: None, overlaps: Overlaps::Refuse }
    }

    /// The same without the points that are not needed to stay within `tolerance` (µm) of an edge; each edge is
    /// [simplified](phidl_core::geom::simplified) on its own.
    #[must_use]
    pub fn simplify(self, tolerance: impl Into<f64>) -> Self {
        Self { simplify: Some(tolerance.into()), ..self }
    }

    /// The same with another rule for sections that cover an area twice.
    ///
    /// ```
    /// # use phidl_path::{CrossSection, Extrusion, Overlaps, Path};
    /// let (path, x) = (Path::arc(5, 90)?, CrossSection::of_width(12, 1));
    /// let device = Extrusion::new(&path, &x).overlaps(Overlaps::Union).build()?;
    /// assert!(device.polygons().len() > 1);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    #[must_use]
    pub fn overlaps(self, overlaps: Overlaps) -> Self {
        Self { overlaps, ..self }
    }

    /// Where the sections overlap themselves: section by section, those at bends first. Turns that lie on one another are
    /// listed unless [`Overlaps::Refuse`] is the rule, the first pair of each section.
    ///
    /// # Errors
    /// As for [`Path::extrude`], except for overlaps.
    pub fn self_overlaps(&self) -> Result<Vec<SelfOverlap>> {
        let baseline = Baseline::new(self.path, self.cross_section)?;
        let turns = self.overlaps != Overlaps::Refuse;
        Ok(overlap::of_bands(self.path, &baseline.bands(self.cross_section)?, turns))
    }

    /// The device.
    ///
    /// # Errors
    /// As for [`Path::extrude`], or if the tolerance is negative.
    pub fn build(&self) -> Result<Device> {
        self.open()?.build()
    }

    /// The open cell, for more ports and info, or another name.
    ///
    /// ```
    /// # use phidl_path::{CrossSection, Extrusion, Path};
    /// let (path, x) = (Path::arc(10, 90)?, CrossSection::of_width(1, 3));
    /// let mut d = Extrusion::new(&path, &x).open()?;
    /// d.rename("bend").info("radius", 10.0);
    /// assert_eq!(d.build()?.name(), "bend");
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Extrusion::build`].
    pub fn open(&self) -> Result<DeviceBuilder> {
        let baseline = Baseline::new(self.path, self.cross_section)?;
        if let Some(tolerance) = self.simplify {
            rule::length("extrude", "simplify", tolerance)?;
        }
        let bands = baseline.bands(self.cross_section)?;
        let split = self.sections_to_split(&bands)?;
        let mut d = Device::builder("extrude");
        self.reserve(&mut d, baseline.normals.len());
        for (index, (band, section)) in bands.iter().zip(self.cross_section.sections()).enumerate() {
            match (split.contains(&index), self.simplify) {
                (true, _) => add_polygons(&mut d, band, section)?,
                (false, Some(tolerance)) => d.add_polygon(band.simplified(tolerance), &section.layers).map(|_| ())?,
                (false, None) => d.add_polygon(band, &section.layers).map(|_| ())?,
            }
            band.add_ports(&mut d, section)?;
        }
        for (key, value) in self.path.info() {
            d.info(key, value.clone());
        }
        d.info("length", baseline.normals.length);
        Ok(d)
    }

    /// The sections that are drawn as several polygons; refuses overlaps unless they are allowed.
    fn sections_to_split(&self, bands: &[Band<'_>]) -> Result<Vec<usize>> {
        match self.overlaps {
            Overlaps::Keep => Ok(Vec::new()),
            Overlaps::Union => {
                let overlaps = overlap::of_bands(self.path, bands, true);
                Ok(overlaps.into_iter().map(|overlap| overlap.section).collect())
            }
            rule => {
                overlap::check(self.path, self.cross_section, bands, rule == Overlaps::RefuseAll)?;
                Ok(Vec::new())
            }
        }
    }

    fn reserve(&self, d: &mut DeviceBuilder, samples: usize) {
        let polygons: usize = self.cross_section.sections().iter().map(|section| section.layers.iter().len()).sum();
        let points = if self.simplify.is_none() { 2 * polygons * samples } else { 0 };
        d.reserve(polygons, points);
    }
}

fn add_polygons(d: &mut DeviceBuilder, band: &Band<'_>, section: &Section) -> Result<()> {
    for outline in overlap::polygons(band) {
        d.add_polygon(outline, &section.layers)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::Point;
    use phidl_core::place::Bounded as _;

    fn outline(device: &Device) -> Vec<(f64, f64)> {
        device.polygons().next().unwrap().points.iter().map(|p| (p.x, p.y)).collect()
    }

    fn corner() -> Path {
        Path::from_points([(0, 0), (10, 0), (10, 10)]).unwrap()
    }

    #[test]
    fn an_outline_runs_forwards_on_the_right_and_back_on_the_left() {
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
        let (sharp, x) =
            (Path::from_points([(0.0, 0.0), (10.0, 0.0), (0.0, 0.01)]).unwrap(), CrossSection::of_width(1, 0));
        let sharp = Extrusion::new(&sharp, &x).overlaps(Overlaps::Keep).build().unwrap();
        assert!(sharp.xmax() < 10.001 && sharp.xmin() > -0.001, "{:?}", sharp.bbox());
    }

    #[test]
    fn a_band_around_a_wavy_middle_keeps_its_width() {
        // The reference library's value for the area of this strip.
        let x = CrossSection::new().add(Section::new(1).offset(|t: f64| 3.0 + (6.0 * std::f64::consts::PI * t).cos()));
        let d = Path::straight(40).unwrap().extrude(&x).unwrap();
        assert!((d.polygons().next().unwrap().area() - 42.129_227).abs() < 1e-6);
    }

    #[test]
    fn invalid_widths_and_paths_are_refused() {
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
        assert!(error.to_string().contains("at least 2 points"), "{error}");
    }

    #[test]
    fn a_list_of_widths_goes_with_the_points() {
        let d = corner().extrude_width(vec![2.0, 4.0, 6.0], 0).unwrap();
        assert_eq!(outline(&d), [(0., -1.), (12., -2.), (13., 10.), (7., 10.), (8., 2.), (0., 1.)]);
    }

    #[test]
    fn bands_that_meet_at_both_ends_of_a_path_meet_all_along() {
        let x = CrossSection::new()
            .add(Section::new((2, 10)).layer(1).named("strip"))
            .add(Section::new((1, 6)).right_of("strip").layer(2).named("gap"))
            .add(Section::new(5).right_of("gap").layer(3))
            .add(Section::new((1, 6)).offset((-1.5, -8)).layer(4));
        let d = Path::euler(30, 120).unwrap().extrude(&x).unwrap();
        let outlines: Vec<Vec<Point>> = d.polygons().map(|polygon| polygon.points.to_vec()).collect();
        let right = |outline: &[Point]| outline[..outline.len() / 2].to_vec();
        let left = |outline: &[Point]| outline[outline.len() / 2..].iter().rev().copied().collect::<Vec<_>>();
        assert_eq!(right(&outlines[0]), left(&outlines[1]));
        assert_eq!(right(&outlines[1]), left(&outlines[2]));
        let (a, b) = (right(&outlines[3]), left(&outlines[0]));
        assert!(a.iter().zip(&b).all(|(p, q)| p.distance(*q) < 1e-12));
    }
}
