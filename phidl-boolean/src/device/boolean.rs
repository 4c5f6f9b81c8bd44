//! Set operations on devices: [`boolean`], [`union`], [`union_by_layer`], [`xor_diff`].

use phidl_core::layer::Layers;
use phidl_core::scene::Device;

use super::{
    Options, Shapes,
    draw::{drawn, drawn_by_layer},
    operand::Operand,
    operation::DeviceOperation,
};
use crate::{
    error::{BooleanError, in_function},
    op::Operation,
};

/// An operation, or its name as in layout scripts: `"and"`, `"A-B"`, …
pub trait IntoOperation {
    /// The operation.
    ///
    /// # Errors
    /// [`BooleanError::UnknownOperation`] for an unknown name.
    fn into_operation(self) -> Result<Operation, BooleanError>;
}

impl IntoOperation for Operation {
    fn into_operation(self) -> Result<Operation, BooleanError> {
        Ok(self)
    }
}

impl IntoOperation for &str {
    fn into_operation(self) -> Result<Operation, BooleanError> {
        self.parse()
    }
}

/// Runs a set operation on two operands and draws the result as a device called `boolean`.
///
/// Each operand is the union of its shapes, of any direction and layer; a shape that crosses itself covers all its lobes. An operand without shapes is the empty set, so `boolean(&d, &(), "or", …)` merges `d`. An empty result
/// is a device without polygons.
///
/// # Errors
/// An unknown operation, a coordinate off the grid (with the cell it is in), an option out of its range.
///
/// # Examples
/// ```
/// use phidl_boolean::{Options, boolean};
/// use phidl_core::prelude::*;
/// let plate = Rect::new((0, 0), (10, 10));
/// let frame = boolean(&plate, &Rect::new((3, 3), (7, 7)), "not", 1, &Options::default())?;
/// assert_eq!(frame.polygons().map(|p| p.area()).sum::<f64>(), 84.0);
/// assert_eq!(frame.polygons().count(), 1); // its hole is cut open
/// # Ok::<(), Error>(())
/// ```
pub fn boolean(
    a: &(impl Shapes + ?Sized),
    b: &(impl Shapes + ?Sized),
    operation: impl IntoOperation,
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    in_function("boolean", || {
        let operation = DeviceOperation::Combine(operation.into_operation()?);
        let operands = [Operand::new("A", a)?, Operand::new("B", b)?];
        drawn("boolean", operation, &operands, &layer.into(), options)
    })
}

/// Merges the shapes of all layers into a device called `union`.
///
/// # Errors
/// As for [`boolean`].
pub fn union(
    shapes: &(impl Shapes + ?Sized),
    layer: impl Into<Layers>,
    options: &Options,
) -> Result<Device, BooleanError> {
    in_function("union", || {
        drawn("union", DeviceOperation::Combine(Operation::Or), &united(shapes)?, &layer.into(), options)
    })
}

/// Merges the shapes of each layer on its own, into a device called `union` with the same layers.
///
/// # Errors
/// As for [`boolean`].
pub fn union_by_layer(shapes: &(impl Shapes + ?Sized), options: &Options) -> Result<Device, BooleanError> {
    in_function("union", || drawn_by_layer("union", DeviceOperation::Combine(Operation::Or), &united(shapes)?, options))
}

fn united(shapes: &(impl Shapes + ?Sized)) -> Result<[Operand; 2], BooleanError> {
    Ok([Operand::new("shapes", shapes)?, Operand::new("nothing", &())?])
}

/// The difference of two operands, layer by layer, as a device called `xor_diff`. Equal operands give a device without
/// polygons.
///
/// # Errors
/// As for [`boolean`].
///
/// # Examples
/// ```
/// use phidl_boolean::{Options, xor_diff};
/// use phidl_core::prelude::*;
/// let square = |x: f64, layer: u16| Polygon::new([(x, 0.0), (x + 2.0, 0.0), (x + 2.0, 2.0), (x, 2.0)], layer);
/// let difference = xor_diff(&[square(0.0, 1), square(0.0, 2)], &[square(0.0, 1), square(0.5, 2)], &Options::default())?;
/// assert_eq!(difference.layers(), [Layer::new(2, 0)]);
/// # Ok::<(), Error>(())
/// ```
pub fn xor_diff(
    a: &(impl Shapes + ?Sized),
    b: &(impl Shapes + ?Sized),
    options: &Options,
) -> Result<Device, BooleanError> {
    in_function("xor_diff", || {
        let operands = [Operand::new("A", a)?, Operand::new("B", b)?];
        drawn_by_layer("xor_diff", DeviceOperation::Combine(Operation::Xor), &operands, options)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use phidl_core::geom::Rect;
    use phidl_core::layer::Layer;
    use phidl_core::place::Movable;
    use phidl_core::scene::Polygon;

    fn area(device: &Device) -> f64 {
        device.polygons().map(|p| p.area()).sum()
    }

    fn square() -> Device {
        let mut d = Device::builder("square");
        d.add_polygon(Rect::new((0, 0), (1, 1)), 7).unwrap();
        d.build().unwrap()
    }

    #[test]
    fn hierarchies_arrays_mirrors_and_magnification_are_followed() {
        let mut d = Device::builder("row");
        d.add(square().array(3, 1, (2, 0)));
        let row = d.build().unwrap().place().rotated(90).mirrored((0, 0), (0, 1));
        let mut d = Device::builder("rows");
        d.add(row);
        let rows = d.build().unwrap();
        // Squares at x from 0 to 1 and y from 0, 2 and 4; the bar covers half of each.
        let bar = Rect::new((0.5, 0.0), (9.0, 9.0));
        let cut = boolean(&rows, &bar, "and", 3, &Options::default()).unwrap();
        assert!((area(&cut) - 1.5).abs() < 1e-9);
        assert_eq!(cut.layers(), [Layer::new(3, 0)]);
        assert_eq!(cut.references().len(), 0);
    }

    #[test]
    fn the_operands_of_b_minus_a_are_exchanged() {
        let (a, b) = (Rect::new((0, 0), (10, 10)), Rect::new((5, 5), (15, 16)));
        for (operation, expected) in [("A-B", 75.0), ("B-A", 85.0), ("or", 185.0), ("A&B", 25.0), ("A^B", 160.0)] {
            let result = boolean(&a, &b, operation, 0, &Options::default()).unwrap();
            assert!((area(&result) - expected).abs() < 1e-6, "{operation}: {}", area(&result));
        }
        let error = boolean(&a, &b, "A*B", 0, &Options::default()).unwrap_err();
        assert!(error.to_string().starts_with("boolean: operation is \"A*B\""), "{error}");
    }

    #[test]
    fn layers_are_merged_together_or_one_by_one() {
        let two = [Polygon::new(Rect::new((0, 0), (2, 2)), 1), Polygon::new(Rect::new((1, 0), (3, 2)), 2)];
        let all = union(&two, 5, &Options::default()).unwrap();
        assert_eq!((all.polygons().count(), area(&all)), (1, 6.0));
        let each = union_by_layer(&two, &Options::default()).unwrap();
        assert_eq!((each.layers(), area(&each)), (vec![1.into(), 2.into()], 8.0));
        assert!(union(&(), 5, &Options::default()).unwrap().is_empty());
    }

    #[test]
    fn a_layer_of_one_operand_only_differs_as_a_whole() {
        let one = Polygon::new(Rect::new((0, 0), (2, 2)), 1);
        let difference = xor_diff(&one, &Polygon::new(Rect::new((0, 0), (2, 2)), 2), &Options::default()).unwrap();
        assert_eq!(difference.layers(), [Layer::new(1, 0), Layer::new(2, 0)]);
        assert!(xor_diff(&one, &one, &Options::default()).unwrap().is_empty());
    }

    #[test]
    fn a_coordinate_off_the_grid_is_refused_with_the_function_and_the_cell() {
        let mut d = Device::builder("far");
        d.add_polygon([(0.0, 0.0), (1e9, 0.0), (0.0, 1.0)], 1).unwrap();
        let error = union(&d.build().unwrap(), 1, &Options::default()).unwrap_err();
        assert!(error.to_string().starts_with("union: in cell far: shape 0: coordinate 1000000000 µm"), "{error}");
        assert!(matches!(error.root(), BooleanError::OffGrid { .. }));
    }
}
