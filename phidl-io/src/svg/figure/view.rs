//! From micrometers to the steps of a figure: tenths of a pixel, y down.

use phidl_core::geom::{Point, Rect};
use phidl_core::num::grid::whole;
use phidl_core::place::Bounded;
use phidl_core::scene::Device;

use super::FigureOptions;

/// Steps of a figure in a pixel.
pub(super) const PER_PIXEL: i64 = 10;

/// A place in a figure, in steps.
pub(super) type Step = (i64, i64);

/// How a device lies in its figure: its upper left corner at the origin.
pub(super) struct View {
    /// Steps per micrometer.
    pub(super) scale: f64,
    corner: Point,
    /// Right and lower end of the device, in steps.
    pub(super) end: Step,
}

impl View {
    /// As large as the options allow. A device that draws nothing is as large as its ports.
    pub(super) fn of(device: &Device, options: &FigureOptions) -> Self {
        let ports = device.ports().filter(|_| options.ports);
        let ends = Rect::around(ports.flat_map(|port| <[Point; 2]>::from(port.endpoints())));
        let boxes = options.sources.iter().map(Device::bbox).chain([device.bbox(), ends]);
        let frame = Rect::union_all(boxes).unwrap_or(Rect { min: Point::ORIGIN, max: Point::ORIGIN });
        let (size, most) = (frame.size(), options.size);
        let scale = (most.width / size.width).min(most.height / size.height);
        // A single port of no width has no size to be scaled.
        let scale = if scale.is_finite() { scale * PER_PIXEL as f64 } else { 1.0 };
        let corner = Point::new(frame.min.x, frame.max.y);
        let end = Self { scale, corner, end: (0, 0) }.step(Point::new(frame.max.x, frame.min.y));
        Self { scale, corner, end }
    }

    /// The step that is nearest to a point.
    pub(super) fn step(&self, p: Point) -> Step {
        let from_corner = (p - self.corner) * self.scale;
        (step(from_corner.x), step(-from_corner.y))
    }
}

/// The nearest whole number of steps; noise is removed first.
pub(super) fn step(steps: f64) -> i64 {
    #[expect(clippy::cast_possible_truncation, reason = "a figure is some thousand steps wide")]
    let steps = whole(steps) as i64;
    steps
}
