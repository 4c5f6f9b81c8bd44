//! What can go wrong: one enum for the crate, one variant for each broken rule.
//!
//! Inside a generator, `?` turns it into the error of the scene graph, with the function as the device that refused.

use phidl_core::error::{Error, ParamError};

/// The spellings of operations.
const OPERATIONS: &str = "one of or, A+B, and, A&B, not, A-B, B-A, xor, A^B";

/// Why an operation was refused or stopped.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BooleanError {
    /// The grid step is not a positive, finite number.
    #[error("precision is {precision} µm, but it must be finite and greater than zero")]
    Precision {
        /// The refused grid step (µm).
        precision: f64,
    },
    /// A coordinate in micrometers is outside the grid.
    #[error(
        "shape {shape}: coordinate {value} µm is not a number within ±2^40 grid steps (±{limit} µm at this precision)"
    )]
    OffGrid {
        /// Index of the shape, counted from zero.
        shape: usize,
        /// The refused coordinate (µm).
        value: f64,
        /// Largest absolute coordinate at this precision (µm).
        limit: f64,
    },
    /// A point on the grid is outside the range in which the engine is exact.
    #[error("shape {shape}: point ({x}, {y}) must be within ±2^40 grid steps")]
    OutOfRange {
        /// Index of the shape, counted from zero.
        shape: usize,
        /// Coordinate of the refused point (steps).
        x: i64,
        /// Coordinate of the refused point (steps).
        y: i64,
    },
    /// An operation name is not known.
    #[error("operation is {text:?}, but it must be {OPERATIONS}")]
    UnknownOperation {
        /// The refused text.
        text: String,
    },
    /// A numeric option breaks its rule.
    #[error("{option} is {value}, but it must be {rule}")]
    Option {
        /// Name of the option.
        option: &'static str,
        /// The refused value.
        value: f64,
        /// The rule that it breaks.
        rule: &'static str,
    },
    /// The operands have more edges than the engine can number, or the result more than half as many.
    #[error("{edges} edges are too many for one operation; the limit is {limit}")]
    TooLarge {
        /// Number of edges.
        edges: usize,
        /// Largest allowed number.
        limit: usize,
    },
    /// The operation would need more memory than it may use.
    #[error(
        "{edges} edges with {crossings} crossings or more need more memory than the limit of {} MB; raise `memory_limit` \
         or divide the shapes", limit / 1_000_000
    )]
    Memory {
        /// Number of edges of the operands.
        edges: usize,
        /// Number of crossings that were found before the operation stopped.
        crossings: usize,
        /// The limit (bytes).
        limit: usize,
    },
    /// The requested threads could not be started.
    #[error("cannot start {threads} threads: {reason}")]
    Threads {
        /// Number of threads asked for.
        threads: usize,
        /// What the operating system said.
        reason: String,
    },
    /// A shape of an operand is refused by the scene graph: too few points, a coordinate that is not finite.
    #[error(transparent)]
    Scene(#[from] Error),
    /// Something is wrong with a shape of a cell.
    #[error("in cell {cell}: {source}")]
    InCell {
        /// Name of the cell.
        cell: Box<str>,
        /// What is wrong.
        source: Box<BooleanError>,
    },
    /// The result of an operation cannot keep the hierarchy.
    #[error("the hierarchy cannot be kept, because {reason}")]
    Hierarchy {
        /// Why the result is always flat.
        reason: &'static str,
    },
    /// Something went wrong in a function on devices.
    #[error("{function}: {source}")]
    Within {
        /// Name of the function.
        function: &'static str,
        /// What went wrong.
        source: Box<BooleanError>,
    },
    /// The operation was stopped through its [`crate::ProgressMonitor`].
    #[error("the operation was cancelled")]
    Cancelled,
}

impl BooleanError {
    /// This error with the function that it happened in.
    pub(crate) fn within(self, function: &'static str) -> Self {
        Self::Within { function, source: Box::new(self) }
    }

    /// What went wrong, without the function and the cell that it happened in.
    pub fn root(&self) -> &Self {
        match self {
            Self::Within { source, .. } | Self::InCell { source, .. } => source.root(),
            other => other,
        }
    }
}

/// Adds the name of a function to its error.
pub(crate) fn in_function<T>(
    function: &'static str,
    run: impl FnOnce() -> Result<T, BooleanError>,
) -> Result<T, BooleanError> {
    run().map_err(|error| error.within(function))
}

impl From<BooleanError> for Error {
    fn from(error: BooleanError) -> Self {
        let (device, error) = match error {
            BooleanError::Within { function, source } => (function, *source),
            other => ("boolean", other),
        };
        let broken = |param: &str, value: String, rule: &str| {
            Self::from(ParamError { device: device.into(), param: param.into(), value, rule: format!("be {rule}") })
        };
        match error {
            BooleanError::Scene(error) => error.within(device),
            BooleanError::Option { option, value, rule } => broken(option, value.to_string(), rule),
            BooleanError::Precision { precision } => {
                broken("precision", format!("{precision} µm"), "finite and greater than 0 µm")
            }
            BooleanError::UnknownOperation { text } => broken("operation", format!("{text:?}"), OPERATIONS),
            other => Self::custom(device, other),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_become_those_of_the_function_that_was_called() {
        let option = BooleanError::Option { option: "max_points", value: 2.0, rule: "at least 3" };
        let error = Error::from(option.within("union"));
        assert_eq!(error.to_string(), "union: max_points is 2, but it must be at least 3");
        let cancelled = Error::from(BooleanError::Cancelled.within("offset"));
        assert_eq!(cancelled.to_string(), "offset: the operation was cancelled");
        let text = "A*B".to_owned();
        let error = Error::from(BooleanError::UnknownOperation { text }.within("boolean"));
        assert!(error.to_string().starts_with("boolean: operation is \"A*B\", but it must be one of or, A+B"));
    }
}
