//! [`Fold`]: where an edge of an extrusion runs backwards.

use std::ops::Range;

use phidl_core::Error;

use crate::extrude::Strip;
use crate::miters::{Miters, REPEATED};
use crate::{CrossSection, Path, rule};

/// An edge may run back by this part of its chord: where a bend is exactly as tight as half the width, its inner edge is a
/// point, and the chords of a fine arc, which lie within it, turn that into steps back of a hundred-thousandth.
const POINTED: f64 = 1e-4;

/// A side of a path, seen in its direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(missing_docs, reason = "the variants are the two sides")]
pub enum Side {
    Right,
    Left,
}

impl Side {
    /// What it counts for in distances to the right.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Right => 1.0,
            Self::Left => -1.0,
        }
    }
}

impl std::fmt::Display for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Right => "right",
            Self::Left => "left",
        })
    }
}

/// A stretch of an edge that runs backwards, because the path bends around it more tightly than it is far away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fold {
    /// Number of the section in its cross-section.
    pub section: usize,
    /// Which edge of the section.
    pub side: Side,
    /// The length along the path at which it begins (µm).
    pub from: f64,
    /// The length along the path at which it ends (µm).
    pub to: f64,
}

impl Fold {
    /// The error for it.
    pub(crate) fn refused(&self, cross_section: &CrossSection) -> Error {
        let title = cross_section.sections()[self.section].title(self.section);
        let given = format!("folded back at {} µm along the path, until {} µm", self.from, self.to);
        let edge = format!("{} edge of {title}", self.side);
        rule::refused("extrude", &edge, given, "bend no more tightly than it is away from the path")
    }
}

/// The folds of strips along a path, strip by strip.
pub(crate) fn of_strips(path: &Path, strips: &[Strip<'_>]) -> Vec<Fold> {
    if none_between(strips) {
        return Vec::new();
    }
    let lengths = path.lengths();
    strips.iter().enumerate().flat_map(|(section, strip)| of_strip(strip, section, &lengths)).collect()
}

/// Whether strips of constant width along one line surely have no fold: an edge runs forwards if those to both sides of
/// it do, so the two outermost are asked for all. Strips that say no may still have none.
fn none_between(strips: &[Strip<'_>]) -> bool {
    let Some(((mut least, mut most), miters)) = strips.first().and_then(Strip::constant) else { return false };
    for strip in strips {
        match strip.constant() {
            Some(((own_least, own_most), _)) => (least, most) = (least.min(own_least), most.max(own_most)),
            None => return false,
        }
    }
    let outermost = [least, most];
    // Around an arc all segments are alike. Only those at its ends join something else.
    let mut from = 0;
    for (segments, bend) in &miters.arcs {
        if outermost.iter().any(|aside| 1.0 + aside * bend < 0.0) || may_fold(miters, from..segments.start, outermost) {
            return false;
        }
        from = segments.end;
    }
    !may_fold(miters, from..miters.len() - 1, outermost)
}

/// Whether one of two edges runs backwards along one of some segments.
fn may_fold(miters: &Miters<'_>, segments: Range<usize>, outermost: [f64; 2]) -> bool {
    let stations = segments.start..segments.end + 1;
    let ends = miters.points[stations.clone()].windows(2).zip(miters.vectors[stations].windows(2));
    let mut worst = f64::INFINITY;
    for (points, vectors) in ends {
        let along = points[1] - points[0];
        let (square, bend) = (along.dot(along), (vectors[1] - vectors[0]).dot(along));
        let [one, other] = outermost.map(|aside| square + bend * aside);
        worst = if one < worst { one } else { worst };
        worst = if other < worst { other } else { worst };
    }
    // Nothing at all is a bevel, which may turn back.
    worst <= 0.0
}

/// The folds of both edges of a section; `lengths` are those up to the points of the path.
fn of_strip(strip: &Strip<'_>, section: usize, lengths: &[f64]) -> Vec<Fold> {
    let mut folds: Vec<Fold> = Vec::new();
    for side in [Side::Right, Side::Left] {
        for station in 0..strip.miters.len() - 1 {
            if !runs_backwards(strip, side, station) {
                continue;
            }
            let length = |station: usize| lengths[strip.miters.source(station)];
            let (from, to) = (length(station), length(station + 1));
            match folds.last_mut() {
                Some(fold) if fold.side == side && fold.to == from => fold.to = to,
                _ => folds.push(Fold { section, side, from, to }),
            }
        }
    }
    folds
}

/// Whether an edge runs against the path between a station and the next one.
fn runs_backwards(strip: &Strip<'_>, side: Side, station: usize) -> bool {
    let (points, vectors) = (&strip.miters.points, &strip.miters.vectors);
    let along = points[station + 1] - points[station];
    let length = along.dot(along).sqrt();
    let (aside, aside_next) = (strip.distance(side, station), strip.distance(side, station + 1));
    if length > REPEATED {
        let edge = along + vectors[station + 1] * aside_next - vectors[station] * aside;
        return edge.dot(along) < -(REPEATED + POINTED * length) * length;
    }
    // A beveled corner: the edge inside the turn goes around backwards, and with a half turn both do.
    aside != 0.0 && vectors[station].cross(vectors[station + 1]) * aside < REPEATED
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Extrusion, Path, Section};
    use std::f64::consts::FRAC_PI_2;

    fn folds(path: &Path, x: &CrossSection) -> Vec<Fold> {
        Extrusion::new(path, x).folds().unwrap()
    }

    #[test]
    fn a_bend_folds_exactly_when_its_radius_is_less_than_half_the_width() {
        let path = Path::of([Path::line(7).unwrap(), Path::arc(2, 90).unwrap(), Path::line(7).unwrap()]);
        assert_eq!(folds(&path, &CrossSection::of_width(3.999, 0)), []);
        let [fold] = folds(&path, &CrossSection::of_width(4.1, 0))[..] else { panic!("one fold on the inner side") };
        assert_eq!((fold.section, fold.side), (0, Side::Left));
        // The ends of the arc are half a step from where its first chord bends.
        let step = 2.0 * FRAC_PI_2 / 179.0;
        assert!((fold.from - 7.0).abs() < 1.5 * step && (fold.to - 7.0 - 2.0 * FRAC_PI_2).abs() < 1.5 * step);
    }

    #[test]
    fn the_checked_form_names_section_side_and_place() {
        let path = Path::of([Path::line(10).unwrap(), Path::arc(1, -180).unwrap()]);
        let x = CrossSection::new().add(Section::new(1)).add(Section::new(0.5).offset(1.5).named("heater"));
        let error = path.extrude_checked(&x).unwrap_err().to_string();
        assert!(error.starts_with("extrude: right edge of section \"heater\" is folded back at 10"), "{error}");
        assert!(path.extrude(&x).is_ok());
        assert!(path.extrude_checked(&x.mirrored()).is_ok());
    }

    #[test]
    fn short_steps_between_corners_fold_and_long_ones_do_not() {
        let stairs = |step: f64| Path::from_points([(0., 0.), (9., 0.), (9., step), (18., step)]).unwrap();
        assert_eq!(folds(&stairs(5.0), &CrossSection::of_width(4, 0)), []);
        // What an edge of the middle piece loses at one corner, it gains at the other.
        assert_eq!(folds(&stairs(1.0), &CrossSection::of_width(4, 0)), []);
        let back = Path::from_points([(0., 0.), (9., 0.), (9., 1.), (0., 1.)]).unwrap();
        let [fold] = folds(&back, &CrossSection::of_width(4, 0))[..] else { panic!("one fold") };
        assert_eq!((fold.side, fold.from, fold.to), (Side::Left, 9.0, 10.0));
    }

    #[test]
    fn a_path_that_doubles_back_is_folded() {
        let back = Path::from_points([(0, 0), (9, 0), (0, 0)]).unwrap();
        assert!(back.extrude_checked(&CrossSection::of_width(1, 0)).is_err());
    }
}
