//! The placement methods of an open cell, for elements that are in it.
//!
//! Each takes its [`Target`] first, so one statement reads one element and moves another:
//! `d.set_xmin(a, d.xmax(b) + 5.0)`. (`d[a].set_xmin(d[b].xmax() + 5.0)` borrows the cell twice.) `..` is the whole cell.

use super::{DeviceBuilder, PortTarget, ReferenceTarget, Target};
use crate::error::Result;
use crate::geom::{Point, Rect, Size};
use crate::place::{Align, Bounded, Direction, Edge, Movable};

macro_rules! placing {
    ($($(#[$doc:meta])* fn $name:ident($($argument:ident: $type:ty),*);)*) => {
        impl DeviceBuilder {$(
            $(#[$doc])*
            ///
            /// An invalid argument, a key that finds nothing and an empty element are deferred errors.
            pub fn $name(&mut self, target: impl Target $(, $argument: $type)*) -> &mut Self {
                self.group(target).$name($($argument),*);
                self
            }
        )*}
    };
}

placing! {
    /// Moves elements by a vector.
    fn move_by(by: impl Into<Point>);
    /// Moves elements by the vector from `origin` to `destination`.
    fn move_to(origin: impl Into<Point>, destination: impl Into<Point>);
    /// Moves elements to the right.
    fn movex(by: impl Into<f64>);
    /// Moves elements up.
    fn movey(by: impl Into<f64>);
    /// Moves elements along x only, by the distance from `origin` to `destination`.
    fn movex_to(origin: impl Into<Point>, destination: impl Into<Point>);
    /// Moves elements along y only, by the distance from `origin` to `destination`.
    fn movey_to(origin: impl Into<Point>, destination: impl Into<Point>);
    /// Rotates elements about the origin.
    fn rotate(degrees: impl Into<f64>);
    /// Rotates elements about a point.
    fn rotate_about(degrees: impl Into<f64>, center: impl Into<Point>);
    /// Mirrors elements across the line through two points.
    fn mirror(p1: impl Into<Point>, p2: impl Into<Point>);
    /// Scales elements about the origin.
    fn scale(factor: impl Into<f64>);
    /// Moves elements until their common center is at a point.
    fn set_center(to: impl Into<Point>);
    /// Moves elements along x until their center has this coordinate.
    fn set_x(to: impl Into<f64>);
    /// Moves elements along y until their center has this coordinate.
    fn set_y(to: impl Into<f64>);
    /// Moves elements along x until their left edge has this coordinate.
    fn set_xmin(to: impl Into<f64>);
    /// Moves elements along x until their right edge has this coordinate.
    fn set_xmax(to: impl Into<f64>);
    /// Moves elements along y until their lower edge has this coordinate.
    fn set_ymin(to: impl Into<f64>);
    /// Moves elements along y until their upper edge has this coordinate.
    fn set_ymax(to: impl Into<f64>);
    /// Moves every member until this edge of it is where this edge of all of them together was.
    fn align(edge: Edge);
    /// Leaves `spacing` between neighbors, from the first member on, which stays.
    fn distribute(direction: Direction, spacing: impl Into<f64>);
    /// Moves the same edge of every member to `pitch` after that of the one before; the first member stays.
    fn distribute_by(edge: Edge, pitch: impl Into<f64>);
    /// Leaves equal gaps between the first and the last member, which both stay.
    fn distribute_evenly(direction: Direction);
}

/// The bounding box of a target, which gives its readers.
struct Bounds(Option<Rect>);

impl Bounded for Bounds {
    fn bbox(&self) -> Option<Rect> {
        self.0
    }
}

macro_rules! reading {
    ($($(#[$doc:meta])* fn $name:ident() -> $type:ty;)*) => {
        impl DeviceBuilder {$(
            $(#[$doc])*
            /// NaN for empty elements; see [`Bounded`].
            ///
            /// # Panics
            /// As `d[key]`, if a key or alias finds nothing or belongs to another cell.
            #[must_use]
            pub fn $name(&self, target: impl Target) -> $type {
                match self.bbox_of(target) {
                    Ok(bbox) => Bounds(bbox).$name(),
                    Err(error) => panic!("{error}"),
                }
            }
        )*}
    };
}

reading! {
    /// The center of the bounding box of elements.
    fn center() -> Point;
    /// Width and height of the bounding box of elements.
    fn size() -> Size;
    /// Width of the bounding box of elements.
    fn xsize() -> f64;
    /// Height of the bounding box of elements.
    fn ysize() -> f64;
    /// The center of elements along x.
    fn x() -> f64;
    /// The center of elements along y.
    fn y() -> f64;
    /// The left edge of elements.
    fn xmin() -> f64;
    /// The right edge of elements.
    fn xmax() -> f64;
    /// The lower edge of elements.
    fn ymin() -> f64;
    /// The upper edge of elements.
    fn ymax() -> f64;
}

impl DeviceBuilder {
    /// The common bounding box of elements; `None` if they are empty.
    ///
    /// # Errors
    /// A key or alias that finds nothing or belongs to another cell.
    pub fn bbox_of(&self, target: impl Target) -> Result<Option<Rect>> {
        if target.is_whole_cell() {
            return Ok(self.cell.bbox());
        }
        let boxes: Result<Vec<Option<Rect>>> =
            target.keys(self)?.into_iter().map(|key| self.bbox_of_key(key)).collect();
        Ok(Rect::union_all(boxes?))
    }

    /// Rotates and moves a reference until its port `own` meets another port face to face.
    ///
    /// ```
    /// # use phidl_core::prelude::*;
    /// # let mut d = Device::builder("bar");
    /// # d.add_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], 1)?;
    /// # d.add_port("1", ((0, 1), 2, 180))?.add_port("2", ((4, 1), 2, 0))?;
    /// # let bar = d.build()?;
    /// let mut d = Device::builder("chain");
    /// let [a, b, c] = d.add([&bar, &bar, &bar]);
    /// d.rotate(a, 30).connect(b, "1", (a, "2"))?.connect(c, "1", (b, "2"))?;
    /// assert!((d.x(c) - 10.0 * 30_f64.to_radians().cos() + 0.5).abs() < 1e-9);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Reference::connect`](super::Reference::connect), and a key or alias that finds nothing.
    pub fn connect(
        &mut self,
        reference: impl ReferenceTarget,
        own: &str,
        target: impl PortTarget,
    ) -> Result<&mut Self> {
        self.connect_overlapping(reference, own, target, 0.0)
    }

    /// As [`DeviceBuilder::connect`], pushed `overlap` µm into the target (a negative one leaves a gap).
    ///
    /// # Errors
    /// As for [`DeviceBuilder::connect`], and an overlap that is not finite.
    pub fn connect_overlapping(
        &mut self,
        reference: impl ReferenceTarget,
        own: &str,
        target: impl PortTarget,
        overlap: impl Into<f64>,
    ) -> Result<&mut Self> {
        let target = target.port(self)?;
        let key = reference.reference_key(self)?;
        self.reference_mut(key)?.connect_overlapping(own, &target, overlap)?;
        Ok(self)
    }
}
