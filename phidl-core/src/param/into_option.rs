//! [`IntoOption`]: `5`, `5.0` and `None`, all for an optional length.
//!
//! The table is written out type by type. A blanket implementation for every type that converts would make a bare
//! `None` ambiguous: the compiler could not infer the type.

use std::collections::BTreeMap;

use super::Value;
use crate::geom::{Point, Size};
use crate::layer::{Layer, LayerSet, Layers};
use crate::port::Port;
use crate::runtime::{Generator, Partial};
use crate::scene::Device;

/// What is taken for an optional parameter: the option itself, or what converts to its inside without loss.
///
/// ```
/// # use phidl_core::param::IntoOption;
/// fn length(v: impl IntoOption<f64>) -> Option<f64> {
///     v.into_option()
/// }
/// assert_eq!((length(5), length(0.5), length(None)), (Some(5.0), Some(0.5), None));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be given for an optional `{T}`",
    note = "give the value itself, or `None`"
)]
pub trait IntoOption<T> {
    /// The option.
    fn into_option(self) -> Option<T>;
}

impl<T> IntoOption<T> for Option<T> {
    fn into_option(self) -> Self {
        self
    }
}

macro_rules! options {
    ($($to:ty: $($from:ty),+;)*) => {$($(
        impl IntoOption<$to> for $from {
            fn into_option(self) -> Option<$to> {
                Some(self.into())
            }
        }
    )+)*};
}

options! {
    f64: f64, f32, i32, u32, i16, u16, i8, u8;
    bool: bool;
    char: char;
    i64: i64;
    i32: i32;
    i16: i16;
    i8: i8;
    u32: u32;
    u16: u16;
    u8: u8;
    usize: usize;
    String: String, &str, &String;
    Point: Point, &Point, Port, &Port;
    Size: Size, &Size;
    Layer: Layer, u16, (u16, u16);
    Layers: Layers, &Layers, u16, (u16, u16), Layer, &LayerSet;
    Port: Port, &Port;
    Device: Device, &Device;
    Value: Value, f64, i32, bool, &str, String;
    Partial: Partial;
}

impl<X: Into<f64>, Y: Into<f64>> IntoOption<Point> for (X, Y) {
    fn into_option(self) -> Option<Point> {
        Some(self.into())
    }
}

impl<W: Into<f64>, H: Into<f64>> IntoOption<Size> for (W, H) {
    fn into_option(self) -> Option<Size> {
        Some(self.into())
    }
}

impl<P: Into<Point>, W: Into<f64>, O: Into<f64>> IntoOption<Port> for (P, W, O) {
    fn into_option(self) -> Option<Port> {
        Some(self.into())
    }
}

impl<L: Into<Layer>, const N: usize> IntoOption<Layers> for [L; N] {
    fn into_option(self) -> Option<Layers> {
        Some(self.into())
    }
}

impl<G: Generator> IntoOption<Partial> for G {
    fn into_option(self) -> Option<Partial> {
        Some(self.into())
    }
}

impl<T> IntoOption<Self> for Vec<T> {
    fn into_option(self) -> Option<Self> {
        Some(self)
    }
}

impl<T, U: Into<T>, const N: usize> IntoOption<Vec<T>> for [U; N] {
    fn into_option(self) -> Option<Vec<T>> {
        Some(self.into_iter().map(Into::into).collect())
    }
}

impl<T> IntoOption<Self> for BTreeMap<String, T> {
    fn into_option(self) -> Option<Self> {
        Some(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken<T>(v: impl IntoOption<T>) -> Option<T> {
        v.into_option()
    }

    #[test]
    fn bare_values_and_bare_none_are_options() {
        assert_eq!(taken::<Layers>(1), Some(Layers::from(1)));
        assert_eq!(taken::<Layers>([1, 2]), Some(Layers::from([1, 2])));
        assert_eq!(taken::<usize>(3), Some(3));
        assert_eq!(taken::<Point>((1, 2.5)), Some(Point::new(1.0, 2.5)));
        assert_eq!(taken::<String>("p"), Some("p".to_owned()));
        assert_eq!(taken::<Vec<f64>>([1, 2]), Some(vec![1.0, 2.0]));
        assert_eq!(taken::<Port>(None), None);
        assert_eq!(taken::<Device>(None), None);
    }
}
