//! Growing, outlining and inverting devices: [`offset`], [`outline`], [`invert`].

use phidl_core::layer::Layers;
use phidl_core::scene::Device;

use super::{
    Margin, OpenPorts, Options, Shapes,
    draw::{draw, drawn},
    frame::Frame,
    operand::Operand,
    operation::DeviceOperation,
};
use crate::{
    contours::Contours,
    error::{BooleanError, in_function},
    grid,
    offset::OffsetOptions,
    op::Operation,
    point::GridPoint,
    region::Region,
};

/// Grows (`distance` > 0) or shrinks (`distance` < 0) shapes by a distance in µm, into a flat device called `offset`.
///
/// Shapes that vanish leave a device without polygons; distance 0 merges. The distance need not be a multiple of the
/// precision: only the corners of the result are rounded.
///
/// # Errors
/// A coordinate off the grid (with the cell it is in), a distance, join or option out of its range.
///
/// # Examples
/// ```
/// use phidl_boolean::{OffsetOptions, Options, offset};
/// use phidl_core::prelude::*;
/// let grown = offset(&Rect::new((0, 0), (10, 10)), 1, &OffsetOptions::default(), 1, &Options::default())?;
/// assert_eq!(grown.bbox(), Some(Rect::new((-1, -1), (11, 11))));
/// # Ok::<(), Error>(())
/// ```
pub fn offset(
    shapes: &(impl Shapes + ?Sized),
    distance: impl Into<f64>,
    offset_options: &OffsetOptions,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    let distance = distance.into();
    in_function("offset", || {
        let operation = DeviceOperation::Offset(options.grid()?.scaled(distance), *offset_options);
        let operands = [Operand::new("shapes", shapes)?, Operand::new("nothing", &())?];
        drawn("offset", operation, &operands, &layer.into(), options)
    })
}

/// Draws a frame of width `distance` around shapes, or inside them if `distance` is negative, as a flat device called
/// `outline`.
///
/// With open ports, frames have gaps there, from two grid steps inside the shape to four beyond the frame (for an inner
/// frame, from two grid steps outside the shape). The outline inherits the ports of a single device or reference.
///
/// # Errors
/// As for [`offset`].
///
/// # Examples
/// ```
/// use phidl_boolean::{OffsetOptions, OpenPorts, Options, outline};
/// use phidl_core::prelude::*;
/// let square = Rect::new((0, 0), (10, 10));
/// let trench = outline(&square, 2, &OffsetOptions::default(), OpenPorts::Closed, 1, &Options::default())?;
/// assert_eq!(trench.polygons().map(|p| p.area()).sum::<f64>(), 14.0 * 14.0 - 100.0);
/// # Ok::<(), Error>(())
/// ```
pub fn outline(
    shapes: &(impl Shapes + ?Sized),
    distance: impl Into<f64>,
    offset_options: &OffsetOptions,
    open_ports: OpenPorts,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    let distance = distance.into();
    in_function("outline", || {
        framed(shapes, Frame { distance, options: *offset_options, open_ports }, &layer.into(), options)
    })
}

/// The device of a frame, with the ports that it inherits.
pub(super) fn framed(
    shapes: &(impl Shapes + ?Sized),
    frame: Frame,
    layers: &Layers,
    options: &Options,
) -> Result<Device, BooleanError> {
    let shapes = Operand::new("shapes", shapes)?;
    let ports = frame.inherited_ports(&shapes);
    let openings = Operand::new("openings", &frame.openings(&shapes, options.precision)?)?;
    let mut cell = Device::builder("outline");
    draw(&mut cell, DeviceOperation::Frame(frame), &[shapes, openings], layers, options)?;
    cell.add_ports(ports)?;
    Ok(cell.build()?)
}

/// Draws the uncovered area of the box around all shapes, with a margin, as a flat device called `invert`.
///
/// Without shapes there is no box and the result is empty.
///
/// # Errors
/// A coordinate off the grid, a margin that is not finite, an option out of its range.
///
/// # Examples
/// ```
/// use phidl_boolean::{Options, invert};
/// use phidl_core::prelude::*;
/// let mold = invert(&Rect::new((0, 0), (10, 10)), 2, 1, &Options::default())?;
/// assert_eq!(mold.polygons().map(|p| p.area()).sum::<f64>(), 96.0);
/// # Ok::<(), Error>(())
/// ```
pub fn invert(
    shapes: &(impl Shapes + ?Sized),
    margin: impl Into<Margin>,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    let margin = margin.into();
    in_function("invert", || {
        options.require_flat("the box around all shapes touches every cell")?;
        inverse(shapes, margin, options)?.to_device("invert", layer, options)
    })
}

fn inverse(shapes: &(impl Shapes + ?Sized), margin: Margin, options: &Options) -> Result<Region, BooleanError> {
    let grid = options.grid()?;
    let operand = Operand::new("shapes", shapes)?;
    operand.check_size(&options.run)?;
    for value in [margin.x, margin.y] {
        if !value.is_finite() {
            return Err(BooleanError::Option { option: "margin", value, rule: "finite" });
        }
    }
    let Some(bbox) = operand.bbox() else { return Ok(Region::new()) };
    let corner = |x: f64, y: f64| -> Result<GridPoint, BooleanError> {
        let at = |um| grid.steps(um).map_err(|error| grid::off_grid(error, 0));
        Ok(GridPoint::new(at(x)?, at(y)?))
    };
    let low = corner(bbox.min.x - margin.x, bbox.min.y - margin.y)?;
    let high = corner(bbox.max.x + margin.x, bbox.max.y + margin.y)?;
    if low.x >= high.x || low.y >= high.y {
        return Ok(Region::new());
    }
    let frame: Contours =
        [[low, GridPoint::new(high.x, low.y), high, GridPoint::new(low.x, high.y)]].into_iter().collect();
    grid::boolean(&frame, &operand.contours(&grid)?, Operation::Not, &options.run)
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::{Point, Rect};
    use phidl_core::place::{Bounded, Movable};

    /// A bar of 10 × 1 µm with a port at either end.
    fn bar() -> Device {
        let mut d = Device::builder("bar");
        d.add_polygon(Rect::new((0, 0), (10, 1)), 1).unwrap();
        d.add_port("W", ((0.0, 0.5), 1, 180)).unwrap();
        d.add_port("E", ((10.0, 0.5), 1, 0)).unwrap();
        d.build().unwrap()
    }

    fn area(device: &Device) -> f64 {
        device.polygons().map(|p| p.area()).sum()
    }

    fn frame_of(shapes: &impl Shapes, distance: f64, open_ports: OpenPorts) -> Device {
        outline(shapes, distance, &OffsetOptions::default(), open_ports, 1, &Options::default()).unwrap()
    }

    #[track_caller]
    fn assert_area(device: &Device, expected: f64) {
        assert!((area(device) - expected).abs() < 1e-6, "{} instead of {expected}", area(device));
    }

    #[test]
    fn frames_are_open_at_ports_by_their_width_and_the_margin() {
        assert_area(&frame_of(&bar(), 1.0, OpenPorts::Closed), 12.0 * 3.0 - 10.0);
        let open = frame_of(&bar(), 1.0, OpenPorts::WithMargin(0.0));
        assert_area(&open, 12.0 * 3.0 - 12.0);
        assert_eq!((open.polygons().count(), open.ports().len()), (2, 2));
        // A margin of the distance: the frame ends flush with the ports, but for two grid steps.
        assert_area(&frame_of(&bar(), 1.0, OpenPorts::WithMargin(1.0)), 2.0 * (10.0 - 4e-4));
    }

    #[test]
    fn ports_of_placements_open_frames_at_their_placed_positions() {
        let turned = bar().place().rotated(90);
        let open = frame_of(&turned, 1.0, OpenPorts::WithMargin(0.0));
        assert_area(&open, 24.0);
        assert_eq!(open.port("E").unwrap().midpoint(), Point::new(-0.5, 10.0));
        let two = frame_of(&(&turned, bar()), 1.0, OpenPorts::WithMargin(0.0));
        assert_eq!(two.ports().len(), 0, "several elements keep their ports");
    }

    #[test]
    fn inner_frames_lie_inside_and_open_at_ports_too() {
        assert_area(&frame_of(&bar(), -0.2, OpenPorts::Closed), 10.0 - 9.6 * 0.6);
        assert_area(&frame_of(&bar(), -0.2, OpenPorts::WithMargin(-0.2)), 10.0 - 9.6 * 0.6 - 2.0 * 0.2 * 0.6);
        assert_area(&frame_of(&bar(), -5.0, OpenPorts::Closed), 10.0);
        assert_area(&frame_of(&bar(), 0.0, OpenPorts::Closed), 0.0);
    }

    #[test]
    fn the_box_around_everything_is_inverted_for_any_margin() {
        let two = [Rect::new((0, 0), (10, 10)), Rect::new((30, 0), (31, 1))];
        let inverted = |margin: Margin| invert(&two, margin, 1, &Options::default()).unwrap();
        assert_area(&inverted(10.into()), 1429.0); // 51 × 30 less 101, as measured
        assert_area(&inverted((0, 5).into()), 31.0 * 20.0 - 101.0);
        assert_area(&inverted((-6).into()), 0.0);
        assert!(invert(&(), 10, 1, &Options::default()).unwrap().bbox().is_none());
        assert!(invert(&two, f64::NAN, 1, &Options::default()).is_err());
    }

    #[test]
    fn shapes_that_vanish_give_an_empty_device() {
        for distance in [-5.0, -6.0, -1e6] {
            let square = Rect::new((0, 0), (10, 10));
            let gone = offset(&square, distance, &OffsetOptions::default(), 0, &Options::default()).unwrap();
            assert!(gone.is_empty(), "{distance}");
        }
    }
}
