//! [`Label`]: a text at a position. It is not drawn on the mask.

use super::{Element, Group, Properties};
use crate::geom::{Point, Rect, Transform};
use crate::layer::Layer;
use crate::place::{Bounded, DeferredError, Transformable};

/// The point of the text that is at the label's position.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[expect(missing_docs, reason = "compass points explain themselves")]
pub enum Anchor {
    NorthWest,
    North,
    NorthEast,
    West,
    #[default]
    Center,
    East,
    SouthWest,
    South,
    SouthEast,
}

/// How a layout file has a text drawn, beyond its position, size and anchor. It changes nothing on a mask; a label that was
/// read keeps it, so that a file is written as it was.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TextStyle {
    /// The font, 0 to 3.
    pub font: u8,
    /// The path type of the strokes, if the file states one.
    pub path_type: Option<i16>,
    /// The width of the strokes (µm; negative: not magnified with the cell), if the file states one.
    pub width: Option<f64>,
    /// Whether the file leaves the anchor out, which then is north-west.
    pub anchor_unstated: bool,
    /// Whether the file states the magnification though it is 1.
    pub magnification_stated: bool,
}

/// A text at a position. Its bounding box is that position. Rotating and mirroring rotate and mirror the text as well, as
/// the reference to a cell with the label does.
///
/// ```
/// # use phidl_core::prelude::*;
/// let label = Label::new("pad 1", (3, 4), 10).anchored(Anchor::SouthWest).rotated(90);
/// assert_eq!((label.position(), label.rotation()), (Point::new(-4.0, 3.0), 90.0));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The text.
    pub text: String,
    /// Layer and texttype.
    pub layer: Layer,
    /// The point of the text that is at the position.
    pub anchor: Anchor,
    /// Numbered texts that a file keeps with it.
    pub properties: Properties,
    transform: Transform,
    style: Option<Box<TextStyle>>,
    deferred: Option<Box<DeferredError>>,
}

impl Label {
    /// A level text of magnification 1, centered at a position.
    pub fn new(text: impl Into<String>, position: impl Into<Point>, layer: impl Into<Layer>) -> Self {
        Self {
            text: text.into(),
            layer: layer.into(),
            anchor: Anchor::Center,
            properties: Properties::new(),
            transform: Transform::translation(position),
            style: None,
            deferred: None,
        }
    }

    /// The same with another point of the text at the position.
    #[must_use]
    pub fn anchored(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// The same with another transform.
    #[must_use]
    pub fn with_transform(self, transform: Transform) -> Self {
        Self { transform, ..self }
    }

    /// The same in the style of a file.
    #[must_use]
    pub fn with_style(self, style: TextStyle) -> Self {
        Self { style: (style != TextStyle::default()).then(|| Box::new(style)), ..self }
    }

    /// The style that a file stated.
    #[must_use]
    pub fn style(&self) -> TextStyle {
        self.style.as_deref().copied().unwrap_or_default()
    }

    /// The position.
    #[must_use]
    pub fn position(&self) -> Point {
        self.transform.origin
    }

    /// The rotation of the text (degrees, in `[0, 360)`).
    #[must_use]
    pub fn rotation(&self) -> f64 {
        self.transform.rotation
    }

    /// Position, rotation, magnification and reflection.
    #[must_use]
    pub fn transform(&self) -> &Transform {
        &self.transform
    }

    pub(crate) fn deferred(&self) -> Option<DeferredError> {
        self.deferred.as_deref().copied()
    }
}

impl Bounded for Label {
    fn bbox(&self) -> Option<Rect> {
        Some(Rect { min: self.position(), max: self.position() })
    }
}

impl Transformable for Label {
    fn transform_mut(&mut self, by: &Transform) {
        self.transform = self.transform.then(by);
    }

    fn defer(&mut self, error: DeferredError) {
        self.deferred.get_or_insert(Box::new(error));
    }
}

impl<E: Into<Element>> std::ops::Add<E> for Label {
    type Output = Group;
    fn add(self, other: E) -> Group {
        Group::from(self) + other
    }
}
