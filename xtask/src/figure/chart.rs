//! A chart with two logarithmic axes, as a device: what it shows is drawn with the library's own shapes and letters.

use pg::text::Justify;
use phidl_core::prelude::*;
use phidl_geometry as pg;

/// Axes, ticks and letters.
pub(super) const AXES: Layer = Layer::new(8, 0);
/// Lines behind the curves.
pub(super) const GRID: Layer = Layer::new(0, 0);

/// Size of the plot (µm; a pixel of the picture each).
const PLOT: Size = Size { width: 640.0, height: 360.0 };
/// Height of capitals.
const LETTERS: f64 = 13.0;
/// Width of curves.
const LINE: f64 = 2.5;
/// From the edge of the plot to the labels of its ticks.
const GAP: f64 = 10.0;

/// A curve.
pub(super) struct Series {
    pub(super) name: &'static str,
    pub(super) layer: Layer,
    /// Ascending in x; all above zero.
    pub(super) points: Vec<(usize, f64)>,
}

/// A chart of some curves.
pub(super) struct Chart {
    pub(super) title: String,
    pub(super) x: &'static str,
    pub(super) y: &'static str,
    pub(super) series: Vec<Series>,
}

/// An axis: the decimal logarithms of its ends, and its length.
#[derive(Clone, Copy)]
struct Axis {
    low: f64,
    high: f64,
    length: f64,
}

impl Axis {
    /// From the power of ten below all values to a little above them.
    fn around(values: impl Iterator<Item = f64> + Clone, length: f64) -> Self {
        let low = values.clone().map(f64::log10).fold(f64::INFINITY, f64::min).floor();
        let high = values.map(f64::log10).fold(f64::NEG_INFINITY, f64::max);
        Self { low, high: high.max(low + 1.0) + 0.05, length }
    }

    fn at(self, value: f64) -> f64 {
        (value.log10() - self.low) / (self.high - self.low) * self.length
    }

    /// Every power of ten, and the whole numbers between; the powers are marked.
    fn ticks(self) -> Vec<(f64, bool)> {
        let mut ticks = Vec::new();
        let mut power = self.low;
        while power < self.high {
            ticks.extend((1..10).map(|digit| (f64::from(digit) * 10_f64.powf(power), digit == 1)));
            power += 1.0;
        }
        ticks.retain(|(value, _)| value.log10() <= self.high);
        ticks
    }
}

impl Chart {
    /// The chart, its plot with the lower left corner at the origin.
    pub(super) fn draw(&self) -> Result<Device> {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let x = Axis::around(points().map(|&(parts, _)| parts as f64), PLOT.width);
        let y = Axis::around(points().map(|&(_, seconds)| seconds), PLOT.height);
        let mut d = Device::builder("chart");
        draw_x_axis(&mut d, x)?;
        draw_y_axis(&mut d, y)?;
        for series in &self.series {
            draw_series(&mut d, series, x, y)?;
        }
        let mut title = words(&self.title, AXES)?;
        title.set_center((PLOT.width / 2.0, PLOT.height + 2.0 * LETTERS));
        let mut below = words(self.x, AXES)?;
        below.set_center((PLOT.width / 2.0, -4.0 * LETTERS));
        let mut beside = words(self.y, AXES)?.rotated(90);
        beside.set_center((-5.5 * LETTERS, PLOT.height / 2.0));
        for label in [title, below, beside] {
            d.add(label);
        }
        d.build()
    }
}

fn draw_x_axis(d: &mut DeviceBuilder, axis: Axis) -> Result<()> {
    for (value, is_power) in axis.ticks() {
        let at = axis.at(value);
        stroke(d, (at, 0.0), (at, PLOT.height), if is_power { 1.0 } else { 0.4 }, GRID)?;
        if is_power {
            let mut label = words(&format!("{value}"), AXES)?;
            label.set_center((at, -GAP - LETTERS / 2.0));
            d.add(label);
        }
    }
    stroke(d, (0.0, 0.0), (PLOT.width, 0.0), 1.5, AXES)
}

fn draw_y_axis(d: &mut DeviceBuilder, axis: Axis) -> Result<()> {
    for (value, is_power) in axis.ticks() {
        let at = axis.at(value);
        stroke(d, (0.0, at), (PLOT.width, at), if is_power { 1.0 } else { 0.4 }, GRID)?;
        if is_power {
            let mut label = words(&format!("{value}"), AXES)?;
            label.set_y(at);
            label.set_xmax(-GAP);
            d.add(label);
        }
    }
    stroke(d, (0.0, 0.0), (0.0, PLOT.height), 1.5, AXES)
}

/// A curve with a dot at each point and its name at the end.
fn draw_series(d: &mut DeviceBuilder, series: &Series, x: Axis, y: Axis) -> Result<()> {
    let places: Vec<(f64, f64)> =
        series.points.iter().map(|&(parts, seconds)| (x.at(parts as f64), y.at(seconds))).collect();
    let dot = pg::circle(2.0 * LINE, 10, series.layer)?;
    places.windows(2).try_for_each(|pair| stroke(d, pair[0], pair[1], LINE, series.layer))?;
    for &place in &places {
        d.add(dot.place().moved_by(place));
    }
    if let Some(&(_, end)) = places.last() {
        let mut name = words(series.name, series.layer)?;
        name.set_xmin(PLOT.width + GAP);
        name.set_y(end);
        d.add(name);
    }
    Ok(())
}

fn words(text: &str, layer: Layer) -> Result<Reference> {
    Ok(pg::text(text, LETTERS, Justify::Left, layer, "DEPLOF")?.place())
}

/// A straight line with square ends.
fn stroke(d: &mut DeviceBuilder, from: (f64, f64), to: (f64, f64), width: f64, layer: Layer) -> Result<()> {
    let (from, to) = (Point::from(from), Point::from(to));
    let along = (to - from) * (0.5 * width / from.distance(to));
    let across = Point::new(-along.y, along.x);
    let corners = [from - along - across, to + along - across, to + along + across, from - along + across];
    d.add_polygon(corners, layer).map(drop)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_begin_at_a_power_of_ten_and_place_values_by_their_logarithm() {
        let axis = Axis::around([0.02, 3.0].into_iter(), 300.0);
        assert_eq!((axis.low, axis.at(0.01)), (-2.0, 0.0));
        assert!((axis.at(1.0) - 2.0 * axis.at(0.1)).abs() < 1e-9 && axis.at(3.0) < 300.0);
        assert_eq!(axis.ticks().iter().filter(|(_, is_power)| *is_power).count(), 3);
        assert_eq!(axis.ticks().len(), 9 + 9 + 3);
        let one = Axis::around([1.0].into_iter(), 10.0);
        assert_eq!((one.at(1.0), one.ticks().len()), (0.0, 10));
    }

    #[test]
    fn curves_stay_in_the_plot_and_are_named() {
        let series = Series { name: "one", layer: Layer::new(1, 0), points: vec![(1, 0.5), (10, 0.02), (90, 4.0)] };
        let chart = Chart { title: "title".into(), x: "parts", y: "seconds", series: vec![series] };
        let drawn = chart.draw().unwrap();
        assert_eq!(drawn.layers(), [GRID, Layer::new(1, 0), AXES]);
        let mut curve = drawn.edit();
        curve.keep_layers(Layer::new(1, 0), LayerTarget::All);
        let bbox = curve.build().unwrap().bbox().unwrap();
        assert!(bbox.min.x > -2.0 * LINE - 0.1 && bbox.max.y < PLOT.height && bbox.max.x > PLOT.width);
    }
}
