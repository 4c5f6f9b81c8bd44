//! [`grating`].

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::{compass, taper};

/// How far the etched bars reach beyond the slab on each side (µm).
const OVERHANG: f64 = 5.0;
/// More periods than this are taken for a mistake.
const MOST_PERIODS: usize = 1_000_000;

/// Draws a grating coupler: teeth with a taper to a waveguide, or bars that are etched into a slab.
///
/// ```text
///   ┌┐ ┌┐ ┌┐ ┌┐__              ┌┐ ┌┐ ┌┐ ┌┐  layer_etch
///   ││ ││ ││ ││  ‾‾──          ├┼─┼┼─┼┼─┼┤
///   ││ ││ ││ ││      ├─ 1      ││ ││ ││ ││─ 1
///   ││ ││ ││ ││__──            ├┼─┼┼─┼┼─┼┤  layer
///   └┘ └┘ └┘ └┘                └┘ └┘ └┘ └┘
///     teeth on layer            partial_etch
/// ```
///
/// The first tooth or bar is centered on the origin, the others stand to its right.
///
/// # Ports
/// `1` at the right end, facing 0°: `width` wide at the end of the taper, or as wide as the slab.
///
/// # Errors
/// A `fill_factor` of 1 with `partial_etch`, which leaves nothing to etch. (Teeth touch then.)
///
/// # Numerics
/// Teeth are `fill_factor · period` wide, bars `(1 − fill_factor) · period`; bars overhang the slab by 5 µm on each side. Teeth
/// and taper are polygons of one cell with equal coordinates at their joint, so that no grid opens a gap between them.
///
/// # Differences from PHIDL
/// With `partial_etch`, the slab lies under all bars, from the first to the last, and the port has its width. PHIDL centers
/// the slab on the first bar, so that half of the bars lie beside it, and makes the port as wide as the bars are long.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let g = pg::GratingParams::default().period(0.62).fill_factor(0.4).build()?;
/// assert_eq!(g.port("1")?.width(), 0.4);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `grating`.
#[device(picture = "docs/grating.svg")]
pub fn grating(
    /// Number of teeth or bars.
    #[default(20)]
    #[param(min = 1)]
    num_periods: usize,
    /// Distance between neighboring teeth, middle to middle.
    #[default(0.75)]
    #[param(unit = "um", above = 0.0)]
    period: f64,
    /// Part of a period that is not etched.
    #[default(0.5)]
    #[param(above = 0.0, max = 1.0)]
    fill_factor: f64,
    /// Length of the teeth, or width of the slab.
    #[default(5.0)]
    #[param(unit = "um", above = 0.0)]
    width_grating: f64,
    /// Length of the taper.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    length_taper: f64,
    /// Width of the waveguide.
    #[default(0.4)]
    #[param(unit = "um", min = 0.0)]
    width: f64,
    /// Etch bars into a slab instead of drawing teeth.
    #[default(false)]
    partial_etch: bool,
    /// Where teeth, taper and slab are drawn.
    #[default(0)]
    #[param(named)]
    layer: Layers,
    /// Where etched bars are drawn.
    #[default(1)]
    #[param(named)]
    layer_etch: Layers,
) -> Result<Device> {
    check.at_most("num_periods", num_periods, MOST_PERIODS)?;
    let mut d = Device::builder("grating");
    let last = (num_periods - 1) as f64 * period;
    if partial_etch {
        let rule = "be less than 1, since the rest of a period is etched";
        check.that("fill_factor", fill_factor, fill_factor < 1.0, rule)?;
        let bar = Size::new(period * (1.0 - fill_factor), width_grating + 2.0 * OVERHANG);
        row(&mut d, &compass(bar, layer_etch)?, num_periods, period);
        let slab = compass((last + bar.width, width_grating), layer)?.place().moved_by((last / 2.0, 0));
        d.add_port("1", slab.port("E")?)?;
        d.add(slab);
    } else {
        let tooth = compass((period * fill_factor, width_grating), layer.clone())?;
        row(&mut d, &tooth, num_periods, period);
        let end = last + period * fill_factor / 2.0;
        let taper = taper(length_taper, width_grating, width, layer)?.place().moved_by((end, 0));
        d.add_port("1", taper.port("2")?)?;
        d.add(taper);
        d.flatten()?;
    }
    d.build()
}

fn row(d: &mut DeviceBuilder, tooth: &Device, count: usize, period: f64) {
    for k in 0..count {
        d.add(tooth.place().moved_by((k as f64 * period, 0)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_default_is_that_of_the_specification() {
        let d = GratingParams::default().build().unwrap();
        assert_eq!(d.flat_polygons().count(), 21);
        assert_eq!(d.port("1").unwrap().midpoint(), Point::new(24.4375, 0.0));
        assert_eq!(d.area(), 64.5);
    }

    #[test]
    fn the_slab_lies_under_every_etched_bar() {
        let d = GratingParams::default().num_periods(3).period(1).fill_factor(0.3).width_grating(4).partial_etch(true);
        let d = d.layer(7).layer_etch((7, 2)).build().unwrap();
        let boxes = |layer: Layer| -> Vec<Rect> {
            d.flat_polygons().filter(|p| p.layer == Some(layer)).filter_map(|p| p.bbox()).collect()
        };
        let (slab, bars) = (boxes(Layer::from(7)), boxes(Layer::from((7, 2))));
        assert_eq!((slab.len(), bars.len()), (1, 3));
        let bars = bars[0].union(bars[2]);
        assert!((slab[0].min.x - bars.min.x).abs() < 1e-12 && (slab[0].max.x - bars.max.x).abs() < 1e-12);
        assert!((bars.max.y - slab[0].max.y - 5.0).abs() < 1e-12);
        let port = d.port("1").unwrap();
        assert!(port.midpoint().distance(Point::new(2.35, 0.0)) < 1e-12 && port.width() == 4.0);
    }

    #[test]
    fn teeth_that_fill_their_period_touch_and_bars_of_no_width_are_refused() {
        let full = GratingParams::default().num_periods(5).period(1).fill_factor(1);
        assert_eq!(full.clone().length_taper(4).width(1).build().unwrap().area(), 5.0 * 5.0 + 12.0);
        assert!(full.partial_etch(true).build().is_err());
    }

    #[test]
    fn gratings_without_teeth_are_refused() {
        assert_eq!(
            GratingParams::default().num_periods(0).build().unwrap_err().to_string(),
            "grating: num_periods is 0, but it must be at least 1"
        );
    }

    proptest! {
        #[test]
        fn teeth_cover_their_part_of_every_period(n in 1..30_usize, period in 0.3..2.0_f64, f in 0.1..0.9_f64) {
            let d = GratingParams::default().num_periods(n).period(period).fill_factor(f).build().unwrap();
            let taper = 10.0 * (5.0 + 0.4) / 2.0;
            prop_assert!((d.area() - taper - n as f64 * period * f * 5.0).abs() < 1e-9);
            prop_assert_eq!(d.port("1").unwrap().midpoint().x, d.xmax());
        }
    }
}
