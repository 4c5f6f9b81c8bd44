//! [`Fillet`] and [`filleted`]: rounded corners.

use std::f64::consts::TAU;

use phidl_core::num::count;
use phidl_core::prelude::*;

/// Points of a full turn of a rounded corner, unless asked otherwise: PHIDL's default.
const POINTS_PER_TURN: f64 = 128.0;
/// Largest share of each adjacent edge that a rounding takes; a little less than half, so that two rounded corners never
/// meet in one point.
const MOST_OF_AN_EDGE: f64 = 0.49;
/// A corner that turns by less than this (radians) is straight and stays one point.
const STRAIGHT: f64 = 1e-6;
/// Largest number of points of a rounded outline.
const MOST_POINTS: f64 = 1e7;

/// Rounds the corners of an outline: one radius for all corners, or one for each.
///
/// A rounding is an arc that touches both edges of the corner. A radius that takes more than 49 % of an adjacent edge is
/// reduced to that. Corners that repeat the one before count once.
///
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// use pg::polygon::Fillet;
/// let square = [(0, 0), (10, 0), (10, 10), (0, 10)].map(Point::from);
/// let mut d = Device::builder("pads");
/// d.add_polygon(Fillet::new(2).of(&square)?, 1)?;
/// d.add_polygon(Fillet::each([2, 0, 0, 2]).points_per_turn(64).of(&square)?, 2)?;
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Fillet {
    radii: Radii,
    points_per_turn: f64,
}

#[derive(Debug, Clone, PartialEq)]
enum Radii {
    All(f64),
    Each(Vec<f64>),
}

impl Fillet {
    /// One radius for all corners (µm).
    #[must_use]
    pub fn new(radius: impl Into<f64>) -> Self {
        Self { radii: Radii::All(radius.into()), points_per_turn: POINTS_PER_TURN }
    }

    /// One radius for each corner (µm); 0 keeps a corner.
    #[must_use]
    pub fn each<R: Into<f64>>(radii: impl IntoIterator<Item = R>) -> Self {
        let radii = radii.into_iter().map(Into::into).collect();
        Self { radii: Radii::Each(radii), points_per_turn: POINTS_PER_TURN }
    }

    /// Points of a full turn; 128 by default.
    #[must_use]
    pub fn points_per_turn(mut self, points: impl Into<f64>) -> Self {
        self.points_per_turn = points.into();
        self
    }

    /// The rounded outline.
    ///
    /// # Errors
    /// A radius below 0 or not finite; a number of radii other than that of the corners; fewer than 4 points a turn; more
    /// than 10⁷ points in all.
    pub fn of(&self, outline: &[Point]) -> Result<Vec<Point>> {
        let check = Check::new("fillet");
        let radii = match &self.radii {
            Radii::All(radius) => std::slice::from_ref(radius),
            Radii::Each(radii) => radii.as_slice(),
        };
        if let Radii::Each(radii) = &self.radii {
            let fits = radii.len() == outline.len();
            let rule = format!("be {}, one for each corner", outline.len());
            check.that("number of radii", radii.len(), fits, &rule)?;
        }
        for radius in radii {
            let valid = *radius >= 0.0 && radius.is_finite();
            check.that("radius", format_args!("{radius} µm"), valid, "be finite and at least 0 µm")?;
        }
        let points = self.points_per_turn;
        check.that("points_per_turn", points, points >= 4.0, "be at least 4")?;
        check.at_most("number of points", points * outline.len() as f64, MOST_POINTS)?;
        Ok(rounded(outline, points, |corner| radii[corner.min(radii.len() - 1)]))
    }
}

/// The outline with its corners rounded, each by its own radius (µm; 0 keeps the corner), with 128 points a turn.
///
/// The result begins with the last corner, as PHIDL's does. See [`Fillet`] for the checked form.
///
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry::polygon::filleted;
/// let square = [(0, 0), (10, 0), (10, 10), (0, 10)].map(Point::from);
/// let rounded = filleted(&square, |_| 1.0);
/// assert_eq!(rounded.len(), 4 * 32);
/// ```
#[must_use]
pub fn filleted(outline: &[Point], radius: impl Fn(usize) -> f64) -> Vec<Point> {
    rounded(outline, POINTS_PER_TURN, radius)
}

fn rounded(outline: &[Point], points_per_turn: f64, radius: impl Fn(usize) -> f64) -> Vec<Point> {
    let corners: Vec<usize> = (0..outline.len()).filter(|i| outline[*i] != outline[before(*i, outline)]).collect();
    let mut rounded = Vec::new();
    for turn in 0..corners.len() {
        let at = |offset: usize| corners[(turn + corners.len() - 2 + offset) % corners.len()];
        let corner = [outline[at(0)], outline[at(1)], outline[at(2)]];
        round_corner(corner, radius(at(1)), points_per_turn, &mut rounded);
    }
    rounded
}

fn before(i: usize, outline: &[Point]) -> usize {
    if i == 0 { outline.len() - 1 } else { i - 1 }
}

fn round_corner([previous, corner, next]: [Point; 3], radius: f64, points_per_turn: f64, rounded: &mut Vec<Point>) {
    let (incoming, outgoing) = (corner - previous, next - corner);
    let turn = incoming.cross(outgoing).atan2(incoming.dot(outgoing));
    let half_tangent = (turn.abs() / 2.0).tan();
    let longest = MOST_OF_AN_EDGE * incoming.norm().min(outgoing.norm());
    let radius = radius.min(longest / half_tangent);
    if turn.abs() <= STRAIGHT || radius <= 0.0 {
        rounded.push(corner);
        return;
    }
    let points = count::up(points_per_turn * turn.abs() / TAU).max(2);
    let start = corner - incoming * (radius * half_tangent / incoming.norm());
    // The center lies to the side that the outline turns to.
    let to_center = Point::new(-incoming.y, incoming.x) * (radius * turn.signum() / incoming.norm());
    let center = start + to_center;
    for step in count::linspace(0.0, turn, points) {
        let (sin, cos) = step.sin_cos();
        let spoke = -to_center;
        rounded.push(center + Point::new(spoke.x * cos - spoke.y * sin, spoke.x * sin + spoke.y * cos));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::signed_area;

    #[test]
    fn a_rounded_square_loses_the_area_outside_its_arcs() {
        let square = [(0, 0), (10, 0), (10, 10), (0, 10)].map(Point::from);
        for outline in [square, [square[3], square[2], square[1], square[0]]] {
            let area = signed_area(&filleted(&outline, |_| 2.0)).abs();
            // Four corners lose (4 - π) r² in all; 31 chords of a quarter circle lose a little more.
            assert!((area - (100.0 - (4.0 - PI) * 4.0)).abs() < 0.01, "{area}");
        }
    }

    #[test]
    fn one_inner_corner_is_rounded_within_half_an_edge() {
        let l = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 3), (0, 3)].map(Point::from);
        let rounded = filleted(&l, |i| if i == 3 { 5.0 } else { 0.0 });
        assert_eq!(rounded.len(), 5 + 32);
        let bend: Vec<&Point> = rounded.iter().filter(|p| p.distance(Point::new(2.49, 2.49)) < 0.4901).collect();
        assert_eq!(bend.len(), 32, "an arc of radius 0.49 about (2.49, 2.49)");
    }

    #[test]
    fn repeated_points_count_once() {
        let square = [(0, 0), (10, 0), (10, 10), (10, 10), (0, 10), (0, 0)].map(Point::from);
        assert_eq!(filleted(&square, |_| 0.0).len(), 4);
    }

    #[test]
    fn a_fillet_rounds_all_corners_or_each_by_its_radius() {
        let square = [(0, 0), (10, 0), (10, 10), (0, 10)].map(Point::from);
        assert_eq!(Fillet::new(2).of(&square).unwrap(), filleted(&square, |_| 2.0));
        let one = Fillet::each([3, 0, 0, 0]).points_per_turn(400).of(&square).unwrap();
        assert_eq!(one.len(), 3 + 100);
        assert!((signed_area(&one) - (100.0 - (1.0 - PI / 4.0) * 9.0)).abs() < 1e-3, "{}", signed_area(&one));
    }

    #[test]
    fn fillets_that_cannot_be_drawn_are_refused_with_their_rule() {
        let square = [(0, 0), (10, 0), (10, 10), (0, 10)].map(Point::from);
        let refused = |fillet: Fillet| fillet.of(&square).unwrap_err().to_string();
        assert_eq!(
            refused(Fillet::each([1, 2])),
            "fillet: number of radii is 2, but it must be 4, one for each corner"
        );
        let negative = refused(Fillet::new(-1));
        assert_eq!(negative, "fillet: radius is -1 µm, but it must be finite and at least 0 µm");
        assert!(
            refused(Fillet::new(f64::NAN)).contains("NaN") && refused(Fillet::new(1).points_per_turn(3)).contains("4")
        );
        assert!(refused(Fillet::new(1).points_per_turn(1e12)).contains("number of points"));
    }
}
