//! [`Band`]: a section along a path, before it is drawn.
//!
//! Both edges of a band are miter offsets of one line, so sections of one cross-section share their corners exactly. The
//! line is the path itself, or the moved middle line of a section whose offset is a function or a list.

use std::borrow::Cow;

use phidl_core::Result;
use phidl_core::geom::{Outline, Point, simplified};
use phidl_core::port::Port;
use phidl_core::scene::DeviceBuilder;

use crate::normals::OffsetNormals;
use crate::{CrossSection, Path, Profile, Section, Side, rule};

/// What all sections of a cross-section are measured from.
pub(crate) struct Baseline<'a> {
    path: &'a Path,
    pub(crate) normals: OffsetNormals<'a>,
    /// The fraction of the length before each point of the path; empty if all sections are constant.
    fractions: Vec<f64>,
}

impl<'a> Baseline<'a> {
    pub(crate) fn new(path: &'a Path, cross_section: &CrossSection) -> Result<Self> {
        path.check_line("extrude")?;
        cross_section.check()?;
        let normals = OffsetNormals::of(path);
        rule::positive_length("extrude", "the length of the path", normals.length)?;
        let constant = |section: &Section| section.width.constant().is_some() && section.offset.constant().is_some();
        let needed = !cross_section.sections().iter().all(constant);
        let fractions = if needed { path.fractions() } else { Vec::new() };
        Ok(Self { path, normals, fractions })
    }

    pub(crate) fn bands(&self, cross_section: &CrossSection) -> Result<Vec<Band<'_>>> {
        let mut bands = Vec::with_capacity(cross_section.sections().len());
        for (index, section) in cross_section.sections().iter().enumerate() {
            let band = match &section.beside {
                None => self.band(section, index)?,
                Some(beside) => {
                    self.beside(section, index, &bands[cross_section.index_of(&beside.section)?], beside.side)?
                }
            };
            bands.push(band);
        }
        Ok(bands)
    }

    fn band(&self, section: &Section, index: usize) -> Result<Band<'_>> {
        if section.offset.is_law() {
            let normals = Cow::Borrowed(&self.normals);
            let middle = self.lengths(&section.offset, &normals, &section.title(index), "offset")?;
            let width = self.widths(section, index, &normals)?;
            return Ok(Band { normals, middle, width, shared: None, angles: self.path.raw_angles() });
        }
        let (path, sources) = self.path.offset_with_sources(&section.offset)?;
        let normals: Cow<'_, OffsetNormals<'_>> =
            Cow::Owned(OffsetNormals::of(&path).with_sources(sources).into_owned());
        let width = self.widths(section, index, &normals)?;
        Ok(Band { normals, middle: Lengths::Same(0.0), width, shared: None, angles: path.raw_angles() })
    }

    /// The band that begins at an edge of another one.
    fn beside<'s>(&'s self, section: &Section, index: usize, other: &Band<'s>, side: Side) -> Result<Band<'s>> {
        let normals = other.normals.clone();
        let width = self.widths(section, index, &normals)?;
        let edge = other.edge(side);
        let middle = edge.combined(&width, |edge, width| edge + side.sign() * width / 2.0);
        Ok(Band { normals, middle, width, shared: Some((side.opposite(), edge)), angles: other.angles })
    }

    fn widths(&self, section: &Section, index: usize, normals: &OffsetNormals<'_>) -> Result<Lengths> {
        match section.width.constant() {
            Some(width) => Ok(Lengths::Same(width)),
            None => Ok(Lengths::Each(normals.pick(section.widths(&section.title(index), &self.fractions)?))),
        }
    }

    fn lengths(&self, profile: &Profile, normals: &OffsetNormals<'_>, title: &str, param: &str) -> Result<Lengths> {
        match profile.constant() {
            Some(length) => Ok(Lengths::Same(length)),
            None => Ok(Lengths::Each(normals.pick(profile.sampled(title, param, &self.fractions)?))),
        }
    }
}

/// A length at each sample (µm).
#[derive(Debug, Clone)]
pub(crate) enum Lengths {
    Same(f64),
    Each(Vec<f64>),
}

impl Lengths {
    fn at(&self, sample: usize) -> f64 {
        match self {
            Self::Same(length) => *length,
            Self::Each(lengths) => lengths[sample],
        }
    }

    /// A length computed from two at each sample.
    fn combined(&self, other: &Self, of: impl Fn(f64, f64) -> f64) -> Self {
        match (self, other) {
            (Self::Same(a), Self::Same(b)) => Self::Same(of(*a, *b)),
            (Self::Each(a), _) => Self::Each(a.iter().enumerate().map(|(i, a)| of(*a, other.at(i))).collect()),
            (Self::Same(a), Self::Each(b)) => Self::Each(b.iter().map(|b| of(*a, *b)).collect()),
        }
    }
}

/// A section along a path, before it is drawn.
pub(crate) struct Band<'a> {
    pub(crate) normals: Cow<'a, OffsetNormals<'a>>,
    /// Distance of the middle to the right of the line (µm).
    middle: Lengths,
    width: Lengths,
    /// The edge that the band shares with another one, bit by bit.
    shared: Option<(Side, Lengths)>,
    /// Directions of the line at its ends (degrees).
    pub(crate) angles: (f64, f64),
}

impl Band<'_> {
    /// The distance of an edge to the right of the line at a sample (µm).
    pub(crate) fn distance(&self, side: Side, sample: usize) -> f64 {
        match &self.shared {
            Some((shared, edge)) if *shared == side => edge.at(sample),
            _ => self.middle.at(sample) + side.sign() * self.width.at(sample) / 2.0,
        }
    }

    /// The distances of an edge at all samples.
    fn edge(&self, side: Side) -> Lengths {
        match (&self.shared, &self.middle, &self.width) {
            (Some((shared, edge)), ..) if *shared == side => edge.clone(),
            (_, middle, width) => middle.combined(width, |middle, width| middle + side.sign() * width / 2.0),
        }
    }

    pub(crate) fn width(&self, sample: usize) -> f64 {
        self.width.at(sample)
    }

    /// The points of an edge, from the start on.
    pub(crate) fn edge_points(&self, side: Side) -> Vec<Point> {
        let samples = self.normals.points.iter().zip(&self.normals.vectors).enumerate();
        samples.map(|(i, (p, normal))| *p + *normal * self.distance(side, i)).collect()
    }

    /// The distances of the left and the right edge, if both are constant and measured from the path itself.
    pub(crate) fn constant(&self) -> Option<((f64, f64), &OffsetNormals<'_>)> {
        match (&self.middle, &self.width, &self.normals) {
            (Lengths::Same(_), Lengths::Same(_), Cow::Borrowed(normals)) => {
                Some(((self.distance(Side::Left, 0), self.distance(Side::Right, 0)), normals))
            }
            _ => None,
        }
    }

    /// The outline with fewer points; each edge is simplified on its own.
    pub(crate) fn simplified(&self, tolerance: f64) -> Vec<Point> {
        // The points that are dropped depend on the direction in which an edge is traversed.
        let (right, left) = (self.edge_points(Side::Right), self.edge_points(Side::Left));
        let mut outline = simplified(&right, tolerance);
        outline.extend(simplified(&left, tolerance).into_iter().rev());
        outline
    }

    /// Adds the ports at the ends.
    ///
    /// A port takes its position and direction from the path, and its width from the section, not from the edges. So it is
    /// exactly as wide as its section and faces exactly along the path, and the port of a pointed tip has a direction too.
    pub(crate) fn add_ports(&self, d: &mut DeviceBuilder, section: &Section) -> Result<()> {
        let last = self.normals.len() - 1;
        let ends = [(&section.start_port, 0, self.angles.0 + 180.0), (&section.end_port, last, self.angles.1)];
        for (name, sample, orientation) in ends {
            if let Some(name) = name {
                let midpoint = self.normals.points[sample] + self.normals.vectors[sample] * self.middle.at(sample);
                d.add_port(name.as_str(), Port::new(midpoint, self.width(sample), orientation))?;
            }
        }
        Ok(())
    }
}

impl Outline for &Band<'_> {
    /// The right edge forwards, then the left edge backwards.
    fn append_to(self, buffer: &mut Vec<Point>) {
        let samples = || self.normals.points.iter().zip(&self.normals.vectors);
        match (&self.middle, &self.width, &self.shared) {
            (Lengths::Same(_), Lengths::Same(_), _) => {
                let (right, left) = (self.distance(Side::Right, 0), self.distance(Side::Left, 0));
                buffer.extend(samples().map(|(p, normal)| *p + *normal * right));
                buffer.extend(samples().rev().map(|(p, normal)| *p + *normal * left));
            }
            (Lengths::Same(middle), Lengths::Each(widths), None) => {
                let at = |side: Side| {
                    let half = side.sign() / 2.0;
                    move |((p, normal), w): ((&Point, &Point), &f64)| *p + *normal * (middle + half * w)
                };
                buffer.extend(samples().zip(widths).map(at(Side::Right)));
                buffer.extend(samples().zip(widths).rev().map(at(Side::Left)));
            }
            _ => {
                buffer.extend(self.edge_points(Side::Right));
                buffer.extend(self.edge_points(Side::Left).into_iter().rev());
            }
        }
    }
}
