//! [`Align`]: lining members up and spacing them out.

use super::{DeferredError, Reason};
use crate::geom::{Point, Rect};

/// An edge or a middle of a bounding box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// The middle, along x.
    X,
    /// The left edge.
    XMin,
    /// The right edge.
    XMax,
    /// The middle, along y.
    Y,
    /// The lower edge.
    YMin,
    /// The upper edge.
    YMax,
}

/// The direction in which members are spaced out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// To the right.
    X,
    /// Up.
    Y,
}

impl Edge {
    /// The coordinate of this edge of a box.
    #[must_use]
    pub fn of(self, rect: Rect) -> f64 {
        match self {
            Self::X => rect.center().x,
            Self::XMin => rect.min.x,
            Self::XMax => rect.max.x,
            Self::Y => rect.center().y,
            Self::YMin => rect.min.y,
            Self::YMax => rect.max.y,
        }
    }

    fn direction(self) -> Direction {
        match self {
            Self::X | Self::XMin | Self::XMax => Direction::X,
            Self::Y | Self::YMin | Self::YMax => Direction::Y,
        }
    }
}

impl Direction {
    fn vector(self, length: f64) -> Point {
        match self {
            Self::X => Point::new(length, 0.0),
            Self::Y => Point::new(0.0, length),
        }
    }

    fn extent(self, rect: Rect) -> f64 {
        match self {
            Self::X => rect.size().width,
            Self::Y => rect.size().height,
        }
    }

    fn lower_edge(self) -> Edge {
        match self {
            Self::X => Edge::XMin,
            Self::Y => Edge::YMin,
        }
    }
}

/// Several members that can be lined up and spaced out, in their order. Lengths in µm.
///
/// ```
/// # use phidl_core::prelude::*;
/// let square = |side: f64| Polygon::new([(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)], 0);
/// let mut row = square(1.0) + square(5.0) + square(3.0);
/// row.distribute(Direction::X, 2.0).align(Edge::YMax);
/// assert_eq!(row.size(), Size::new(13.0, 5.0));
/// ```
///
/// An empty member has no edge. Nothing is moved then, and the error is deferred to the next fallible call on the group,
/// or to `build` for a selection.
pub trait Align {
    /// The box of every member, in order.
    fn member_boxes(&self) -> Vec<Option<Rect>>;

    /// Moves one member.
    fn move_member(&mut self, index: usize, by: Point);

    /// Keeps the first invalid call; see [`Transformable::defer`](super::Transformable::defer).
    fn defer_align_error(&mut self, error: DeferredError);

    /// Moves every member until this edge of it is where this edge of all of them together was.
    fn align(&mut self, edge: Edge) -> &mut Self {
        let Some(boxes) = boxes(self, "align") else { return self };
        if let Some(all) = boxes.iter().copied().reduce(Rect::union) {
            shift_edges(self, &boxes, edge, |_| edge.of(all));
        }
        self
    }

    /// Leaves `spacing` between neighbors, from the first member on, which stays; a negative one overlaps them.
    fn distribute(&mut self, direction: Direction, spacing: impl Into<f64>) -> &mut Self {
        let spacing = spacing.into();
        let Some(boxes) = boxes(self, "distribute").filter(|_| accept_spacing(self, "distribute", spacing)) else {
            return self;
        };
        let edge = direction.lower_edge();
        let mut next = boxes.first().map_or(0.0, |first| edge.of(*first));
        let targets: Vec<f64> = boxes
            .iter()
            .map(|b| {
                let target = next;
                next += spacing + direction.extent(*b);
                target
            })
            .collect();
        shift_edges(self, &boxes, edge, |i| targets[i]);
        self
    }

    /// Puts the same edge of every member `pitch` after that of the one before; the first member stays.
    fn distribute_by(&mut self, edge: Edge, pitch: impl Into<f64>) -> &mut Self {
        let pitch = pitch.into();
        let Some(boxes) = boxes(self, "distribute_by").filter(|_| accept_spacing(self, "distribute_by", pitch)) else {
            return self;
        };
        let start = boxes.first().map_or(0.0, |first| edge.of(*first));
        shift_edges(self, &boxes, edge, |i| start + pitch * i as f64);
        self
    }

    /// Spaces the members out with equal gaps between the first and the last one, which both stay.
    fn distribute_evenly(&mut self, direction: Direction) -> &mut Self {
        let Some(boxes) = boxes(self, "distribute_evenly") else { return self };
        let ([first, .., last], edge) = (&boxes[..], direction.lower_edge()) else { return self };
        let between: f64 = boxes[..boxes.len() - 1].iter().map(|b| direction.extent(*b)).sum();
        let gap = (edge.of(*last) - edge.of(*first) - between) / (boxes.len() - 1) as f64;
        self.distribute(direction, gap)
    }
}

/// The boxes of all members, or `None` with a deferred error if one is empty.
fn boxes<T: Align + ?Sized>(members: &mut T, method: &'static str) -> Option<Vec<Rect>> {
    let boxes = members.member_boxes();
    if let Some(empty) = boxes.iter().position(Option::is_none) {
        members.defer_align_error(DeferredError { method, reason: Reason::EmptyMember(empty) });
    }
    boxes.into_iter().collect()
}

fn accept_spacing<T: Align + ?Sized>(members: &mut T, method: &'static str, spacing: f64) -> bool {
    if !spacing.is_finite() {
        members.defer_align_error(DeferredError { method, reason: Reason::NumberNotFinite(spacing) });
    }
    spacing.is_finite()
}

fn shift_edges<T: Align + ?Sized>(members: &mut T, boxes: &[Rect], edge: Edge, target: impl Fn(usize) -> f64) {
    for (i, b) in boxes.iter().enumerate() {
        members.move_member(i, edge.direction().vector(target(i) - edge.of(*b)));
    }
}
