//! The laws that the placement methods keep for every element that moves.

use std::fmt::Debug;

use phidl_core::prelude::*;
use proptest::prelude::*;

/// Rounding that a few operations within a few millimeters may leave (µm).
const NOISE: f64 = 1e-8;

/// Checks the laws for one element: there and back, quarter turns, mirror twice, setters, and methods against transforms.
///
/// # Errors
/// The law that does not hold.
pub fn placement_laws<T: Movable + Clone + Debug>(element: &T, t: &Transform) -> Result<(), TestCaseError> {
    four_quarter_turns_are_the_identity(element)?;
    there_and_back(element, t)?;
    methods_agree_with_transforms(element, t)?;
    if element.bbox().is_some() {
        setters_put_edges_where_they_say(element, t)?;
    }
    Ok(())
}

fn four_quarter_turns_are_the_identity<T: Movable + Clone + Debug>(element: &T) -> Result<(), TestCaseError> {
    let turned = element.clone().rotated(90).rotated(90).rotated(90).rotated(90);
    prop_assert_eq!(turned.bbox(), element.bbox());
    prop_assert_eq!(format!("{:?}", turned), format!("{:?}", element), "exactly, in all that it holds");
    Ok(())
}

fn there_and_back<T: Movable + Clone + Debug>(element: &T, t: &Transform) -> Result<(), TestCaseError> {
    let mut back = element.clone();
    back.transform_mut(t);
    back.transform_mut(&t.inverse());
    same_box(&back, element, "a transform and its inverse")?;
    let (p, q) = (t.origin, t.origin + Point::new(1.0, 2.0));
    same_box(&element.clone().mirrored(p, q).mirrored(p, q), element, "mirror twice")?;
    same_box(&element.clone().moved_by(p).moved_by(-p), element, "move there and back")?;
    let turn = t.rotation;
    same_box(&element.clone().rotated_about(turn, p).rotated_about(-turn, p), element, "turn there and back")
}

fn methods_agree_with_transforms<T: Movable + Clone + Debug>(element: &T, t: &Transform) -> Result<(), TestCaseError> {
    let mut at_once = element.clone();
    at_once.transform_mut(t);
    let mut by_methods = element.clone();
    if t.x_reflection {
        by_methods.mirror((0, 0), (1, 0));
    }
    by_methods.scale(t.magnification).rotate_about(t.rotation, Point::ORIGIN).move_by(t.origin);
    same_box(&by_methods, &at_once, "mirror, scale, rotate, move")
}

fn setters_put_edges_where_they_say<T: Movable + Clone>(element: &T, t: &Transform) -> Result<(), TestCaseError> {
    let (x, y) = (t.origin.x, t.origin.y);
    let near = |a: f64, b: f64| (a - b).abs() < NOISE;
    let size = element.size();
    let mut moved = element.clone();
    prop_assert!(near(moved.set_xmin(x).xmin(), x) && near(moved.set_ymin(y).ymin(), y));
    prop_assert!(near(moved.set_xmax(x).xmax(), x) && near(moved.set_ymax(y).ymax(), y));
    prop_assert!(near(moved.set_x(x).x(), x) && near(moved.set_y(y).y(), y));
    prop_assert!(moved.set_center(t.origin).center().distance(t.origin) < NOISE);
    prop_assert!(near(moved.size().width, size.width) && near(moved.size().height, size.height));
    Ok(())
}

fn same_box<T: Bounded>(a: &T, b: &T, law: &str) -> Result<(), TestCaseError> {
    match (a.bbox(), b.bbox()) {
        (Some(a), Some(b)) => {
            prop_assert!(a.min.distance(b.min) < NOISE && a.max.distance(b.max) < NOISE, "{law}: {a} is not {b}");
        }
        (a, b) => prop_assert_eq!(a, b, "{}", law),
    }
    Ok(())
}
