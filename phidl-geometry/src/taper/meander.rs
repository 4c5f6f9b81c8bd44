//! [`meander_taper`]: a long taper folded into rows.
//!
//! Rows and turns follow the profile point by point. PHIDL draws straight sides between the ends of a row and always full
//! rows, so that a long row replaces a curved profile by a line. `straight_sections` draws PHIDL's rows, for masks that
//! must not change.

use phidl_core::num::count::linspace;
use phidl_core::prelude::*;
use phidl_macros::device;

/// Points on each side of the first row, of the others, and of a turn.
const FIRST_ROW_POINTS: usize = 50;
const ROW_POINTS: usize = 30;
const TURN_POINTS: usize = 72;
/// More rows than this are taken for a mistake.
const MOST_ROWS: f64 = 1e5;

/// Draws a taper of any profile, folded into rows that are joined by half circles.
///
/// ```text
///   1 ─━━━━━━━━━━━━╮
///      ╭━━━━━━━━━━━╯     rows meander_length long,
///      ╰────────────╮    turns to the right and to the left in turn
///     2 ────────────╯
/// ```
///
/// Widths between the points of the profile are interpolated; beyond its ends they stay constant. The last row ends with the
/// profile. If the profile ends inside a turn, the turn is the last section.
///
/// # Ports
/// `1` at the start, at the origin, facing 180°; `2` at the end.
///
/// # Errors
/// The profile must have as many widths as positions and at least two of both; positions must increase. The radius of a
/// turn is the larger of `spacing_factor` times the width before it and `min_spacing`. It must be at least half the width
/// in the turn, and large enough that neighboring rows do not touch.
///
/// # Numerics
/// 50 points on each side of the first row, 30 on each side of the others, and the points of the profile, so that rows
/// follow it exactly. 72 points on each side of a turn. With `straight_sections` the points are PHIDL's. Sections are
/// polygons of one cell with shared corners, so that no grid opens a gap between them.
///
/// # Differences from PHIDL
/// Rows follow the profile, and the last one ends with it.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let d = pg::MeanderTaperParams::new([0, 50, 100], [1, 3, 4]).meander_length(30).build()?;
/// assert_eq!(d.port("2")?.width(), 4.0);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `meander_taper`.
#[device(picture = "docs/meander_taper.svg", example = MeanderTaperParams::new([0, 50, 100], [1, 3, 4]).meander_length(30))]
pub fn meander_taper(
    /// Positions along the line at which the width is given.
    #[param(unit = "um")]
    x_taper: Vec<f64>,
    /// Widths at these positions.
    #[param(unit = "um", min = 0.0)]
    w_taper: Vec<f64>,
    /// Length of a row.
    #[default(1000.0)]
    #[param(unit = "um", above = 0.0)]
    meander_length: f64,
    /// Radius of a turn, as a multiple of the width before it.
    #[default(3.0)]
    #[param(min = 0.0)]
    spacing_factor: f64,
    /// Smallest radius of a turn.
    #[default(0.5)]
    #[param(unit = "um", min = 0.0)]
    min_spacing: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
    /// Draw every row in full length and with straight sides between the widths at its ends, as PHIDL does.
    #[default(false)]
    #[param(named)]
    straight_sections: bool,
) -> Result<Device> {
    let params =
        MeanderTaperParams { x_taper, w_taper, meander_length, spacing_factor, min_spacing, layer, straight_sections };
    let mut d = params.assembled()?;
    d.flatten()?;
    d.build()
}

impl MeanderTaperParams {
    /// All sections, connected, as references.
    fn assembled(&self) -> Result<DeviceBuilder> {
        let check = Self::entry().check();
        let profile = WidthProfile::new(check, &self.x_taper, &self.w_taper)?;
        let rows = (profile.end() - profile.start()) / self.meander_length;
        check.at_most("number of rows", rows, MOST_ROWS)?;
        let fold = Fold {
            check: check.unit("µm"),
            profile,
            meander_length: self.meander_length,
            spacing_factor: self.spacing_factor,
            min_spacing: self.min_spacing,
            straight: self.straight_sections,
        };
        fold.assembled(&self.layer)
    }
}

/// The width along the line.
struct WidthProfile<'a> {
    x: &'a [f64],
    w: &'a [f64],
}

impl<'a> WidthProfile<'a> {
    fn new(check: Check<'_>, x: &'a [f64], w: &'a [f64]) -> Result<Self> {
        check.that(
            "number of w_taper",
            w.len(),
            w.len() == x.len(),
            &format!("be {}, the number of x_taper", x.len()),
        )?;
        check.at_least("number of x_taper", x.len(), 2)?;
        for (i, pair) in x.windows(2).enumerate() {
            check.greater(&format!("x_taper[{}]", i + 1), pair[1], ("the position before it", pair[0]))?;
        }
        Ok(Self { x, w })
    }

    fn start(&self) -> f64 {
        self.x[0]
    }

    fn end(&self) -> f64 {
        self.x[self.x.len() - 1]
    }

    /// The positions of the profile between two positions.
    fn between(&self, start: f64, end: f64) -> &'a [f64] {
        &self.x[self.x.partition_point(|x| *x < start)..self.x.partition_point(|x| *x < end)]
    }

    fn width(&self, at: f64) -> f64 {
        let after = self.x.partition_point(|x| *x <= at);
        if after == 0 || after == self.x.len() {
            return self.w[after.saturating_sub(1)];
        }
        let (before, part) = (after - 1, (at - self.x[after - 1]) / (self.x[after] - self.x[after - 1]));
        self.w[before] + (self.w[after] - self.w[before]) * part
    }
}

/// The folding of a profile into rows and turns.
struct Fold<'a> {
    /// In micrometers.
    check: Check<'a>,
    profile: WidthProfile<'a>,
    meander_length: f64,
    spacing_factor: f64,
    min_spacing: f64,
    straight: bool,
}

/// An interval of positions on the line (µm).
#[derive(Clone, Copy)]
struct Interval {
    start: f64,
    end: f64,
}

/// A section of the line, drawn as one cell.
enum Section {
    /// With this many points on each side.
    Row(Interval, usize),
    Turn {
        span: Interval,
        radius: f64,
        left: bool,
    },
}

impl Fold<'_> {
    /// All sections, connected, as references.
    fn assembled(&self, layer: &Layers) -> Result<DeviceBuilder> {
        let mut d = Device::builder("meander-taper");
        let mut end = Port::new((0, 0), 0, 0);
        for (i, section) in self.sections()?.iter().enumerate() {
            let mut placed = self.draw(section, layer)?.place();
            placed.connect("1", &end)?;
            if i == 0 {
                d.add_port("1", placed.port("1")?)?;
            }
            end = placed.port("2")?;
            d.add(placed);
        }
        d.add_port("2", end)?;
        Ok(d)
    }

    /// The sections of the line in order.
    fn sections(&self) -> Result<Vec<Section>> {
        let mut row = self.row_from(self.profile.start());
        let mut sections = vec![Section::Row(row, FIRST_ROW_POINTS)];
        let mut left = false;
        while row.end < self.profile.end() {
            let radius = (self.spacing_factor * self.profile.width(row.end)).max(self.min_spacing);
            let span = Interval { start: row.end, end: row.end + PI * radius };
            self.check_turn(span, radius)?;
            sections.push(Section::Turn { span, radius, left });
            let next = self.row_from(span.end);
            if next.end > next.start {
                self.check_rows(row, next, radius)?;
                sections.push(Section::Row(next, ROW_POINTS));
            }
            (row, left) = (next, !left);
        }
        Ok(sections)
    }

    /// The row that starts here; of no length if nothing is left of the profile.
    fn row_from(&self, start: f64) -> Interval {
        let full = start + self.meander_length;
        let end = if self.straight { full } else { full.min(self.profile.end()).max(start) };
        Interval { start, end }
    }

    /// The drawn width at a position.
    fn width(&self, Interval { start, end }: Interval, at: f64) -> f64 {
        if !self.straight {
            return self.profile.width(at);
        }
        let (first, last) = (self.profile.width(start), self.profile.width(end));
        first + (last - first) * ((at - start) / (end - start))
    }

    fn check_turn(&self, Interval { start, end }: Interval, radius: f64) -> Result<()> {
        let widest = self.profile.width(start).max(self.profile.width(end));
        self.check.greater("radius of a turn", radius, 0)?;
        self.check.at_least("radius of a turn", radius, ("half of the width in it", widest / 2.0))
    }

    /// Two neighboring rows must not overlap anywhere.
    fn check_rows(&self, before: Interval, after: Interval, radius: f64) -> Result<()> {
        linspace(0.0, after.end - after.start, FIRST_ROW_POINTS).try_for_each(|x| {
            let widths = self.width(before, before.end - x) + self.width(after, after.start + x);
            self.check.at_least("distance of rows", 2.0 * radius, ("half of both widths", widths / 2.0))
        })
    }

    /// A section as a cell, from the origin along x.
    fn draw(&self, section: &Section, layer: &Layers) -> Result<Device> {
        match *section {
            Section::Row(span, points) => self.row(span, points, layer),
            Section::Turn { span, radius, left } => self.turn(span, radius, left, layer),
        }
    }

    fn row(&self, span: Interval, points: usize, layer: &Layers) -> Result<Device> {
        let Interval { start, end } = span;
        let mut positions: Vec<f64> = linspace(start, end, points).collect();
        if !self.straight {
            positions.extend(self.profile.between(start, end));
            positions.sort_by(f64::total_cmp);
            positions.dedup();
        }
        let at = |position: f64, sign: f64| Point::new(position - start, sign * self.width(span, position) / 2.0);
        let upper = positions.iter().map(|position| at(*position, 1.0));
        let lower = positions.iter().rev().map(|position| at(*position, -1.0));
        let mut d = Device::builder("tapersec");
        d.add_polygon(upper.chain(lower).collect::<Vec<_>>(), layer)?;
        d.add_port("1", ((0, 0), self.width(span, start), 180))?;
        d.add_port("2", ((end - start, 0.0), self.width(span, end), 0))?;
        d.build()
    }

    /// A half circle that starts along x: outer edge, then inner edge back.
    fn turn(&self, span: Interval, radius: f64, left: bool, layer: &Layers) -> Result<Device> {
        let side = if left { 1.0 } else { -1.0 };
        let center = Point::new(0.0, side * radius);
        let steps = linspace(-90.0 * side, 90.0 * side, TURN_POINTS).zip(linspace(span.start, span.end, TURN_POINTS));
        let at =
            |angle, position, side: f64| center + Point::polar(radius + side * self.width(span, position) / 2.0, angle);
        let outer = steps.clone().map(|(angle, position)| at(angle, position, 1.0));
        let inner = steps.rev().map(|(angle, position)| at(angle, position, -1.0));
        let mut d = Device::builder("arctaper");
        d.add_polygon(outer.chain(inner).collect::<Vec<_>>(), layer)?;
        d.add_port("1", ((0, 0), self.width(span, span.start), 180))?;
        d.add_port("2", ((0.0, 2.0 * side * radius), self.width(span, span.end), 180))?;
        d.build()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::outlines_are_simple;
    use proptest::prelude::*;

    /// The sections of a taper as references.
    fn sections(params: MeanderTaperParams) -> Device {
        params.assembled().unwrap().build().unwrap()
    }

    fn evenly(straight: bool) -> Device {
        let x: Vec<f64> = (0..=10).map(|i| 10.0 * f64::from(i)).collect();
        let w: Vec<f64> = x.iter().map(|x| 1.0 + x / 100.0).collect();
        sections(MeanderTaperParams::new(x, w).meander_length(30).straight_sections(straight))
    }

    #[test]
    fn rows_in_full_length_are_those_of_the_specification() {
        let d = evenly(true);
        let vertices: Vec<usize> =
            d.references().iter().map(|r| r.device().polygons().next().unwrap().points.len()).collect();
        assert_eq!(vertices, [100, 144, 60, 144, 60]);
        let widths: Vec<f64> = d.references().iter().map(|r| r.port("2").unwrap().width()).collect();
        for (width, measured) in widths.iter().zip([1.3, 1.422522, 1.722522, 1.884866, 2.0]) {
            assert!((width - measured).abs() < 1e-6, "{widths:?}");
        }
        let end = d.port("2").unwrap();
        assert!(end.midpoint().distance(Point::new(30.0, -18.135133)) < 1e-6 && end.orientation() == 0.0);
        let (min, max) = (Point::new(-6.0685, -19.135133), Point::new(34.579941, 0.65));
        let bbox = d.bbox().unwrap();
        assert!(bbox.min.distance(min) < 1e-4 && bbox.max.distance(max) < 1e-4, "{bbox:?}");
    }

    #[test]
    fn the_last_row_ends_with_the_profile() {
        let d = evenly(false);
        let (full, turns) = (evenly(true), PI * 3.0 * (1.3 + 1.0 + 0.3 + PI * 0.039 + 0.3));
        let last_row = 100.0 - 60.0 - turns;
        assert!((d.port("2").unwrap().midpoint().x - last_row).abs() < 1e-9);
        // An even taper is drawn alike up to there.
        for (ours, theirs) in d.references().iter().zip(full.references()).take(4) {
            assert!(ours.port("2").unwrap().midpoint().distance(theirs.port("2").unwrap().midpoint()) < 1e-9);
        }
    }

    #[test]
    fn a_row_follows_a_profile_through_its_corners() {
        let d = sections(MeanderTaperParams::new([0, 7, 40], [2, 6, 3]).meander_length(100));
        let row = d.references()[0].device();
        assert!(row.polygons().next().unwrap().points.contains(&Point::new(7.0, 3.0)));
        // Two trapezoids.
        assert!((row.area() - (7.0 * 4.0 + 33.0 * 4.5)).abs() < 1e-9, "{}", row.area());
        assert_eq!(d.port("2").unwrap().midpoint(), Point::new(40.0, 0.0));
    }

    #[test]
    fn a_profile_that_ends_in_a_turn_ends_with_the_turn() {
        let d = sections(MeanderTaperParams::new([0, 31], [1, 1]).meander_length(30));
        assert_eq!(d.references().len(), 2);
        assert_eq!(d.port("2").unwrap().orientation(), 180.0);
    }

    #[test]
    fn profiles_and_spacings_that_cannot_be_drawn_are_refused() {
        let refused = |x: &[f64], w: &[f64], factor: f64| {
            let params = MeanderTaperParams::new(x.to_vec(), w.to_vec()).meander_length(10).spacing_factor(factor);
            params.build().unwrap_err().to_string()
        };
        assert_eq!(
            refused(&[0.0, 20.0, 20.0], &[1.0; 3], 3.0),
            "meander_taper: x_taper[2] is 20 µm, but it must be greater than the position before it, 20 µm"
        );
        assert!(
            refused(&[0.0, 20.0], &[1.0; 3], 3.0)
                .contains("number of w_taper is 3, but it must be 2, the number of x_taper")
        );
        assert!(refused(&[0.0], &[1.0], 3.0).contains("must be at least 2"));
        assert!(refused(&[0.0, 20.0], &[4.0, 4.0], 0.4).contains("radius of a turn is 1.6 µm"));
        assert!(refused(&[0.0, 9.0, 10.0, 40.0], &[40.0, 40.0, 1.0, 1.0], 3.0).contains("distance of rows is 6 µm"));
    }

    proptest! {
        #[test]
        fn sections_meet_at_one_width_and_cover_the_profile_once(
            w in prop::collection::vec(0.5..4.0_f64, 2..8), length in 20.0..200.0_f64,
        ) {
            let x: Vec<f64> = (0..w.len()).map(|i| 50.0 * i as f64).collect();
            // Wide turns, so that no rows touch.
            let params = MeanderTaperParams::new(x.clone(), w.clone()).meander_length(length).min_spacing(4);
            let flat = params.build().unwrap();
            prop_assert!(flat.references().is_empty() && outlines_are_simple(&flat));
            let d = sections(params);
            for pair in d.references().windows(2) {
                let (end, start) = (pair[0].port("2").unwrap(), pair[1].port("1").unwrap());
                prop_assert!(end.midpoint().distance(start.midpoint()) < 1e-9);
                prop_assert!((end.width() - start.width()).abs() < 1e-9);
            }
            let area: f64 = w.windows(2).map(|w| 25.0 * (w[0] + w[1])).sum();
            let drawn: f64 = d.flat_polygons().map(|p| p.area()).sum();
            // A last turn is drawn whole, beyond the end of the profile.
            let ends_in_turn = d.references()[d.references().len() - 1].device().name() == "arctaper";
            let overshoot = if ends_in_turn { 13.0 * PI * w[w.len() - 1] } else { 0.0 };
            // A band of changing width around a circle covers width times the length of its middle, less what chords lose.
            prop_assert!(drawn > 0.999 * area && drawn < 1.001 * (area + overshoot), "{drawn} {area}");
        }
    }
}
