//! What can go wrong: one enum for the crate, one variant for each broken rule.

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
    /// A coordinate in micrometers has no place on the grid.
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
    #[error("operation is {text:?}, but it must be one of or, A+B, and, A&B, not, A-B, B-A, xor, A^B")]
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
    /// The operands have more edges than the engine can number.
    #[error("{edges} edges are too many for one operation; the limit is {limit}")]
    TooLarge {
        /// Number of edges.
        edges: usize,
        /// Largest allowed number.
        limit: usize,
    },
    /// The threads asked for could not be started.
    #[error("cannot start {threads} threads: {reason}")]
    Threads {
        /// Number of threads asked for.
        threads: usize,
        /// What the operating system said.
        reason: String,
    },
    /// The operation was stopped through its [`crate::Watch`].
    #[error("the operation was cancelled")]
    Cancelled,
}
