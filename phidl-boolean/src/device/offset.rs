//! Growing, outlining and inverting devices: [`offset`], [`outline`], [`invert`].

use phidl_core::geom::Point;
use phidl_core::layer::Layers;
use phidl_core::num::grid::Grid;
use phidl_core::port::Port;
use phidl_core::scene::Device;

use super::{Options, Shapes, boolean::named, operand::Operand};
use crate::{
    contours::Contours, error::BooleanError, grid, offset::Growth, op::Operation, options::RunOptions,
    point::GridPoint, region::Region,
};

/// Grows (`distance` > 0) or shrinks (`distance` < 0) shapes by a distance in µm, into a flat device called `offset`.
///
/// What vanishes leaves a device without polygons; distance 0 merges. The distance need not be a multiple of the
/// precision: only the corners of the result are rounded.
///
/// # Errors
/// A coordinate off the grid (with the cell it is in), a distance, join or option out of its range.
///
/// # Examples
/// ```
/// use phidl_boolean::{Growth, Options, offset};
/// use phidl_core::prelude::*;
/// let grown = offset(&Rect::new((0, 0), (10, 10)), 1, &Growth::default(), 1, &Options::default())?;
/// assert_eq!(grown.bbox(), Some(Rect::new((-1, -1), (11, 11))));
/// # Ok::<(), Error>(())
/// ```
pub fn offset(
    shapes: &(impl Shapes + ?Sized),
    distance: impl Into<f64>,
    growth: &Growth,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    named("offset", || {
        let grid = options.grid()?;
        let contours = Operand::new("shapes", shapes)?.contours(&grid)?;
        let region = grid::offset(&contours, grid.scaled(distance.into()), growth, &options.run)?;
        region.to_device("offset", layer, options)
    })
}

/// Which ports an outline leaves open.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum OpenPorts {
    /// None.
    #[default]
    Closed,
    /// All ports of the shapes given, by their width and this much more on either side (µm). Zero opens the width of
    /// the port; the distance of the outline lets its ends be flush with the port.
    Wider(f64),
}

/// Draws a frame of width `distance` around shapes, or inside them if `distance` is negative, as a flat device called
/// `outline`.
///
/// With open ports, frames have gaps there, which reach two grid steps beyond the port on the side of the shape (of an
/// inner frame: on the other side) and four beyond the frame. A single device or reference hands its ports on.
///
/// # Errors
/// As for [`offset`].
///
/// # Examples
/// ```
/// use phidl_boolean::{Growth, OpenPorts, Options, outline};
/// use phidl_core::prelude::*;
/// let square = Rect::new((0, 0), (10, 10));
/// let trench = outline(&square, 2, &Growth::default(), OpenPorts::Closed, 1, &Options::default())?;
/// assert_eq!(trench.polygons().map(|p| p.area()).sum::<f64>(), 14.0 * 14.0 - 100.0);
/// # Ok::<(), Error>(())
/// ```
pub fn outline(
    shapes: &(impl Shapes + ?Sized),
    distance: impl Into<f64>,
    growth: &Growth,
    open_ports: OpenPorts,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    let distance = distance.into();
    named("outline", || {
        let frame = Frame { distance, growth: *growth, open_ports };
        frame.draw(shapes, &layer.into(), options)
    })
}

/// What [`outline`] draws.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub(super) distance: f64,
    pub(super) growth: Growth,
    pub(super) open_ports: OpenPorts,
}

impl Frame {
    pub(super) fn draw(
        &self,
        shapes: &(impl Shapes + ?Sized),
        layers: &Layers,
        options: &Options,
    ) -> Result<Device, BooleanError> {
        let grid = options.grid()?;
        let operand = Operand::new("shapes", shapes)?;
        let openings = grid::snap(&grid, self.openings(&operand, grid.step()))?;
        let frame = self.region(&operand.contours(&grid)?, &openings, &grid, &options.run)?;

        let mut cell = Device::builder("outline");
        frame.draw(&mut cell, layers, options)?;
        cell.add_ports(self.ports_to_hand_on(&operand))?;
        Ok(cell.build()?)
    }

    /// The frame around some shapes, without the openings.
    pub(super) fn region(
        &self,
        shapes: &Contours,
        openings: &Contours,
        grid: &Grid,
        run: &RunOptions,
    ) -> Result<Region, BooleanError> {
        let moved = grid::offset(shapes, grid.scaled(self.distance), &self.growth, run)?;
        let drawn = Region::merged(shapes, run)?;
        let (frame, inside) = if self.distance > 0.0 { (moved, drawn) } else { (drawn, moved) };
        let kept_free = inside.combine(&Region::merged(openings, run)?, Operation::Or, run)?;
        frame.combine(&kept_free, Operation::Not, run)
    }

    /// The ports that a frame with openings has.
    pub(super) fn ports_to_hand_on(&self, operand: &Operand) -> Vec<Port> {
        if self.open_ports == OpenPorts::Closed { Vec::new() } else { operand.ports_of_only_element() }
    }

    /// What the ports keep free, on a grid of `step` µm.
    pub(super) fn openings(&self, operand: &Operand, step: f64) -> Vec<[(f64, f64); 4]> {
        let OpenPorts::Wider(margin) = self.open_ports else { return Vec::new() };
        operand.ports().iter().map(|port| self.opening(port, margin, step)).collect()
    }

    /// The rectangle over a port, from two grid steps inside to four beyond the frame.
    fn opening(&self, port: &Port, margin: f64, step: f64) -> [(f64, f64); 4] {
        // An inner frame lies on the other side of the port.
        let (from, to) = if self.distance > 0.0 {
            (-2.0 * step, self.distance + 4.0 * step)
        } else {
            (self.distance - 4.0 * step, 2.0 * step)
        };
        let (out, half) = (port.normal(), port.width() / 2.0 + margin);
        let across = Point::new(-out.y, out.x);
        let corner = |along: f64, side: f64| {
            let p = port.midpoint() + out * along + across * (side * half);
            (p.x, p.y)
        };
        [corner(from, -1.0), corner(to, -1.0), corner(to, 1.0), corner(from, 1.0)]
    }
}

/// How far a box reaches beyond the shapes, in x and in y (µm); below zero it lies inside.
///
/// ```
/// use phidl_boolean::Border;
/// assert_eq!(Border::from(5), Border::from((5.0, 5.0)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Border {
    /// To the left and to the right (µm).
    pub x: f64,
    /// Downward and upward (µm).
    pub y: f64,
}

impl From<f64> for Border {
    fn from(border: f64) -> Self {
        Self { x: border, y: border }
    }
}

impl From<i32> for Border {
    fn from(border: i32) -> Self {
        f64::from(border).into()
    }
}

impl<X: Into<f64>, Y: Into<f64>> From<(X, Y)> for Border {
    fn from((x, y): (X, Y)) -> Self {
        Self { x: x.into(), y: y.into() }
    }
}

/// Draws what is not covered in a box around all shapes, as a flat device called `invert`.
///
/// The box is the one around everything, with a border. Without shapes there is no box and nothing is drawn.
///
/// # Errors
/// A coordinate off the grid, a border that is not finite, an option out of its range.
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
    border: impl Into<Border>,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    let border = border.into();
    named("invert", || inverse(shapes, border, options)?.to_device("invert", layer, options))
}

fn inverse(shapes: &(impl Shapes + ?Sized), border: Border, options: &Options) -> Result<Region, BooleanError> {
    let grid = options.grid()?;
    let operand = Operand::new("shapes", shapes)?;
    for value in [border.x, border.y] {
        if !value.is_finite() {
            return Err(BooleanError::Option { option: "border", value, rule: "finite" });
        }
    }
    let Some(bbox) = operand.bbox() else { return Ok(Region::new()) };
    let corner = |x: f64, y: f64| -> Result<GridPoint, BooleanError> {
        let at = |um| grid.steps(um).map_err(|error| grid::off_grid(error, 0));
        Ok(GridPoint::new(at(x)?, at(y)?))
    };
    let low = corner(bbox.min.x - border.x, bbox.min.y - border.y)?;
    let high = corner(bbox.max.x + border.x, bbox.max.y + border.y)?;
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
    use phidl_core::geom::Rect;
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

    fn framed(shapes: &impl Shapes, distance: f64, open_ports: OpenPorts) -> Device {
        outline(shapes, distance, &Growth::default(), open_ports, 1, &Options::default()).unwrap()
    }

    #[track_caller]
    fn assert_area(device: &Device, expected: f64) {
        assert!((area(device) - expected).abs() < 1e-6, "{} instead of {expected}", area(device));
    }

    #[test]
    fn frames_are_open_at_ports_by_their_width_and_the_margin() {
        assert_area(&framed(&bar(), 1.0, OpenPorts::Closed), 12.0 * 3.0 - 10.0);
        let open = framed(&bar(), 1.0, OpenPorts::Wider(0.0));
        assert_area(&open, 12.0 * 3.0 - 12.0);
        assert_eq!((open.polygons().count(), open.ports().len()), (2, 2));
        // A margin of the distance: the frame ends flush with the ports, but for two grid steps.
        assert_area(&framed(&bar(), 1.0, OpenPorts::Wider(1.0)), 2.0 * (10.0 - 4e-4));
    }

    #[test]
    fn ports_of_placements_open_frames_where_they_end_up() {
        let turned = bar().place().rotated(90);
        let open = framed(&turned, 1.0, OpenPorts::Wider(0.0));
        assert_area(&open, 24.0);
        assert_eq!(open.port("E").unwrap().midpoint(), Point::new(-0.5, 10.0));
        let two = framed(&(&turned, bar()), 1.0, OpenPorts::Wider(0.0));
        assert_eq!(two.ports().len(), 0, "several elements keep their ports");
    }

    #[test]
    fn inner_frames_lie_inside_and_open_at_ports_too() {
        assert_area(&framed(&bar(), -0.2, OpenPorts::Closed), 10.0 - 9.6 * 0.6);
        assert_area(&framed(&bar(), -0.2, OpenPorts::Wider(-0.2)), 10.0 - 9.6 * 0.6 - 2.0 * 0.2 * 0.6);
        assert_area(&framed(&bar(), -5.0, OpenPorts::Closed), 10.0);
        assert_area(&framed(&bar(), 0.0, OpenPorts::Closed), 0.0);
    }

    #[test]
    fn one_box_is_inverted_whatever_the_border() {
        let two = [Rect::new((0, 0), (10, 10)), Rect::new((30, 0), (31, 1))];
        let inverted = |border: Border| invert(&two, border, 1, &Options::default()).unwrap();
        assert_area(&inverted(10.into()), 1429.0); // 51 × 30 less 101, as the specification measured
        assert_area(&inverted((0, 5).into()), 31.0 * 20.0 - 101.0);
        assert_area(&inverted((-6).into()), 0.0);
        assert!(invert(&(), 10, 1, &Options::default()).unwrap().bbox().is_none());
        assert!(invert(&two, f64::NAN, 1, &Options::default()).is_err());
    }

    #[test]
    fn what_vanishes_is_an_empty_device() {
        for distance in [-5.0, -6.0, -1e6] {
            let square = Rect::new((0, 0), (10, 10));
            let gone = offset(&square, distance, &Growth::default(), 0, &Options::default()).unwrap();
            assert!(gone.is_empty(), "{distance}");
        }
    }
}
