//! Rectangles: [`rectangle`], [`bbox`] and, with ports, [`straight`].
//!
//! All three keep PHIDL's order of corners: `bbox` is counter-clockwise, the others are clockwise.

use phidl_core::param::{ConversionError, Param, ParamType};
use phidl_core::prelude::*;
use phidl_macros::device;

/// Draws a rectangle with its lower left corner at the origin.
///
/// A negative extent draws to the other side of the origin; a zero one draws a line without area.
///
/// # Ports
/// None.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let r = pg::rectangle((4, 2), 0)?;
/// assert_eq!(r.bbox(), Some(Rect::new((0, 0), (4, 2))));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `rectangle`.
#[device(picture = "docs/rectangle.svg")]
pub fn rectangle(
    /// Width and height.
    #[default((4, 2))]
    #[param(unit = "um")]
    size: Size,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let mut d = Device::builder("rectangle");
    d.add_polygon(corners(size), layer)?;
    d.build()
}

/// Draws a box from one corner to the opposite one: the bounding box of anything.
///
/// # Ports
/// None.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let ring = pg::ring(10, 0.5, 2.5, 1)?;
/// let frame = pg::bbox(ring.bbox().expect("a ring is drawn").grown(1.0), 2)?;
/// assert_eq!(frame.size(), Size::new(22.5, 22.5));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `bbox`.
#[device(picture = "docs/bbox.svg")]
pub fn bbox(
    /// Two opposite corners.
    #[default([(-1, -1), (3, 4)])]
    #[param(unit = "um")]
    bbox: Corners,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let Corners(a, c) = bbox;
    let mut d = Device::builder("bbox");
    d.add_polygon([(a.x, a.y), (c.x, a.y), (c.x, c.y), (a.x, c.y)], layer)?;
    d.build()
}

/// Draws a straight wire that runs upwards: a rectangle with a port at either end.
///
/// # Ports
/// `1` above, facing 90°, and `2` below, facing 270°; both `size.width` wide.
///
/// # Errors
/// A width below zero, which no port can have.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let wire = pg::straight((0.5, 30), 1)?;
/// assert_eq!(wire.port("1")?.midpoint(), Point::new(0.25, 30.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `straight`.
#[device(picture = "docs/straight.svg")]
pub fn straight(
    /// Width of the wire and its length.
    #[default((4, 2))]
    #[param(unit = "um")]
    size: Size,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let middle = size.width / 2.0;
    let mut d = Device::builder("wire");
    d.add_polygon(corners(size), layer)?;
    d.add_port("1", ((middle, size.height), size.width, 90))?;
    d.add_port("2", ((middle, 0), size.width, 270))?;
    d.build()
}

/// Upper right, lower right, lower left, upper left.
fn corners(size: Size) -> [(f64, f64); 4] {
    let Size { width, height } = size;
    [(width, height), (width, 0.0), (0.0, 0.0), (0.0, height)]
}

/// Two opposite corners, in the order in which they are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corners(pub Point, pub Point);

impl From<Rect> for Corners {
    fn from(rect: Rect) -> Self {
        Self(rect.min, rect.max)
    }
}

impl<P: Into<Point>> From<[P; 2]> for Corners {
    fn from([a, c]: [P; 2]) -> Self {
        Self(a.into(), c.into())
    }
}

impl<A: Into<Point>, C: Into<Point>> From<(A, C)> for Corners {
    fn from((a, c): (A, C)) -> Self {
        Self(a.into(), c.into())
    }
}

impl Param for Corners {
    fn param_type() -> ParamType {
        ParamType::Other("two points")
    }

    fn to_value(&self) -> Value {
        [self.0, self.1].into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match Vec::<Point>::from_value(value)?[..] {
            [a, c] => Ok(Self(a, c)),
            _ => Err(ConversionError::new(value, "be two points")),
        }
    }
}
