//! [`Polygon`]: an outline that is not in a cell yet.

use std::collections::BTreeMap;

use super::{Element, Group};
use crate::geom::{Outline, Point, Rect, Transform, signed_area, simplified};
use crate::layer::Layers;
use crate::place::{Bounded, DeferredError, Reason, Transformable};

/// Numbered texts that a file keeps with an element (GDSII's property attributes).
pub type Properties = BTreeMap<u16, String>;

/// An outline with the layers it is drawn on: an ordinary value to move and relate before it is added to a cell.
///
/// Points are kept as given: order, direction, first point, and a repeated closing point.
#[derive(Debug, Clone, PartialEq)]
pub struct Polygon {
    /// The corners, in order.
    pub points: Vec<Point>,
    /// The layers it is drawn on.
    pub layers: Layers,
    /// Numbered texts that a file keeps with it.
    pub properties: Properties,
    pub(crate) deferred: Option<Box<DeferredError>>,
}

impl Polygon {
    /// A polygon from its corners (pairs or two coordinate lists) and its layers.
    pub fn new(outline: impl Outline, layers: impl Into<Layers>) -> Self {
        Self { points: outline.into_points(), layers: layers.into(), properties: Properties::new(), deferred: None }
    }

    /// The same with one more property.
    #[must_use]
    pub fn with_property(mut self, attribute: u16, text: impl Into<String>) -> Self {
        self.properties.insert(attribute, text.into());
        self
    }

    /// Area (µm²) of one copy, whatever the direction of the outline.
    #[must_use]
    pub fn area(&self) -> f64 {
        signed_area(&self.points).abs()
    }

    /// Scales by factors along x and y about a point. Factors must be finite and not 0; a negative one mirrors. An invalid
    /// factor is a deferred error.
    pub fn scale_xy(&mut self, x: impl Into<f64>, y: impl Into<f64>, center: impl Into<Point>) -> &mut Self {
        let (x, y, center) = (x.into(), y.into(), center.into());
        let reason = match [x, y].into_iter().find(|factor| !factor.is_finite() || *factor == 0.0) {
            Some(0.0) => Some(Reason::FactorNotPositive(0.0)),
            Some(factor) => Some(Reason::NumberNotFinite(factor)),
            None if !center.is_finite() => Some(Reason::PointNotFinite(center)),
            None => None,
        };
        match reason {
            Some(reason) => self.defer(DeferredError { method: "scale_xy", reason }),
            None => self.points.iter_mut().for_each(|p| {
                let from = *p - center;
                *p = center + Point::new(from.x * x, from.y * y);
            }),
        }
        self
    }

    /// Removes the points that are not needed to stay within `tolerance` (µm); see [`simplified`]. An outline that
    /// would lose its third point stays as it is.
    ///
    /// A tolerance that is negative or not finite changes nothing and is a deferred error.
    pub fn simplify(&mut self, tolerance: impl Into<f64>) -> &mut Self {
        let tolerance = tolerance.into();
        if tolerance.is_finite() && tolerance >= 0.0 {
            let simple = simplified(&self.points, tolerance);
            if simple.len() >= 3 {
                self.points = simple;
            }
        } else {
            self.defer(DeferredError { method: "simplify", reason: Reason::BadTolerance(tolerance) });
        }
        self
    }
}

impl Bounded for Polygon {
    fn bbox(&self) -> Option<Rect> {
        Rect::around(self.points.iter().copied())
    }
}

impl Transformable for Polygon {
    fn transform_mut(&mut self, by: &Transform) {
        let matrix = by.matrix();
        self.points.iter_mut().for_each(|p| *p = matrix.apply(*p));
    }

    fn defer(&mut self, error: DeferredError) {
        self.deferred.get_or_insert(Box::new(error));
    }
}

impl<E: Into<Element>> std::ops::Add<E> for Polygon {
    type Output = Group;
    fn add(self, other: E) -> Group {
        Group::from(self) + other
    }
}
