//! [`Margin`]: the distance between shapes and the box around them.

/// The margin of a box around shapes, in x and in y (µm); negative margins shrink the box.
///
/// ```
/// use phidl_boolean::Margin;
/// assert_eq!(Margin::from(5), Margin::from((5.0, 5.0)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margin {
    /// To the left and to the right (µm).
    pub x: f64,
    /// Downward and upward (µm).
    pub y: f64,
}

impl From<f64> for Margin {
    fn from(margin: f64) -> Self {
        Self { x: margin, y: margin }
    }
}

impl From<i32> for Margin {
    fn from(margin: i32) -> Self {
        f64::from(margin).into()
    }
}

impl<X: Into<f64>, Y: Into<f64>> From<(X, Y)> for Margin {
    fn from((x, y): (X, Y)) -> Self {
        Self { x: x.into(), y: y.into() }
    }
}
