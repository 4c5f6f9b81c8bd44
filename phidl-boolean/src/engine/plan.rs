//! Where the plane is divided: vertical strips with about the same number of vertices each.
//!
//! Strips instead of square tiles, because the sweep then knows what lies below a strip: nothing. The sweep's list of
//! active edges is longer than a tile's would be, but a search in it is logarithmic.

use std::ops::Range;

use rayon::prelude::*;

use super::edge::Scene;
use crate::{jobs::per_job, options::Division};

/// Samples of x per strip from which the borders are chosen.
const SAMPLES_PER_STRIP: usize = 32;

/// Up to this many strips, for which an edge may be seen twice on average, are worth it to keep all threads busy.
const FEW_STRIPS: usize = 64;

/// With more strips than that, at most one edge in this many may be seen twice; otherwise the strips are made wider.
const SEEN_ONCE_PER_TWICE: usize = 6;

/// Stretches of edges that are dealt out to the strips by one job each, at most: each has a list of all strips.
const MOST_STRETCHES: usize = 64;

/// Strips of the plane and the edges that touch each.
///
/// The plan depends on the edges and the strip size alone, never on the threads.
pub(super) struct StripPlan {
    borders: Borders,
    /// Numbers of the edges that touch each strip, ascending.
    seen: Vec<Vec<u32>>,
}

impl StripPlan {
    pub(super) fn new(scene: &Scene, division: Division) -> Self {
        let mut strips = division.strips(scene.len());
        loop {
            let borders = Borders::new(scene, strips);
            let touched = borders.touched_by_all(scene);
            let sightings: usize = touched.iter().flatten().map(|touched| touched.strips.len()).sum();
            if borders.strips() == 1 || sightings <= most_sightings(scene.len(), strips) {
                return Self { seen: borders.deal_out(touched), borders };
            }
            strips /= 2;
        }
    }

    /// Number of strips, at least one.
    pub(super) fn len(&self) -> usize {
        self.seen.len()
    }

    /// The strip that owns a grid column.
    pub(super) fn strip_of(&self, x: i64) -> usize {
        self.borders.strip_of(x)
    }

    /// First and last grid column of a strip.
    pub(super) fn columns(&self, strip: usize) -> (i64, i64) {
        self.borders.columns(strip)
    }

    /// Numbers of the edges that touch a strip, ascending.
    pub(super) fn seen(&self, strip: usize) -> &[u32] {
        &self.seen[strip]
    }
}

fn most_sightings(edges: usize, strips: usize) -> usize {
    if strips <= FEW_STRIPS { 2 * edges } else { edges + edges / SEEN_ONCE_PER_TWICE }
}

/// First grid column of each strip but the first, which begins at −∞.
struct Borders(Vec<i64>);

impl Borders {
    /// Columns that divide a sample of the vertices evenly.
    fn new(scene: &Scene, strips: usize) -> Self {
        if strips < 2 {
            return Self(Vec::new());
        }
        let stride = (scene.len() / (strips * SAMPLES_PER_STRIP)).max(1);
        let mut reader = scene.reader();
        let mut sample: Vec<i64> =
            numbers(0..scene.len()).step_by(stride).filter_map(|edge| Some(reader.columns(edge)?.0)).collect();
        sample.par_sort_unstable();
        let mut firsts: Vec<i64> =
            (1..strips).filter_map(|strip| sample.get(strip * sample.len() / strips).copied()).collect();
        firsts.dedup();
        Self(firsts)
    }

    fn strips(&self) -> usize {
        self.0.len() + 1
    }

    fn strip_of(&self, x: i64) -> usize {
        self.0.partition_point(|&first| first <= x)
    }

    fn columns(&self, strip: usize) -> (i64, i64) {
        let first = if strip == 0 { i64::MIN } else { self.0[strip - 1] };
        (first, self.0.get(strip).map_or(i64::MAX, |next| next - 1))
    }

    /// The strip of a column that is probably in the strip `guess`.
    #[inline]
    fn strip_near(&self, x: i64, guess: usize) -> usize {
        let (first, last) = self.columns(guess);
        if first <= x && x <= last { guess } else { self.strip_of(x) }
    }

    /// The strips that all edges touch, by stretches of edges.
    fn touched_by_all(&self, scene: &Scene) -> Vec<Vec<Touched>> {
        let length = scene.len().div_ceil(MOST_STRETCHES).max(per_job(scene.len(), scene.len()));
        let stretches = (0..scene.len().div_ceil(length)).into_par_iter();
        stretches.map(|s| self.touched(scene, s * length..((s + 1) * length).min(scene.len()))).collect()
    }

    /// The strips that some edges touch. Edges that follow each other are mostly in one strip.
    fn touched(&self, scene: &Scene, edges: Range<usize>) -> Vec<Touched> {
        let mut touched = Vec::with_capacity(edges.len());
        let (mut reader, mut first) = (scene.reader(), 0);
        for edge in numbers(edges) {
            if let Some((left, right)) = reader.columns(edge) {
                first = self.strip_near(left, first);
                touched.push(Touched { edge, strips: number(first)..number(self.strip_near(right, first)) + 1 });
            }
        }
        touched
    }

    /// The edges that each strip sees.
    fn deal_out(&self, touched: Vec<Vec<Touched>>) -> Vec<Vec<u32>> {
        let edges = touched.iter().map(Vec::len).sum();
        let dealt: Vec<Dealt> = touched.into_par_iter().map(|touched| Dealt::new(&touched, self.strips())).collect();
        let seen = |strip| {
            let mut seen = Vec::with_capacity(dealt.iter().map(|part| part.of(strip).len()).sum());
            dealt.iter().for_each(|part| seen.extend_from_slice(part.of(strip)));
            seen
        };
        let strips = (0..self.strips()).into_par_iter();
        strips.with_min_len(per_job(self.strips(), edges)).map(seen).collect()
    }
}

/// An edge and the strips that it touches.
struct Touched {
    edge: u32,
    strips: Range<u32>,
}

/// A stretch of edges, dealt out to the strips.
struct Dealt {
    /// Strip `s` has `edges[starts[s]..starts[s + 1]]`.
    starts: Vec<u32>,
    edges: Vec<u32>,
}

impl Dealt {
    fn new(touched: &[Touched], strips: usize) -> Self {
        let mut starts = vec![0; strips + 1];
        for Touched { strips, .. } in touched {
            strips.clone().for_each(|strip| starts[strip as usize + 1] += 1);
        }
        for strip in 0..strips {
            starts[strip + 1] += starts[strip];
        }
        let mut next = starts.clone();
        let mut edges = vec![0; starts[strips] as usize];
        for Touched { edge, strips } in touched {
            for strip in strips.clone() {
                let place = &mut next[strip as usize];
                edges[*place as usize] = *edge;
                *place += 1;
            }
        }
        Self { starts, edges }
    }

    fn of(&self, strip: usize) -> &[u32] {
        &self.edges[self.starts[strip] as usize..self.starts[strip + 1] as usize]
    }
}

/// A number of an edge or a strip as it is stored.
#[expect(clippy::cast_possible_truncation, reason = "edge numbers fit a u32, and strips are not more")]
fn number(place: usize) -> u32 {
    place as u32
}

fn numbers(edges: Range<usize>) -> Range<u32> {
    number(edges.start)..number(edges.end)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        contours::Contours,
        engine::{Operand, free::Free},
        point::GridPoint,
    };

    /// Plans for contours of two edges each, from `x0` to `x1` and back.
    fn with_plan(edges: impl Iterator<Item = (i64, i64)>, division: Division, test: impl Fn(&Scene, &StripPlan)) {
        let there_and_back = |(x0, x1)| [GridPoint::new(x0, 0), GridPoint::new(x1, 1)];
        let contours: Contours = edges.map(there_and_back).collect();
        let operands = [Operand::Wound(&contours), Operand::Wound(&Contours::new())];
        let scene = Scene::new(&operands, &Free::none(&operands)).unwrap();
        test(&scene, &StripPlan::new(&scene, division));
    }

    #[test]
    fn every_column_belongs_to_the_strip_that_claims_it() {
        let edges = (0..50).map(|x| (x * 7 % 90, x * 7 % 90 + 3));
        with_plan(edges, Division::Vertices(10), |_, plan| {
            assert!(plan.len() > 3);
            for strip in 0..plan.len() {
                let (first, last) = plan.columns(strip);
                assert_eq!((plan.strip_of(first), plan.strip_of(last)), (strip, strip));
            }
        });
    }

    #[test]
    fn a_strip_sees_all_edges_that_touch_it_and_no_others() {
        let edges = (0..3000).map(|x| (x % 700, x % 700 + 2)); // more than one stretch
        with_plan(edges, Division::Vertices(200), |scene, plan| {
            for strip in 0..plan.len() {
                let (first, last) = plan.columns(strip);
                let touches = |&number: &u32| scene.edge(number).l.x <= last && scene.edge(number).r.x >= first;
                let touching: Vec<u32> = numbers(0..scene.len()).filter(touches).collect();
                assert_eq!(plan.seen(strip), touching);
            }
        });
    }

    #[test]
    fn long_edges_make_strips_wider_instead_of_filling_every_strip() {
        with_plan((0..500).map(|x| (x, x + 100_000)), Division::Vertices(1), |scene, plan| {
            assert!((0..plan.len()).map(|strip| plan.seen(strip).len()).sum::<usize>() <= 2 * scene.len());
        });
    }

    #[test]
    fn nobody_sees_what_lies_between_repeated_points() {
        let repeated: Contours = [[GridPoint::new(3, 0); 2].to_vec()].into_iter().collect();
        let operands = [Operand::Wound(&repeated), Operand::Wound(&repeated)];
        let scene = Scene::new(&operands, &Free::none(&operands)).unwrap();
        assert!(StripPlan::new(&scene, Division::default()).seen(0).is_empty());
    }
}
