//! Where an edge of a band runs backwards, because the path bends around it more tightly than the edge is away.

use std::ops::Range;

use crate::Side;
use crate::band::Band;
use crate::normals::{OffsetNormals, REPEATED};

/// The part of its chord by which an edge may run backwards. Where a radius is exactly half the width, the inner edge is a
/// point, and on the chords of a fine arc, which lie inside the arc, it runs backwards by a hundred-thousandth.
const POINTED: f64 = 1e-4;

/// A run of steps in which an edge goes backwards.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fold {
    pub(super) side: Side,
    /// The sample at which it begins.
    pub(super) first: usize,
    /// The sample at which it ends.
    pub(super) last: usize,
    /// The distance of the edge to the right of the line where the path is tightest (µm).
    pub(super) distance: f64,
    /// The largest distance (absolute) that the path allows there (µm).
    pub(super) limit: f64,
    /// How far the edge runs backwards in all (µm).
    backwards: f64,
}

impl Fold {
    /// The height of the area that is covered twice (µm), about: the edge goes backwards over it and turns meanwhile.
    pub(super) fn height(&self, band: &Band<'_>) -> f64 {
        let [before, after] = [self.first, self.last].map(|sample| band.normals.vectors[sample]);
        let turn = before.cross(after).abs().atan2(before.dot(after));
        self.backwards * turn.min(std::f64::consts::FRAC_PI_2).sin()
    }
}

/// Whether bands of constant width along one line have no fold. The two outermost edges are tested for all bands: an edge
/// runs forwards if edges on both sides of it do. `false` is conservative.
pub(super) fn none_between(bands: &[Band<'_>]) -> bool {
    let Some(((mut least, mut most), normals)) = bands.first().and_then(Band::constant) else { return false };
    for band in bands {
        match band.constant() {
            Some(((own_least, own_most), _)) => (least, most) = (least.min(own_least), most.max(own_most)),
            None => return false,
        }
    }
    let outermost = [least, most];
    // All segments of an arc are alike. Only those at its ends join something else.
    let mut from = 0;
    for (segments, bend) in &normals.arcs {
        if outermost.iter().any(|lateral| 1.0 + lateral * bend < 0.0)
            || may_fold(normals, from..segments.start, outermost)
        {
            return false;
        }
        from = segments.end;
    }
    !may_fold(normals, from..normals.len() - 1, outermost)
}

/// Whether one of two edges runs backwards along one of some segments.
fn may_fold(normals: &OffsetNormals<'_>, segments: Range<usize>, outermost: [f64; 2]) -> bool {
    let samples = segments.start..segments.end + 1;
    let ends = normals.points[samples.clone()].windows(2).zip(normals.vectors[samples].windows(2));
    let mut worst = f64::INFINITY;
    for (points, vectors) in ends {
        let along = points[1] - points[0];
        let (square, bend) = (along.dot(along), (vectors[1] - vectors[0]).dot(along));
        let [one, other] = outermost.map(|lateral| square + bend * lateral);
        worst = if one < worst { one } else { worst };
        worst = if other < worst { other } else { worst };
    }
    // 0 is a bevel, which may turn back.
    worst <= 0.0
}

/// The folds of both edges of a band.
pub(super) fn of_band(band: &Band<'_>) -> Vec<Fold> {
    let mut folds: Vec<Fold> = Vec::new();
    for side in [Side::Right, Side::Left] {
        for sample in 0..band.normals.len() - 1 {
            let Some(backwards) = backwards(band, side, sample) else { continue };
            let (distance, limit) = tightest(band, side, sample);
            let own = Fold { side, first: sample, last: sample + 1, distance, limit, backwards };
            match folds.last_mut() {
                Some(fold) if fold.side == side && fold.last == sample => {
                    let tighter = if own.limit < fold.limit { own } else { *fold };
                    let backwards = fold.backwards + own.backwards;
                    *fold = Fold { first: fold.first, last: own.last, backwards, ..tighter };
                }
                _ => folds.push(own),
            }
        }
    }
    folds
}

/// How far an edge runs against the path between a sample and the next one (µm), if it does.
fn backwards(band: &Band<'_>, side: Side, sample: usize) -> Option<f64> {
    let (points, vectors) = (&band.normals.points, &band.normals.vectors);
    let along = points[sample + 1] - points[sample];
    let length = along.dot(along).sqrt();
    let (lateral, lateral_next) = (band.distance(side, sample), band.distance(side, sample + 1));
    let edge = along + vectors[sample + 1] * lateral_next - vectors[sample] * lateral;
    if length > REPEATED {
        let backwards = -edge.dot(along) / length;
        return (backwards > REPEATED + POINTED * length).then_some(backwards);
    }
    // A beveled corner: the edge inside the turn runs backwards, and in a half turn both edges do.
    let inside = lateral != 0.0 && vectors[sample].cross(vectors[sample + 1]) * lateral < REPEATED;
    inside.then(|| edge.norm())
}

/// The distance of an edge between a sample and the next one, and the largest that the path allows (absolute).
fn tightest(band: &Band<'_>, side: Side, sample: usize) -> (f64, f64) {
    let along = band.normals.points[sample + 1] - band.normals.points[sample];
    let change = (band.normals.vectors[sample + 1] - band.normals.vectors[sample]).dot(along).abs();
    let limit = if change > 0.0 { along.dot(along) / change } else { 0.0 };
    let ends = [band.distance(side, sample), band.distance(side, sample + 1)];
    let distance = if ends[1].abs() > ends[0].abs() { ends[1] } else { ends[0] };
    (distance, limit)
}
