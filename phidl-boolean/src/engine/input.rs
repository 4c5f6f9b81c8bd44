//! What an operation takes in: two operands and the rule that says what is covered.

use crate::{
    contours::Contours,
    op::{Fill, Operation},
};

/// One side of an operation.
#[derive(Clone, Copy)]
pub(crate) enum Operand<'a> {
    /// Shapes of any direction that may cross themselves: each is filled on its own, then all are united.
    Shapes(&'a Contours),
    /// Contours whose direction and overlap have meaning: winding numbers are taken as they are.
    Oriented(&'a Contours),
}

impl<'a> Operand<'a> {
    pub(super) fn contours(self) -> &'a Contours {
        match self {
            Self::Shapes(contours) | Self::Oriented(contours) => contours,
        }
    }
}

/// Which faces of the arrangement belong to the result; each face has one winding number per operand.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rule {
    pub(crate) operation: Operation,
    pub(crate) fill: Fill,
}

impl Rule {
    #[inline]
    pub(super) fn covers(self, winding: [i32; 2]) -> bool {
        self.operation.keeps(self.fill.covers(winding[0]), self.fill.covers(winding[1]))
    }
}
