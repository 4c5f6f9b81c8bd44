//! [`basic_die`].

use phidl_core::param::{ConversionError, Param, ParamType};
use phidl_core::prelude::*;
use phidl_macros::{Choice, device};

use crate::text::{Justify, text};

/// Distance of the name from the inner edge of the corner marks (µm).
const CLEARANCE: f64 = 20.0;

/// Where in a [`basic_die`](fn@basic_die) its name stands: at a side or corner, or around a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TextLocation {
    /// Inside the corner marks, at a side, in a corner, or in the middle.
    Side(DieSide),
    /// Centered on a point (µm).
    Center(Point),
}

/// A side or corner of a die, or its middle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
#[expect(missing_docs, reason = "the points of the compass, north up")]
pub enum DieSide {
    #[choice("N")]
    N,
    #[choice("NE")]
    Ne,
    #[choice("E")]
    E,
    #[choice("SE")]
    Se,
    #[choice("S")]
    S,
    #[choice("SW")]
    Sw,
    #[choice("W")]
    W,
    #[choice("NW")]
    Nw,
    #[choice("C")]
    C,
}

impl DieSide {
    /// −1, 0 or 1: to the left or right, and below or above.
    fn signs(self) -> (f64, f64) {
        match self {
            Self::N => (0.0, 1.0),
            Self::Ne => (1.0, 1.0),
            Self::E => (1.0, 0.0),
            Self::Se => (1.0, -1.0),
            Self::S => (0.0, -1.0),
            Self::Sw => (-1.0, -1.0),
            Self::W => (-1.0, 0.0),
            Self::Nw => (-1.0, 1.0),
            Self::C => (0.0, 0.0),
        }
    }
}

impl TextLocation {
    /// The center of a text of this size in a die whose inside reaches from −`inside` to `inside`.
    fn center(self, text: Size, inside: Point) -> Point {
        match self {
            Self::Center(center) => center,
            Self::Side(side) => {
                let (x, y) = side.signs();
                Point::new(x * (inside.x - text.width / 2.0), y * (inside.y - text.height / 2.0))
            }
        }
    }
}

/// Draws the frame of a die around the origin: marks in the corners where it will be cut, a box, and a name.
///
/// ```text
///   ┌──       ──┐   corner marks: street_length long,
///   │           │                 street_width wide
///
///   │ chip99    │
///   └──       ──┘
/// ```
///
/// # Ports
/// None.
///
/// # Errors
/// `street_length` must be at least `street_width`, or the corner marks would cross themselves. Letters of no size.
///
/// # Numerics
/// The drawn box of the name stands 20 µm inside the corner marks, whatever `text_size` is. The box is filled.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let die = pg::BasicDieParams::default().size((5000, 2500)).die_name("").draw_bbox(false).build()?;
/// assert_eq!(die.size(), Size::new(5000.0, 2500.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `basic_die`.
#[device(picture = "docs/basic_die.svg", example = BasicDieParams::default().size((3000, 2000)).street_length(500).draw_bbox(false))]
pub fn basic_die(
    /// Width and height.
    #[default((10000, 10000))]
    #[param(unit = "um", above = 0.0)]
    size: Size,
    /// Width of the corner marks.
    #[default(100.0)]
    #[param(unit = "um", above = 0.0)]
    street_width: f64,
    /// Length of the corner marks.
    #[default(1000.0)]
    #[param(unit = "um", above = 0.0)]
    street_length: f64,
    /// What is written into it; an empty name is not.
    #[default("chip99")]
    die_name: String,
    /// Height of the letters; a negative one turns the name by 180°.
    #[default(100.0)]
    #[param(unit = "um")]
    text_size: f64,
    /// Where the name stands: `N`, `NE`, `E`, `SE`, `S`, `SW`, `W`, `NW`, `C`, or a point for its center.
    #[default(DieSide::Sw)]
    text_location: TextLocation,
    /// Where marks and name are drawn.
    #[default(0)]
    layer: Layers,
    /// Whether the box is drawn.
    #[default(true)]
    draw_bbox: bool,
    /// Where the box is drawn.
    #[default(99)]
    bbox_layer: Layers,
) -> Result<Device> {
    check.at_least("street_length", street_length, ("street_width", street_width))?;
    let half = Point::new(size.width, size.height) / 2.0;
    let mut d = Device::builder("die");
    for (x, y) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
        let corner = corner_mark(half, street_width, street_length).map(|p| Point::new(x * p.x, y * p.y));
        d.add_polygon(corner, &layer)?;
    }
    if draw_bbox {
        let (x, y) = (half.x, half.y);
        d.add_polygon([(x, y), (x, -y), (-x, -y), (-x, y)], bbox_layer)?;
    }
    let name = text(die_name, text_size, Justify::Left, &layer, "DEPLOF")?;
    if !name.is_empty() {
        let inset = street_width + CLEARANCE;
        let center = text_location.center(name.size(), half - Point::new(inset, inset));
        d.add(name.place().centered(center));
    }
    d.build()
}

/// The mark in the upper right corner.
fn corner_mark(corner: Point, width: f64, length: f64) -> [Point; 6] {
    let Point { x, y } = corner;
    [(x, y), (x, y - length), (x - width, y - length), (x - width, y - width), (x - length, y - width), (x - length, y)]
        .map(Point::from)
}

impl From<DieSide> for TextLocation {
    fn from(side: DieSide) -> Self {
        Self::Side(side)
    }
}

impl From<Point> for TextLocation {
    fn from(center: Point) -> Self {
        Self::Center(center)
    }
}

impl<X: Into<f64>, Y: Into<f64>> From<(X, Y)> for TextLocation {
    fn from(center: (X, Y)) -> Self {
        Self::Center(center.into())
    }
}

impl Param for TextLocation {
    fn param_type() -> ParamType {
        ParamType::Other("one of N, NE, E, SE, S, SW, W, NW, C, or a point")
    }

    fn to_value(&self) -> Value {
        match self {
            Self::Side(side) => side.to_value(),
            Self::Center(center) => center.to_value(),
        }
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Text(_) => DieSide::from_value(value).map(Self::Side),
            _ => Point::from_value(value).map(Self::Center),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_stands_inside_the_marks_at_its_side() {
        // The ink of the default name is 420 × 140 µm in PHIDL, where these boxes were measured.
        let (ink, inside) = (Size::new(420.0, 140.0), Point::new(4880.0, 4880.0));
        let at = |location: TextLocation| {
            let (center, half) = (location.center(ink, inside), Point::new(210.0, 70.0));
            Rect::new(center - half, center + half)
        };
        assert_eq!(at(DieSide::Sw.into()), Rect::new((-4880, -4880), (-4460, -4740)));
        assert_eq!(at(DieSide::N.into()), Rect::new((-210, 4740), (210, 4880)));
        assert_eq!(at((100, 200).into()), Rect::new((-110, 130), (310, 270)));
    }

    #[test]
    fn a_name_of_negative_size_stands_turned_in_the_same_box() {
        let name = |size: i32| BasicDieParams::default().text_size(size).draw_bbox(false).build().unwrap();
        let (upright, turned) = (name(100), name(-100));
        let boxes = |d: &Device| d.references()[0].bbox().unwrap();
        assert_eq!(boxes(&upright), boxes(&turned));
        assert!(upright.drawing_hash() != turned.drawing_hash());
        assert!(BasicDieParams::default().text_size(0).build().is_err());
    }

    #[test]
    fn locations_come_back_from_their_values_in_any_case_of_letters() {
        for location in [TextLocation::from(DieSide::Nw), TextLocation::from((1.5, -2))] {
            assert_eq!(TextLocation::from_value(&location.to_value()).unwrap(), location);
        }
        assert_eq!(TextLocation::from_value(&"se".into()).unwrap(), DieSide::Se.into());
        assert!(TextLocation::from_value(&"middle".into()).is_err());
    }

    #[test]
    fn marks_are_mirror_images_in_the_four_corners() {
        let d = BasicDieParams::default().die_name("").draw_bbox(false).size((20, 10));
        let d = d.street_width(1).street_length(3).build().unwrap();
        assert_eq!(d.bbox(), Some(Rect::new((-10, -5), (10, 5))));
        assert_eq!(d.area(), 4.0 * (3.0 + 2.0));
    }
}
