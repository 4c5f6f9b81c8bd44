//! PHIDL's `kl_` functions: the names and options of KLayout's region engine, on the engine of this crate.
//!
//! Three conventions are kept: distances are rounded to whole grid steps, corners follow `miter_mode`, and results are not
//! fractured. Defects of the original are not: coordinates are rounded instead of truncated, nothing is lost at tile
//! borders, `B-A` is the difference that it names, a negative distance gives an inner frame, and there is one box to invert.
//!
//! PHIDL's parameter `merge_after` has no equivalent: results of this engine are always merged.

use phidl_core::layer::Layers;
use phidl_core::scene::Device;

use super::{
    Hierarchy, IntoOperation, Margin, OpenPorts, Options, Shapes, boolean, draw::drawn, frame::Frame, invert,
    offset::framed, operand::Operand, operation::DeviceOperation,
};
use crate::{
    error::{BooleanError, in_function},
    grid,
    offset::{Join, OffsetOptions},
    options::{RunOptions, StripCount},
    progress::ProgressMonitor,
};

/// Extensions of the edges at a corner by miter mode, in distances.
const EXTENSIONS: [f64; 6] = [0.0, std::f64::consts::SQRT_2 - 1.0, 1.0, std::f64::consts::SQRT_2 + 1.0, 10.0, 100.0];

/// Most strips; a tile size of a few grid steps would give billions.
const MOST_STRIPS: f64 = 1e6;

/// The options of the `kl_` functions: the grid, the tiles, the threads.
#[derive(Debug, Clone, Copy)]
pub struct KLayoutOptions<'a> {
    /// The grid step (µm), greater than zero.
    pub precision: f64,
    /// The approximate size of the parts for the threads (µm), greater than zero; `None` chooses it automatically.
    pub tile_size: Option<(f64, f64)>,
    /// The number of threads; `None` is one per core.
    pub num_cpu: Option<usize>,
    /// Receives progress and can cancel.
    pub monitor: Option<&'a ProgressMonitor>,
}

impl Default for KLayoutOptions<'_> {
    fn default() -> Self {
        Self { precision: 1e-4, tile_size: None, num_cpu: None, monitor: None }
    }
}

impl<'a> KLayoutOptions<'a> {
    /// The same as [`Options`]; the number of tiles over the bounding box of the shapes becomes the number of strips.
    fn options(&self, shapes: &(impl Shapes + ?Sized)) -> Result<Options<'a>, BooleanError> {
        let strips = match self.tile_size {
            None => StripCount::default(),
            Some((x, y)) => StripCount::Fixed(self.tiles(x, y, shapes)?),
        };
        let run = RunOptions { strips, threads: self.num_cpu, monitor: self.monitor, ..RunOptions::default() };
        Ok(Options { precision: self.precision, max_points: None, hierarchy: Hierarchy::Flatten, run })
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
        Ok(tiles.min(MOST_STRIPS) as usize)
    }

    /// A length in µm, rounded to whole grid steps, halves to even.
    fn whole_steps(&self, length: f64) -> Result<f64, BooleanError> {
        let grid = grid::with_step(self.precision)?;
        Ok(grid.scaled(length).round_ties_even())
    }
}

/// The join of a miter mode from 0 (corners are cut straight) over 2 (right angles are kept) to 5; larger ones are as 5.
fn offset_options(miter_mode: usize) -> OffsetOptions {
    OffsetOptions {
        join: Join::Extended { extension: EXTENSIONS[miter_mode.min(EXTENSIONS.len() - 1)] },
        merge_first: true,
    }
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
    options: &KLayoutOptions,
) -> Result<Device, BooleanError> {
    in_function("kl_boolean", || boolean(a, b, operation, layer, &options.options(&(a, b))?).map_err(without_function))
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
    options: &KLayoutOptions,
) -> Result<Device, BooleanError> {
    in_function("kl_offset", || {
        let steps = options.whole_steps(distance.into())?;
        let options = options.options(shapes)?;
        let operands = [Operand::new("shapes", shapes)?, Operand::new("nothing", &())?];
        let operation = DeviceOperation::Offset(steps, offset_options(miter_mode));
        drawn("offset", operation, &operands, &layer.into(), &options)
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
    options: &KLayoutOptions,
) -> Result<Device, BooleanError> {
    in_function("kl_outline", || {
        let distance = options.whole_steps(distance.into())? * options.precision;
        let options = options.options(shapes)?;
        framed(shapes, Frame { distance, options: offset_options(miter_mode), open_ports }, &layer.into(), &options)
    })
}

/// Draws the uncovered area of the box around all shapes; the result is called `invert`. See [`invert`](super::invert()).
///
/// # Errors
/// As for [`invert`](super::invert()).
pub fn kl_invert(
    shapes: &(impl Shapes + ?Sized),
    margin: impl Into<Margin>,
    layer: impl Into<Layers>,
    options: &KLayoutOptions,
) -> Result<Device, BooleanError> {
    in_function("kl_invert", || invert(shapes, margin, layer, &options.options(shapes)?).map_err(without_function))
}

/// An error of the function that a `kl_` function calls, which names itself instead.
fn without_function(error: BooleanError) -> BooleanError {
    match error {
        BooleanError::Within { source, .. } => *source,
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::Rect;
    use phidl_core::place::Bounded;

    #[test]
    fn distances_are_rounded_to_whole_steps_with_ties_to_even() {
        let square = Rect::new((0, 0), (10, 10));
        let grown =
            |distance: f64| kl_offset(&square, distance, 2, 0, &KLayoutOptions::default()).unwrap().bbox().unwrap();
        assert_eq!(grown(0.000_04), square);
        assert_eq!(grown(0.000_15).max.x, 10.0002);
        assert_eq!(grown(0.000_25).max.x, 10.0002);
    }

    #[test]
    fn every_miter_mode_cuts_a_square_corner_as_measured() {
        let square = Rect::new((0, 0), (10, 10));
        for (mode, area) in [(0, 142.0), (1, 143.313_677), (2, 144.0), (5, 144.0), (99, 144.0)] {
            let grown = kl_offset(&square, 1, mode, 0, &KLayoutOptions::default()).unwrap();
            let drawn: f64 = grown.polygons().map(|p| p.area()).sum();
            assert!((drawn - area).abs() < 1e-3, "mode {mode}: {drawn}");
        }
    }

    #[test]
    fn nothing_is_lost_at_tile_borders() {
        let squares = [0, 985, 1985].map(|at| Rect::new((at, at), (at + 10, at + 10)));
        for tile_size in [None, Some((1000.0, 1000.0)), Some((3.0, 5.0))] {
            let options = KLayoutOptions { tile_size, ..KLayoutOptions::default() };
            let grown = kl_offset(&squares, 10, 2, 0, &options).unwrap();
            assert_eq!(grown.polygons().map(|p| p.area()).sum::<f64>(), 2700.0);
        }
        let bad = KLayoutOptions { tile_size: Some((0.0, 1.0)), ..KLayoutOptions::default() };
        assert!(kl_invert(&squares, 1, 0, &bad).is_err());
    }
}
