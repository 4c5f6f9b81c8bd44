//! The set operations and the fill rules.

use std::str::FromStr;

use crate::error::BooleanError;

/// A set operation between two operands `A` and `B`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Operation {
    /// `A ∪ B`
    Or,
    /// `A ∩ B`
    And,
    /// `A ∖ B`
    Not,
    /// `B ∖ A`
    BMinusA,
    /// Covered by exactly one of the two.
    Xor,
}

impl Operation {
    /// The truth table of the operation.
    #[inline]
    pub const fn keeps(self, in_a: bool, in_b: bool) -> bool {
        match self {
            Self::Or => in_a | in_b,
            Self::And => in_a & in_b,
            Self::Not => in_a & !in_b,
            Self::BMinusA => in_b & !in_a,
            Self::Xor => in_a ^ in_b,
        }
    }
}

impl FromStr for Operation {
    type Err = BooleanError;

    /// Reads an operation as layout scripts spell it; case and blanks do not matter.
    ///
    /// # Examples
    /// ```
    /// use phidl_boolean::Operation;
    /// assert_eq!("A - B".parse(), Ok(Operation::Not));
    /// assert_eq!("XOR".parse(), Ok(Operation::Xor));
    /// ```
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let name: String = text.chars().filter(|c| !c.is_whitespace()).collect();
        match name.to_lowercase().as_str() {
            "or" | "a+b" => Ok(Self::Or),
            "and" | "a&b" => Ok(Self::And),
            "not" | "a-b" => Ok(Self::Not),
            "b-a" => Ok(Self::BMinusA),
            "xor" | "a^b" => Ok(Self::Xor),
            _ => Err(BooleanError::UnknownOperation { text: text.to_owned() }),
        }
    }
}

/// The fill rule: which winding numbers are covered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fill {
    /// Every winding number but zero: both lobes of a figure-eight are covered.
    NonZero,
    /// Winding numbers above zero: the inside of a raw offset contour.
    Positive,
}

impl Fill {
    #[inline]
    pub(crate) const fn covers(self, winding: i32) -> bool {
        match self {
            Self::NonZero => winding != 0,
            Self::Positive => winding > 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_of_layout_scripts_is_read() {
        for (text, operation) in [
            ("or", Operation::Or),
            ("A+B", Operation::Or),
            ("and", Operation::And),
            ("A&B", Operation::And),
            ("not", Operation::Not),
            ("a-b", Operation::Not),
            ("B-A", Operation::BMinusA),
            (" Xor ", Operation::Xor),
            ("A ^ B", Operation::Xor),
        ] {
            assert_eq!(text.parse(), Ok(operation), "{text}");
        }
    }

    #[test]
    fn an_unknown_operation_names_the_known_ones() {
        let error = "A*B".parse::<Operation>().unwrap_err().to_string();
        assert!(error.contains("A*B") && error.contains("B-A"), "{error}");
    }
}
