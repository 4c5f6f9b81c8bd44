//! [`SelfOverlap`]: where a band covers an area twice.
//!
//! Two causes are told apart. A bend is tighter than the distance of an edge: the edge runs backwards there (`folds`), and
//! the outline may cross itself nearby. Or two turns of the path are closer together than the band is wide. Running
//! backwards alone is harmless: the inner edge of a short leg at the end of a path does, and the outline stays simple. So
//! an outline with a fold is tested for crossings (`crossings`), and a fold counts if a crossing encloses it.
//!
//! Folds cost a product for each point, and nothing for most arcs. Crossings are searched for only if there is a fold, or
//! on demand.

mod crossings;
mod folds;
mod union;

use phidl_core::{Error, Result};

use crate::band::Band;
use crate::rule::um;
use crate::{CrossSection, Path, Side};
use crossings::segment_distance;

pub(crate) use union::polygons;

/// A stretch of a band that covers an area twice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SelfOverlap {
    /// Number of the section in its cross-section.
    pub section: usize,
    /// The length along the path at which it begins (µm); with [`OverlapCause::Turns`], the first of two positions.
    pub from: f64,
    /// The length along the path at which it ends (µm); with [`OverlapCause::Turns`], the second of two positions.
    pub to: f64,
    /// Why it is there.
    pub cause: OverlapCause,
}

/// Why a band covers an area twice.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum OverlapCause {
    /// The path bends more tightly than an edge is away from it, or a leg between corners is too short.
    Bend {
        /// The edge.
        side: Side,
        /// The distance of the edge from the path (µm).
        distance: f64,
        /// The largest distance that the path allows there (µm).
        limit: f64,
    },
    /// Two positions of the path are closer together than the band is wide.
    Turns {
        /// The distance of the two positions (µm).
        distance: f64,
    },
}

/// An area that is covered twice is looked for within this many distances of the edge around a fold: beyond the miter
/// limit on both sides.
const VICINITY: f64 = 20.0;

/// Areas that are covered twice and lower than this (µm) are ignored: a step of the usual database grid. A kink of a degree
/// in a list of points leaves such areas.
const NEGLIGIBLE: f64 = 1e-3;

/// The overlaps of bands along a path, band by band; those between turns only if `turns` is set.
pub(crate) fn of_bands(path: &Path, bands: &[Band<'_>], turns: bool) -> Vec<SelfOverlap> {
    if !turns && folds::none_between(bands) {
        return Vec::new();
    }
    let lengths = path.lengths();
    bands.iter().enumerate().flat_map(|(section, band)| of_band(band, section, &lengths, turns)).collect()
}

fn of_band(band: &Band<'_>, section: usize, lengths: &[f64], turns: bool) -> Vec<SelfOverlap> {
    let folds = folds::of_band(band);
    if folds.is_empty() && !turns {
        return Vec::new();
    }
    let at = |sample: usize| lengths[band.normals.source(sample)];
    let mut crossings = crossings::of_band(band);
    let mut overlaps = Vec::new();
    for fold in folds {
        let (from, to) = (at(fold.first), at(fold.last));
        let reach = VICINITY * fold.distance.abs() + to - from;
        let encloses = |(a, b): &(usize, usize)| {
            at(*a) <= to && at(b + 1) >= from && at(b + 1) - at(*a) <= reach + at(a + 1) - at(*a) + at(b + 1) - at(*b)
        };
        let before = crossings.len();
        crossings.retain(|pair| !encloses(pair));
        if crossings.len() < before && fold.height(band) > NEGLIGIBLE {
            let cause = OverlapCause::Bend { side: fold.side, distance: fold.distance.abs(), limit: fold.limit };
            overlaps.push(SelfOverlap { section, from, to, cause });
        }
    }
    if turns {
        overlaps.extend(between_turns(band, section, &crossings, at));
    }
    overlaps
}

/// The overlap of two turns, at the pair of steps that are closest to each other.
fn between_turns(
    band: &Band<'_>,
    section: usize,
    crossings: &[(usize, usize)],
    at: impl Fn(usize) -> f64,
) -> Option<SelfOverlap> {
    let points = &band.normals.points;
    let position = |step: usize, part: f64| at(step) + part * (at(step + 1) - at(step));
    let overlap = |&(a, b): &(usize, usize)| {
        let (distance, [from, to]) = segment_distance([points[a], points[a + 1]], [points[b], points[b + 1]]);
        SelfOverlap { section, from: position(a, from), to: position(b, to), cause: OverlapCause::Turns { distance } }
    };
    let key = |overlap: &SelfOverlap| match overlap.cause {
        OverlapCause::Turns { distance } => distance,
        OverlapCause::Bend { .. } => f64::INFINITY,
    };
    crossings.iter().map(overlap).min_by(|a, b| key(a).total_cmp(&key(b)).then(a.from.total_cmp(&b.from)))
}

impl SelfOverlap {
    /// The error for it, with what would avoid it.
    pub(crate) fn error(&self, cross_section: &CrossSection, bands: &[Band<'_>]) -> Error {
        let title = cross_section.sections()[self.section].title(self.section);
        let band = &bands[self.section];
        let (from, to) = (um(self.from), um(self.to));
        let message = match self.cause {
            OverlapCause::Bend { side, distance, limit } => {
                let widest = widest(band, side, distance, limit);
                let width = match widest > 0.0 {
                    true => format!("a width of at most {} µm would do", rounded_down(widest)),
                    false => "the section may lie closer to the path".to_owned(),
                };
                format!(
                    "{title} overlaps itself on the {side} from {from} to {to} along the path: its edge lies {} from the \
                     path, which bends too tightly there; a bend radius, or a leg between corners, of at least {} µm, or \
                     {width}",
                    um(distance),
                    rounded_up(distance)
                )
            }
            OverlapCause::Turns { distance } if rounded_down(distance) <= 0.0 => {
                format!(
                    "{title} crosses itself: the path passes twice through one position, at {from} and at {to} along it"
                )
            }
            OverlapCause::Turns { distance } => format!(
                "{title} overlaps itself: the positions at {from} and at {to} along the path are {} apart; a width of at \
                 most {} µm would do",
                um(distance),
                rounded_down(distance)
            ),
        };
        Error::custom("extrude", message)
    }
}

/// The largest width with which an edge stays within a limit, if the middle stays where it is (µm).
fn widest(band: &Band<'_>, side: Side, distance: f64, limit: f64) -> f64 {
    let middle =
        |sample: usize| side.sign() * (band.distance(Side::Left, sample) + band.distance(Side::Right, sample)) / 2.0;
    let samples = 0..band.normals.len();
    let at_edge = samples.filter(|i| (band.distance(side, *i).abs() - distance).abs() <= 1e-12 * distance.max(1.0));
    at_edge.map(|i| 2.0 * (limit - middle(i))).fold(f64::INFINITY, f64::min)
}

/// A bound with four digits, rounded to the safe side.
fn rounded_down(length: f64) -> f64 {
    let step = step(length);
    let rounded = (length / step).floor() * step;
    (rounded * 1e9).round() / 1e9
}

fn rounded_up(length: f64) -> f64 {
    let step = step(length);
    let rounded = (length / step - 1e-9).ceil() * step;
    (rounded * 1e9).round() / 1e9
}

fn step(length: f64) -> f64 {
    10_f64.powf(length.abs().max(1e-3).log10().floor() - 3.0)
}

/// Refuses bands that cover an area twice.
pub(crate) fn check(path: &Path, cross_section: &CrossSection, bands: &[Band<'_>], turns: bool) -> Result<()> {
    match of_bands(path, bands, turns).first() {
        None => Ok(()),
        Some(overlap) => Err(overlap.error(cross_section, bands)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Extrusion, Overlaps, Path, Section, Spiral};
    use std::f64::consts::FRAC_PI_2;

    fn overlaps(path: &Path, x: &CrossSection) -> Vec<SelfOverlap> {
        Extrusion::new(path, x).self_overlaps().unwrap()
    }

    #[test]
    fn a_band_overlaps_itself_exactly_where_a_radius_is_less_than_half_its_width() {
        let path = Path::of([Path::line(7).unwrap(), Path::arc(2, 90).unwrap(), Path::line(7).unwrap()]);
        assert_eq!(overlaps(&path, &CrossSection::of_width(3.999, 0)), []);
        assert_eq!(overlaps(&path, &CrossSection::of_width(4, 0)), []);
        let [overlap] = overlaps(&path, &CrossSection::of_width(4.1, 0))[..] else { panic!("one on the inner side") };
        let OverlapCause::Bend { side, distance, limit } = overlap.cause else { panic!("a bend") };
        assert_eq!((overlap.section, side, distance), (0, Side::Left, 2.05));
        assert!((limit - 2.0).abs() < 1e-3, "{limit}");
        // The ends of the arc are half a step from where its first chord bends.
        let step = 2.0 * FRAC_PI_2 / 179.0;
        assert!((overlap.from - 7.0).abs() < 1.5 * step && (overlap.to - 7.0 - 2.0 * FRAC_PI_2).abs() < 1.5 * step);
    }

    #[test]
    fn the_radius_and_the_width_of_the_message_would_do() {
        let around = |radius: f64| {
            Path::of([Path::line(10).unwrap(), Path::arc(radius, -180).unwrap(), Path::line(10).unwrap()])
        };
        let heater =
            |width: f64| CrossSection::new().add(Section::new(1)).add(Section::new(width).offset(1.5).named("heater"));
        let error = around(1.6).extrude(&heater(0.5)).unwrap_err().to_string();
        assert!(error.contains("section \"heater\" overlaps itself on the right from 10"), "{error}");
        assert!(error.contains("of at least 1.75 µm"), "{error}");
        let width = error.split("a width of at most ").nth(1).and_then(|rest| rest.split(' ').next()).unwrap();
        let width: f64 = width.parse().unwrap();
        assert!((width - 0.2).abs() < 1e-3, "{error}");
        assert!(around(1.6).extrude(&heater(width)).is_ok() && around(1.75).extrude(&heater(0.5)).is_ok());
        assert!(around(1.6).extrude(&heater(0.5).mirrored()).is_ok());
        let error = around(1.0).extrude(&heater(0.5)).unwrap_err().to_string();
        assert!(error.ends_with("or the section may lie closer to the path"), "{error}");
    }

    #[test]
    fn a_short_last_leg_is_harmless_and_a_short_first_one_in_a_turn_is_not() {
        let line = |points: &[(f64, f64)]| Path::from_points(points.to_vec()).unwrap();
        let area = |path: &Path, width: f64| path.extrude_width(width, 0).unwrap().polygons().next().unwrap().area();
        assert_eq!(area(&line(&[(0., 0.), (10., 0.), (10., 1.)]), 4.0), 44.0);
        // An inner edge of the middle leg loses at one corner what it gains at the other.
        assert!(line(&[(0., 0.), (9., 0.), (9., 1.), (18., 1.)]).extrude_width(4, 0).is_ok());
        let short = line(&[(0., 0.), (1., 0.), (1., 1.)]).extrude_width(4, 0).unwrap_err().to_string();
        assert!(short.contains("a width of at most 2 µm would do"), "{short}");
        let back = line(&[(0., 0.), (10., 0.), (10., 3.), (0., 3.)]);
        assert!(back.extrude_width(5, 0).is_err() && back.extrude_width(3, 0).is_ok());
        let to_and_fro = line(&[(0., 0.), (9., 0.), (0., 0.)]);
        assert!(to_and_fro.extrude_width(1, 0).is_err());
    }

    #[test]
    fn turns_that_touch_are_accepted_and_turns_that_overlap_are_refused() {
        let spiral = Spiral { num_turns: 3.0, gap: 3.0, inner_gap: 9.0, num_pts: 4000.0 }.path().unwrap();
        let drawn = |width: f64, overlaps: Overlaps| {
            Extrusion::new(&spiral, &CrossSection::of_width(width, 0)).overlaps(overlaps).build()
        };
        assert!(drawn(2.9, Overlaps::RefuseAll).is_ok() && drawn(3.2, Overlaps::Refuse).is_ok());
        let error = drawn(3.2, Overlaps::RefuseAll).unwrap_err().to_string();
        assert!(
            error.contains("overlaps itself: the positions at") && error.contains("a width of at most 2.9"),
            "{error}"
        );
        let ring = Path::arc(10, 360).unwrap();
        let closed = |degrees: f64| {
            let path = Path::arc(10, degrees).unwrap();
            Extrusion::new(&path, &CrossSection::of_width(2, 0)).overlaps(Overlaps::RefuseAll).build()
        };
        assert!(ring.length() > 62.0 && closed(360.0).is_ok(), "the faces of a ring touch");
        assert!(closed(365.0).is_err() && closed(355.0).is_ok());
    }

    #[test]
    fn a_path_that_crosses_itself_is_drawn_unless_turns_are_checked() {
        let knot = Path::from_points([(0, 0), (50, 0), (50, 30), (20, 30), (20, -30)]).unwrap();
        let x = CrossSection::of_width(2, 0);
        assert!(knot.extrude(&x).is_ok());
        let error = Extrusion::new(&knot, &x).overlaps(Overlaps::RefuseAll).build().unwrap_err().to_string();
        assert!(error.contains("crosses itself: the path passes twice through one position"), "{error}");
    }
}
