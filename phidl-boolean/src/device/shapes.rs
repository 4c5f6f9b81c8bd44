//! [`Shapes`]: the types that an operation accepts as an operand.

use phidl_core::geom::{Point, Rect};
use phidl_core::layer::Layer;
use phidl_core::scene::{Device, DeviceBuilder, Element, Group, Polygon, Reference};
use phidl_core::{Error, Result};

/// The layer of outlines that have none.
const NO_LAYER: Layer = Layer::new(0, 0);

/// An operand: a device, a reference or array, a polygon, a group, outlines, and lists of all these, also nested.
///
/// The cells below a device belong to it. Layers do not matter, except to [`xor_diff`](crate::xor_diff) and
/// [`union_by_layer`](crate::union_by_layer), where outlines are on layer 0. `()` is the empty operand.
///
/// ```
/// use phidl_boolean::{Options, union};
/// use phidl_core::prelude::*;
///
/// let mut d = Device::builder("pad");
/// d.add_polygon([(0, 0), (2, 0), (2, 2), (0, 2)], 1)?;
/// let pad = d.build()?;
/// let outlines = vec![vec![(1.0, 1.0), (3.0, 1.0), (3.0, 3.0)]];
/// let all = union(&(&pad, pad.array(2, 2, (10, 10)), outlines), 5, &Options::default())?;
/// assert_eq!(all.polygons().count(), 4);
/// # Ok::<(), phidl_core::Error>(())
/// ```
pub trait Shapes {
    /// Adds the shapes to an open cell.
    ///
    /// # Errors
    /// A shape that no cell accepts: fewer than three points, a coordinate that is not finite.
    fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()>;
}

impl Shapes for () {
    fn add_to(&self, _: &mut DeviceBuilder) -> Result<()> {
        Ok(())
    }
}

macro_rules! elements {
    ($($element:ty),*) => {$(
        impl Shapes for $element {
            fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
                cell.add(self.clone());
                Ok(())
            }
        }
    )*};
}

elements!(Device, Reference, Polygon, Group);

impl Shapes for Element {
    fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
        Group::from(self.clone()).add_to(cell)
    }
}

impl Shapes for Rect {
    fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
        cell.add_polygon(*self, NO_LAYER).map(drop)
    }
}

/// Outlines: lists of points of any type.
macro_rules! outlines {
    ($($point:ty),*) => {$(
        impl Shapes for [$point] {
            fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
                cell.add_polygon(self, NO_LAYER).map(drop)
            }
        }

        impl Shapes for Vec<$point> {
            fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
                self.as_slice().add_to(cell)
            }
        }

        impl<const N: usize> Shapes for [$point; N] {
            fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
                self.as_slice().add_to(cell)
            }
        }
    )*};
}

outlines!(Point, (f64, f64), [f64; 2], (i32, i32), [i32; 2]);

impl<S: Shapes + ?Sized> Shapes for &S {
    fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
        (**self).add_to(cell)
    }
}

impl<S: Shapes> Shapes for Option<S> {
    fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
        self.iter().try_for_each(|shapes| shapes.add_to(cell))
    }
}

impl<S: Shapes> Shapes for [S] {
    fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
        let numbered = |(i, shapes): (usize, &S)| {
            shapes.add_to(cell).map_err(|error| Error::within(error, format!("shape {i} of a list")))
        };
        self.iter().enumerate().try_for_each(numbered)
    }
}

impl<S: Shapes> Shapes for Vec<S> {
    fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
        self.as_slice().add_to(cell)
    }
}

impl<S: Shapes, const N: usize> Shapes for [S; N] {
    fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
        self.as_slice().add_to(cell)
    }
}

macro_rules! tuples {
    ($(($($name:ident),*))*) => {$(
        impl<$($name: Shapes),*> Shapes for ($($name,)*) {
            #[expect(non_snake_case, reason = "the members are called like their types")]
            fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
                let ($($name,)*) = self;
                $($name.add_to(cell)?;)*
                Ok(())
            }
        }
    )*};
}

tuples!((A)(A, B)(A, B, C)(A, B, C, D));

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(shapes: &(impl Shapes + ?Sized)) -> Result<usize> {
        let mut cell = Device::builder("operand");
        shapes.add_to(&mut cell)?;
        Ok(cell.build()?.flat_polygons().count())
    }

    #[test]
    fn every_kind_of_shape_and_every_nesting_of_them_is_drawn() {
        let corners = [(0, 0), (4, 0), (0, 4)];
        let polygon = Polygon::new(corners, 3);
        let mut d = Device::builder("pad");
        d.add_polygon(corners, [1, 2]).unwrap();
        let pad = d.build().unwrap();
        assert_eq!(drawn(&()), Ok(0));
        assert_eq!(drawn(&None::<Device>), Ok(0));
        assert_eq!(drawn(&corners), Ok(1));
        assert_eq!(drawn(&vec![corners.to_vec(), corners.to_vec()]), Ok(2));
        assert_eq!(drawn(&polygon), Ok(1));
        assert_eq!(drawn(&(polygon.clone() + polygon.clone())), Ok(2));
        assert_eq!(drawn(&[pad.array(3, 2, (9, 9)), pad.place()]), Ok(14));
        assert_eq!(drawn(&(&pad, vec![Some(polygon), None], [[corners]], Rect::new((0, 0), (1, 1)))), Ok(5));
    }

    #[test]
    fn an_invalid_shape_is_refused_with_its_number() {
        let error = drawn(&vec![vec![(0, 0), (1, 0), (0, 1)], vec![(0, 0), (1, 0)]]).unwrap_err();
        assert!(error.report().starts_with("in shape 1 of a list: operand: an outline has 2 points"), "{error:?}");
        assert!(drawn(&[(0.0, f64::NAN), (1.0, 0.0), (0.0, 1.0)]).is_err());
    }
}
