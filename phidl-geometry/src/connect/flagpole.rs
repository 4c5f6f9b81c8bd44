//! [`flagpole`].

use phidl_core::prelude::*;
use phidl_macros::{Choice, device};

use crate::polygon::filleted;

/// Which letter a [`flagpole`](fn@flagpole) looks like.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum PoleShape {
    /// Stub below, flag to the right.
    #[default]
    P,
    /// Stub below, flag to the left.
    Q,
    /// Stub above, flag to the right.
    B,
    /// Stub above, flag to the left.
    D,
}

impl PoleShape {
    /// Factors on x and y that turn a `p` into this letter.
    fn signs(self) -> (f64, f64) {
        match self {
            Self::P => (1.0, 1.0),
            Self::Q => (-1.0, 1.0),
            Self::B => (1.0, -1.0),
            Self::D => (-1.0, -1.0),
        }
    }
}

/// What is drawn in an inner corner of a [`flagpole`](fn@flagpole) or [`tee`](fn@super::tee).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum PoleTaper {
    /// A triangle.
    #[default]
    Straight,
    /// A rounding, as wide as fits.
    Fillet,
}

/// Draws a flag on a stub: a pad with a wire at its side.
///
/// ```text
///      ── 2 ──
///     ┌───────┐          The letter p; q, b and d are its mirror images.
///     │ flag  │ size
///     │  ┌────┘
///     │  │ ╱   taper
///     └──┘ stub_size
///      1
/// ```
///
/// # Ports
/// `1` at the end of the stub, as wide as it; `2` at the far side of the flag, as wide as that.
///
/// # Errors
/// With a taper, the stub must be narrower than the flag or as wide.
///
/// # Numerics
/// A fillet is an arc of 32 points whose radius is `min(size.width − stub.width, stub.height)`, limited to 49 % of the
/// edges at its corner.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// # use pg::connect::{PoleShape, PoleTaper};
/// let pad = pg::flagpole((50, 25), (4, 8), PoleShape::P, PoleTaper::Fillet, 1)?;
/// assert_eq!(pad.port("1")?.midpoint(), Point::new(2.0, -8.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `flagpole`.
#[device(picture = "docs/flagpole.svg")]
pub fn flagpole(
    /// Width and height of the flag.
    #[default((4, 2))]
    #[param(unit = "um", min = 0.0)]
    size: Size,
    /// Width and length of the stub.
    #[default((2, 1))]
    #[param(unit = "um", min = 0.0)]
    stub_size: Size,
    /// Which letter it looks like.
    #[default(PoleShape::P)]
    shape: PoleShape,
    /// What is drawn in the inner corner; none leaves it sharp.
    #[default(PoleTaper::Straight)]
    taper_type: Option<PoleTaper>,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    if taper_type.is_some() {
        check.at_most("stub_size.width", stub_size.width, ("size.width", size.width))?;
    }
    let (sx, sy) = shape.signs();
    let (f, g) = (sx * size.width, sy * size.height);
    let (p, q) = (sx * stub_size.width, sy * stub_size.height);
    let outline = [(0.0, 0.0), (0.0, g), (f, g), (f, 0.0), (p, 0.0), (p, -q), (0.0, -q)].map(Point::from);
    /// Where the stub leaves the flag.
    const INNER_CORNER: usize = 4;

    let mut d = Device::builder("flagpole");
    match taper_type {
        None => drop(d.add_polygon(outline, &layer)?),
        Some(PoleTaper::Straight) => {
            d.add_polygon(outline, &layer)?;
            d.add_polygon([(f, 0.0), (p, 0.0), (p, -q)], &layer)?;
        }
        Some(PoleTaper::Fillet) => {
            let radius = (f - p).abs().min(q.abs());
            d.add_polygon(filleted(&outline, |i| if i == INNER_CORNER { radius } else { 0.0 }), &layer)?;
        }
    }
    d.add_port("1", ((p / 2.0, -q), stub_size.width, -90.0 * sy))?;
    d.add_port("2", ((f / 2.0, g), size.width, 90.0 * sy))?;
    d.build()
}
