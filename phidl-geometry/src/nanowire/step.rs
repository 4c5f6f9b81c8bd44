//! [`optimal_step`]: a change of width without current crowding.
//!
//! The edge is a streamline of the current through an abrupt step, given by a conformal map ζ(η). A point with a given x or
//! y is found by [`least`] with PHIDL's tolerance, on which the points of PHIDL's masks depend. That search misses the end
//! widths if their ratio is above about 35 or `width_tol` is tiny. Then a bracketing root search replaces it.

use num_complex::Complex64;
use phidl_core::num::count::linspace;
use phidl_core::prelude::*;
use phidl_macros::device;
use roots::{SimpleConvergency, find_root_brent};

use super::least::least;

/// How closely the minimum search looks for η (radians).
const LEAST_TOLERANCE: f64 = 1e-5;
/// The part of `width_tol` by which the minimum search may miss an end width and still be trusted.
const TRUSTED: f64 = 0.5;
/// Where the root search starts: this far from 0 and π.
const OUTERMOST: f64 = 1e-13;
/// Where the root search ends (radians).
const ROOT_TOLERANCE: f64 = 1e-15;

/// Draws a change of width without current crowding.
///
/// It is flat below, on y = 0, or symmetric about it.
///
/// Two equal widths give a square.
///
/// # Ports
/// `1` at the start, facing 180°; `2` at the end, facing 0°.
///
/// # Info
/// `num_squares`: length over width, summed along the edge of a step that is not symmetric, before
/// `anticrowding_factor` stretches it.
///
/// # Errors
/// The widths must be equal, or differ by more than `width_tol` of both.
///
/// # Numerics
/// `num_pts` points, evenly spaced along x before stretching. The curve starts where the wire is wider than the narrow end
/// by the factor `1 + width_tol` and ends where it is narrower than the wide end by the factor `1 − width_tol`; there it
/// steps to the full width. Points are within `width_tol · wide width` of the exact curve (for a ratio of widths of 10 within
/// 3e-5 of the wide width).
///
/// # Differences from PHIDL
/// Ratios of widths above about 35 are solved exactly. PHIDL's search fails there and draws the step too short.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let step = pg::OptimalStepParams::default().start_width(1).end_width(5).build()?;
/// assert_eq!((step.port("1")?.width(), step.port("2")?.width()), (1.0, 5.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// J. R. Clem and K. K. Berggren, "Geometry-dependent critical currents in superconducting nanocircuits", Phys. Rev. B
/// 84, 174510 (2011), <https://doi.org/10.1103/PhysRevB.84.174510>.
#[device(picture = "docs/optimal_step.svg")]
pub fn optimal_step(
    /// Width at the start.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    start_width: f64,
    /// Width at the end.
    #[default(22.0)]
    #[param(unit = "um", above = 0.0)]
    end_width: f64,
    /// Number of points along the edge.
    #[default(50)]
    #[param(min = 2, max = 100000)]
    num_pts: usize,
    /// How close to the end widths the edge comes, as a part of them.
    #[default(1e-3)]
    #[param(above = 0.0, below = 1.0)]
    width_tol: f64,
    /// Stretch factor along x of the streamline; 1 draws the streamline itself.
    #[default(1.2)]
    #[param(above = 0.0)]
    anticrowding_factor: f64,
    /// Widen on both sides.
    #[default(false)]
    symmetric: bool,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let (narrow, wide) = (start_width.min(end_width), start_width.max(end_width));
    let mut d = Device::builder("step");
    let outline = if narrow == wide {
        d.info("num_squares", 1);
        square(narrow, symmetric)
    } else {
        let ends = (narrow * (1.0 + width_tol), wide * (1.0 - width_tol));
        check.unit("µm").less("width of the curve at its narrow end", ends.0, ("that at its wide end", ends.1))?;
        let edge = Flow::new(narrow, wide).edge(ends, num_pts)?;
        d.info("num_squares", squares(&edge));
        let turned = if start_width > end_width { -1.0 } else { 1.0 };
        step(&edge, symmetric, turned * anticrowding_factor)
    };
    // Of the outline, not of the drawing: there is none without a layer.
    let (left, right) = outline.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, r), p| (l.min(p.x), r.max(p.x)));
    d.add_polygon(outline, layer)?;
    let middle = |width: f64| if symmetric { 0.0 } else { width / 2.0 };
    d.add_port("1", ((left, middle(start_width)), start_width, 180))?;
    d.add_port("2", ((right, middle(end_width)), end_width, 0))?;
    d.build()
}

fn square(width: f64, symmetric: bool) -> Vec<Point> {
    let (low, high) = if symmetric { (-width / 2.0, width / 2.0) } else { (0.0, width) };
    [(0.0, low), (0.0, high), (width, high), (width, low)].map(Point::from).to_vec()
}

/// The outline over (or around) the x axis, stretched along it.
fn step(edge: &[Point], symmetric: bool, stretch: f64) -> Vec<Point> {
    if symmetric {
        let half = |p: &Point, side: f64| Point::new(p.x * stretch / 2.0, side * p.y / 2.0);
        return edge.iter().map(|p| half(p, 1.0)).chain(edge.iter().rev().map(|p| half(p, -1.0))).collect();
    }
    let (first, last) = (edge[0], edge[edge.len() - 1]);
    let base = [Point::new(last.x, 0.0), Point::new(first.x, 0.0)];
    edge.iter().copied().chain(base).map(|p| Point::new(p.x * stretch, p.y)).collect()
}

/// Length over mean width, summed.
fn squares(edge: &[Point]) -> f64 {
    edge.windows(2).map(|p| (p[1].x - p[0].x) / ((p[0].y + p[1].y) / 2.0)).sum()
}

/// The current through a step from a narrow to a wide strip with one common side.
struct Flow {
    narrow: f64,
    wide: f64,
    gamma: f64,
}

/// The search for a point on the edge.
#[derive(Clone, Copy)]
enum Search {
    Least,
    Root,
}

impl Flow {
    fn new(narrow: f64, wide: f64) -> Self {
        let (w2, a2) = (narrow * narrow, wide * wide);
        Self { narrow, wide, gamma: (a2 + w2) / (a2 - w2) }
    }

    /// The edge between two heights: evenly spaced along x, the ends at the full widths.
    fn edge(&self, ends: (f64, f64), points: usize) -> Result<Vec<Point>> {
        let found = self.finds(ends.0, self.narrow) && self.finds(ends.1, self.wide);
        let search = if found { Search::Least } else { Search::Root };
        let x_at = |height: f64| Ok::<_, Error>(self.at(self.eta(|p| p.y - height, search)?).x);
        let mut edge = linspace(x_at(ends.0)?, x_at(ends.1)?, points)
            .map(|x| Ok(Point::new(x, self.at(self.eta(|p| p.x - x, search)?).y)))
            .collect::<Result<Vec<_>>>()?;
        edge[0].y = self.narrow;
        edge[points - 1].y = self.wide;
        Ok(edge)
    }

    /// Whether the minimum search finds a height that stands for one of the full widths.
    fn finds(&self, height: f64, width: f64) -> bool {
        let found = self.at(self.least(|p| p.y - height)).y;
        (found - height).abs() <= TRUSTED * (height - width).abs()
    }

    /// The point of the edge with the parameter η: the wide end at 0, the narrow one at π.
    fn at(&self, eta: f64) -> Point {
        let (narrow, wide, gamma) = (self.narrow, self.wide, self.gamma);
        let omega = Complex64::from_polar(1.0, eta);
        let lower = ((omega - gamma) / (gamma + 1.0)).sqrt().atan();
        let upper = ((gamma - 1.0) / (omega - gamma)).sqrt().atan();
        let zeta = Complex64::i() * (4.0 / PI) * (narrow * lower + wide * upper);
        Point::new(zeta.re, zeta.im)
    }

    /// Where a quantity that changes its sign once along the edge is zero.
    fn eta(&self, off: impl Fn(Point) -> f64, search: Search) -> Result<f64> {
        match search {
            Search::Least => Ok(self.least(off)),
            Search::Root => self.root(off),
        }
    }

    fn least(&self, off: impl Fn(Point) -> f64) -> f64 {
        least(|eta| off(self.at(eta)).powi(2), 0.0, PI, LEAST_TOLERANCE)
    }

    fn root(&self, off: impl Fn(Point) -> f64) -> Result<f64> {
        let mut until = SimpleConvergency { eps: ROOT_TOLERANCE, max_iter: 300 };
        find_root_brent(OUTERMOST, PI - OUTERMOST, |eta| off(self.at(eta)), &mut until)
            .map_err(|error| Error::custom("optimal_step", format_args!("no edge between these widths: {error}")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::outlines_are_simple;
    use proptest::prelude::*;

    #[test]
    fn the_default_step_is_that_of_the_specification() {
        let d = OptimalStepParams::default().build().unwrap();
        assert!((d.info()["num_squares"].as_f64().unwrap() - 7.98589108).abs() < 1e-8);
        let points: Vec<Point> = d.polygons().next().unwrap().points.to_vec();
        for (i, x, y) in [
            (0, -38.13212, 10.0),
            (1, -35.05448, 10.01496),
            (10, -7.35579, 10.5578),
            (24, 35.73106, 19.88155),
            (40, 84.97317, 21.88574),
            (49, 112.67186, 22.0),
        ] {
            assert!(points[i].distance(Point::new(x, y)) < 1e-5, "{i} {}", points[i]);
        }
    }

    #[test]
    fn the_root_search_finds_the_exact_end() {
        let flow = Flow::new(10.0, 22.0);
        let end = flow.at(flow.root(|p| p.y - 22.0 * 0.999).unwrap());
        assert!((end.x - 93.8866).abs() < 1e-4 && (end.y - 21.978).abs() < 1e-9, "{end}");
    }

    #[test]
    fn ports_do_not_need_a_layer() {
        let [with, without] =
            [Layers::from(1), Layers::NONE].map(|l| OptimalStepParams::default().layer(l).build().unwrap());
        assert!(with.ports().eq(without.ports()));
    }

    #[test]
    fn widths_far_apart_are_joined_in_full_length() {
        let params = OptimalStepParams::default().start_width(1).end_width(1000).anticrowding_factor(1);
        let d = params.build().unwrap();
        assert!((d.xmax() - 4551.39).abs() < 0.01, "{:?}", d.bbox());
    }

    #[test]
    fn the_edge_satisfies_the_flow_far_away() {
        // Far from the step the edge comes near the full width exponentially, as exp(−π x / (2 · width)).
        let flow = Flow::new(1.0, 3.0);
        let gap = |x: f64| 3.0 - flow.at(flow.root(|p| p.x - x).unwrap()).y;
        let decay = (gap(12.0) / gap(15.0)).ln() / 3.0;
        assert!((decay - PI / 6.0).abs() < 1e-3, "{decay}");
    }

    #[test]
    fn equal_widths_make_a_square_and_nearly_equal_ones_are_refused() {
        let d = OptimalStepParams::default().start_width(10).end_width(10).symmetric(true).build().unwrap();
        assert_eq!(d.bbox(), Some(Rect::new((0, -5), (10, 5))));
        let error = OptimalStepParams::default().start_width(10).end_width(10.0000001).build().unwrap_err();
        assert!(error.to_string().starts_with("optimal_step: width of the curve at its narrow end is 10.0"), "{error}");
        assert!(OptimalStepParams::default().start_width(10).end_width(10.1).build().is_ok());
    }

    #[test]
    fn a_step_down_is_a_step_up_seen_in_a_mirror() {
        let outline = |a: f64, b: f64| {
            let d = OptimalStepParams::default().start_width(a).end_width(b).build().unwrap();
            d.polygons().next().unwrap().points.to_vec()
        };
        let mirrored: Vec<Point> = outline(3.0, 1.0).iter().map(|p| Point::new(-p.x, p.y)).collect();
        assert_eq!(outline(1.0, 3.0), mirrored);
    }

    proptest! {
        #[test]
        fn both_searches_find_the_same_edge(narrow in 0.1..10.0_f64, ratio in 1.05..15.0_f64) {
            let flow = Flow::new(narrow, narrow * ratio);
            let wide = narrow * ratio;
            let (from, to) = (-4.0 * narrow, 2.0 * wide);
            for x in linspace(from, to, 20) {
                let least = flow.at(flow.least(|p| p.x - x)).y;
                let root = flow.at(flow.root(|p| p.x - x).unwrap()).y;
                prop_assert!((least - root).abs() < 1e-3 * wide, "{least} {root}");
            }
        }

        #[test]
        fn the_edge_rises_from_one_width_to_the_other(
            a in 0.1..50.0_f64, b in 0.1..50.0_f64, n in 2..80_usize, symmetric in any::<bool>(),
        ) {
            prop_assume!((a / b - 1.0).abs() > 0.01);
            let params = OptimalStepParams::default().start_width(a).end_width(b).num_pts(n).symmetric(symmetric);
            let d = params.build().unwrap();
            prop_assert!((d.size().height - a.max(b)).abs() < 1e-9);
            prop_assert!(outlines_are_simple(&d));
            let points = d.polygons().next().unwrap().points.to_vec();
            let up = if a < b { 1.0 } else { -1.0 };
            prop_assert!(points[..n].windows(2).all(|p| up * p[0].x < up * p[1].x && p[0].y <= p[1].y + 1e-3 * a.max(b)));
            prop_assert_eq!(d.port("1").unwrap().midpoint().x, d.xmin());
            prop_assert_eq!(d.port("2").unwrap().midpoint().x, d.xmax());
        }
    }
}
