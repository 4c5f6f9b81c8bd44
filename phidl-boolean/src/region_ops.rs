//! The operations that make a [`Region`]: union of shapes, set operations between regions, operators.

use std::ops::{BitAnd, BitOr, BitXor, Sub};

use crate::{
    contours::Contours,
    engine::{Operand, Rule, resolve},
    error::BooleanError,
    op::{Fill, Operation},
    options::RunOptions,
    region::Region,
};

/// A set operation between two lists of shapes.
pub(crate) fn combine_shapes(
    a: &Contours,
    b: &Contours,
    operation: Operation,
    options: &RunOptions,
) -> Result<Region, BooleanError> {
    resolve([Operand::Shapes(a), Operand::Shapes(b)], Rule { operation, fill: Fill::NonZero }, options)
}

impl Region {
    /// The union of shapes of any direction, which may overlap, cross themselves and repeat points.
    ///
    /// # Errors
    /// See [`boolean`](crate::grid::boolean).
    pub fn merged(shapes: &Contours, options: &RunOptions) -> Result<Self, BooleanError> {
        combine_shapes(shapes, &Contours::new(), Operation::Or, options)
    }

    /// A set operation between two regions.
    ///
    /// # Errors
    /// See [`boolean`](crate::grid::boolean).
    pub fn combine(&self, other: &Self, operation: Operation, options: &RunOptions) -> Result<Self, BooleanError> {
        let rule = Rule { operation, fill: Fill::NonZero };
        resolve([Operand::Oriented(self.contours()), Operand::Oriented(other.contours())], rule, options)
    }
}

/// Operators cannot fail, because the engine refuses every bad input before a region exists:
///
/// - coordinates: the engine takes points within the range only, and new ones are grid points between them (an offset
///   that leaves the range is refused);
/// - size: results are limited to half of what one operation takes, so that any two regions fit together;
/// - options: those used here are valid, start no threads, limit no memory and have no monitor.
macro_rules! operator {
    ($trait:ident, $method:ident, $operation:expr, $doc:literal) => {
        impl $trait for &Region {
            type Output = Region;

            #[doc = $doc]
            fn $method(self, other: Self) -> Region {
                self.combine(other, $operation, &RunOptions { memory_limit: usize::MAX, ..RunOptions::default() })
                    .expect("invariant: regions are in range and small enough, and the options are valid")
            }
        }

        impl $trait for Region {
            type Output = Region;

            #[doc = $doc]
            fn $method(self, other: Self) -> Region {
                $trait::$method(&self, &other)
            }
        }
    };
}

operator!(BitOr, bitor, Operation::Or, "The union.");
operator!(BitAnd, bitand, Operation::And, "The intersection.");
operator!(BitXor, bitxor, Operation::Xor, "The area that exactly one of the two covers.");
operator!(Sub, sub, Operation::Not, "The area of the first without that of the second.");
