//! The operations under the names and options of KLayout's region engine: [`kl_boolean`], [`kl_offset`],
//! [`kl_outline`], [`kl_invert`].
//!
//! They run on the same engine as the others. What differs is kept: distances are rounded to whole grid steps, corners
//! follow `miter_mode`, and results are not cut to a number of points. What the specification calls defects is not:
//! coordinates are rounded instead of cut off, nothing is lost at tile borders, `B-A` is what it says, a negative
//! distance gives an inner frame, and there is one box to invert in.

use phidl_core::layer::Layers;
use phidl_core::scene::Device;

use super::{
    Border, IntoOperation, OpenPorts, Options, Shapes,
    boolean::{combined, named},
    invert,
    offset::Frame,
    operand::Operand,
};
use crate::{
    error::BooleanError,
    grid,
    offset::{Growth, Join},
    options::{Division, RunOptions},
    progress::Watch,
};

/// Extensions of the edges at a corner by miter mode, in distances.
const EXTENSIONS: [f64; 6] = [0.0, std::f64::consts::SQRT_2 - 1.0, 1.0, std::f64::consts::SQRT_2 + 1.0, 10.0, 100.0];

/// More divisions than this help nobody; a tile size of a few grid steps asks for billions.
const MOST_DIVISIONS: f64 = 1e6;

/// How a `kl_` function works: the grid, the division, the threads.
#[derive(Debug, Clone, Copy)]
pub struct KlOptions<'a> {
    /// The grid step (µm), greater than zero.
    pub precision: f64,
    /// About how large the parts are that are handed to the threads (µm), greater than zero; `None` leaves it to us.
    pub tile_size: Option<(f64, f64)>,
    /// The number of threads; `None` is one per core.
    pub num_cpu: Option<usize>,
    /// Receives progress and can cancel.
    pub watch: Option<&'a Watch>,
}

impl Default for KlOptions<'_> {
    fn default() -> Self {
        Self { precision: 1e-4, tile_size: None, num_cpu: None, watch: None }
    }
}

impl<'a> KlOptions<'a> {
    /// The same in the words of the other functions; tiles are counted over the box of the shapes.
    fn options(&self, shapes: &(impl Shapes + ?Sized)) -> Result<Options<'a>, BooleanError> {
        let division = match self.tile_size {
            None => Division::default(),
            Some((x, y)) => Division::Strips(self.tiles(x, y, shapes)?),
        };
        let run = RunOptions { division, threads: self.num_cpu, watch: self.watch };
        Ok(Options { precision: self.precision, max_points: None, run })
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to a million")]
    fn tiles(&self, x: f64, y: f64, shapes: &(impl Shapes + ?Sized)) -> Result<usize, BooleanError> {
        for value in [x, y] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(BooleanError::Option { option: "tile_size", value, rule: "greater than zero and finite" });
            }
        }
        let size = Operand::new("shapes", shapes)?.bbox().map_or((0.0, 0.0), |b| (b.size().width, b.size().height));
        let tiles = (size.0 / x).ceil().max(1.0) * (size.1 / y).ceil().max(1.0);
        Ok(tiles.min(MOST_DIVISIONS) as usize)
    }

    /// A length in µm, rounded to whole grid steps, halves to even.
    fn whole_steps(&self, length: f64) -> Result<f64, BooleanError> {
        let grid = grid::with_step(self.precision)?;
        Ok(grid.scaled(length).round_ties_even())
    }
}

/// How corners are joined in a miter mode from 0 (cut straight) over 2 (right angles are kept) to 5; above, as in 5.
fn growth(miter_mode: usize) -> Growth {
    Growth { join: Join::Capped { extension: EXTENSIONS[miter_mode.min(EXTENSIONS.len() - 1)] }, merge_first: true }
}

/// Runs a set operation; the result is called `boolean`. See [`boolean`](super::boolean()).
///
/// # Errors
/// As for [`boolean`](super::boolean()).
pub fn kl_boolean(
    a: &(impl Shapes + ?Sized),
    b: &(impl Shapes + ?Sized),
    operation: impl IntoOperation,
    layer: impl Into<Layers>,
    options: &KlOptions,
) -> Result<Device, BooleanError> {
    named("kl_boolean", || {
        let options = options.options(&(a, b))?;
        combined(a, b, operation.into_operation()?, &options)?.to_device("boolean", layer, &options)
    })
}

/// Grows or shrinks shapes by a distance in µm, rounded to whole grid steps; the result is called `offset`.
///
/// # Errors
/// As for [`offset`](super::offset()).
pub fn kl_offset(
    shapes: &(impl Shapes + ?Sized),
    distance: impl Into<f64>,
    miter_mode: usize,
    layer: impl Into<Layers>,
    options: &KlOptions,
) -> Result<Device, BooleanError> {
    named("kl_offset", || {
        let steps = options.whole_steps(distance.into())?;
        let options = options.options(shapes)?;
        let contours = Operand::new("shapes", shapes)?.contours(&options.grid()?)?;
        let region = grid::offset(&contours, steps, &growth(miter_mode), &options.run)?;
        region.to_device("offset", layer, &options)
    })
}

/// Draws a frame around or inside shapes; the result is called `outline`. See [`outline`](super::outline()).
///
/// # Errors
/// As for [`outline`](super::outline()).
pub fn kl_outline(
    shapes: &(impl Shapes + ?Sized),
    distance: impl Into<f64>,
    open_ports: OpenPorts,
    miter_mode: usize,
    layer: impl Into<Layers>,
    options: &KlOptions,
) -> Result<Device, BooleanError> {
    named("kl_outline", || {
        let distance = options.whole_steps(distance.into())? * options.precision;
        let options = options.options(shapes)?;
        Frame { distance, growth: growth(miter_mode), open_ports }.draw(shapes, &layer.into(), &options)
    })
}

/// Draws what is not covered in the box around all shapes; the result is called `invert`. See [`invert`](super::invert()).
///
/// # Errors
/// As for [`invert`](super::invert()).
pub fn kl_invert(
    shapes: &(impl Shapes + ?Sized),
    border: impl Into<Border>,
    layer: impl Into<Layers>,
    options: &KlOptions,
) -> Result<Device, BooleanError> {
    invert(shapes, border, layer, &options.options(shapes)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::Rect;
    use phidl_core::place::Bounded;

    #[test]
    fn distances_are_rounded_to_whole_steps_with_ties_to_even() {
        let square = Rect::new((0, 0), (10, 10));
        let grown = |distance: f64| kl_offset(&square, distance, 2, 0, &KlOptions::default()).unwrap().bbox().unwrap();
        assert_eq!(grown(0.000_04), square);
        assert_eq!(grown(0.000_15).max.x, 10.0002);
        assert_eq!(grown(0.000_25).max.x, 10.0002);
    }

    #[test]
    fn every_miter_mode_cuts_a_square_corner_as_measured() {
        let square = Rect::new((0, 0), (10, 10));
        for (mode, area) in [(0, 142.0), (1, 143.313_677), (2, 144.0), (5, 144.0), (99, 144.0)] {
            let grown = kl_offset(&square, 1, mode, 0, &KlOptions::default()).unwrap();
            let drawn: f64 = grown.polygons().map(|p| p.area()).sum();
            assert!((drawn - area).abs() < 1e-3, "mode {mode}: {drawn}");
        }
    }

    #[test]
    fn nothing_is_lost_at_tile_borders() {
        let squares = [0, 985, 1985].map(|at| Rect::new((at, at), (at + 10, at + 10)));
        for tile_size in [None, Some((1000.0, 1000.0)), Some((3.0, 5.0))] {
            let options = KlOptions { tile_size, ..KlOptions::default() };
            let grown = kl_offset(&squares, 10, 2, 0, &options).unwrap();
            assert_eq!(grown.polygons().map(|p| p.area()).sum::<f64>(), 2700.0);
        }
        let bad = KlOptions { tile_size: Some((0.0, 1.0)), ..KlOptions::default() };
        assert!(kl_invert(&squares, 1, 0, &bad).is_err());
    }
}
