//! The one error of the scene graph and of generators.
//!
//! Every variant names what was refused and the rule. Errors are `Clone`, since a cache hands one failure to every
//! caller that waited for it, and compare with `==`, so tests can state them. Context is added by wrapping
//! ([`Error::Context`]), one fact per layer; `Display` prints its own layer and `source()` leads to the next.

use std::sync::Arc;

/// The result of everything in phidl that can refuse its input.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Why a cell could not be drawn, edited or found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A parameter breaks a rule of its generator.
    #[error(transparent)]
    Param(#[from] Box<ParamError>),
    /// A coordinate, angle, width or magnification is NaN or infinite.
    #[error("{device}: {what} is {value}, but it must be finite")]
    NotFinite {
        /// The cell.
        device: Box<str>,
        /// What the number is.
        what: Box<str>,
        /// The number.
        value: Box<str>,
    },
    /// A value breaks a rule of the scene graph: a negative port width, a mirror line of one point, a name without letters.
    #[error("{device}: {what} is {value}, but it must {rule}")]
    Refused {
        /// The cell.
        device: Box<str>,
        /// What the value is.
        what: Box<str>,
        /// The value.
        value: Box<str>,
        /// What it must do, as the end of "it must …".
        rule: Box<str>,
    },
    /// An outline needs three points.
    #[error("{device}: an outline of {points} points encloses nothing; at least 3 are needed")]
    TooFewPoints {
        /// The cell.
        device: Box<str>,
        /// How many points it has.
        points: usize,
    },
    /// An edge, center or size was asked of something that draws nothing.
    #[error("{device}: {word} needs something drawn, but {what} is empty")]
    EmptyGeometry {
        /// The cell.
        device: Box<str>,
        /// The placement word.
        word: &'static str,
        /// The empty thing.
        what: Box<str>,
    },
    /// A name that must be unique in its cell is taken.
    #[error("{device}: {kind} \"{name}\" exists already")]
    Duplicate {
        /// The cell.
        device: Box<str>,
        /// What has the name.
        kind: ItemKind,
        /// The name.
        name: Box<str>,
    },
    /// There is nothing of this name.
    #[error("{owner}: there is no {kind} \"{name}\"; {}", known_names(.known))]
    Unknown {
        /// Where it was looked for.
        owner: Box<str>,
        /// What was looked for.
        kind: ItemKind,
        /// The name.
        name: Box<str>,
        /// The names that are there.
        known: Vec<String>,
    },
    /// A generator needs itself with the same parameters, perhaps by way of others.
    #[error("generators wait for each other in a circle: {}", .chain.join(" → "))]
    CyclicDependency {
        /// The generators, the first one repeated at the end.
        chain: Vec<String>,
    },
    /// A rule of the user's own, from [`Error::custom`].
    #[error("{device}: {message}")]
    Custom {
        /// The cell.
        device: Box<str>,
        /// What is wrong.
        message: Box<str>,
    },
    /// Something went wrong while a cell was drawn for another one.
    #[error("in {device}")]
    Context {
        /// The outer cell.
        device: Box<str>,
        /// What went wrong.
        source: Arc<Error>,
    },
}

/// A parameter that breaks a rule; made by [`Check`](crate::param::Check) and by the bounds of `#[param]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{device}: {param} is {value}, but it must {rule}")]
pub struct ParamError {
    /// The generator.
    pub device: String,
    /// The parameter, with the place inside it (`size.width`, `line_widths[3]`) where there is one.
    pub param: String,
    /// The value that was given, with its unit.
    pub value: String,
    /// What it must do, as the end of "it must …".
    pub rule: String,
}

/// What a name belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the variants are the field's own nouns")]
pub enum ItemKind {
    Alias,
    Generator,
    Layer,
    Parameter,
    Port,
    Reference,
    Polygon,
    Label,
}

impl std::fmt::Display for ItemKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Alias => "alias",
            Self::Generator => "generator",
            Self::Layer => "layer",
            Self::Parameter => "parameter",
            Self::Port => "port",
            Self::Reference => "reference",
            Self::Polygon => "polygon",
            Self::Label => "label",
        })
    }
}

impl Error {
    /// An error for a rule of your own.
    ///
    /// ```
    /// # use phidl_core::Error;
    /// let error = Error::custom("die", "the wafer has no room for it");
    /// assert_eq!(error.to_string(), "die: the wafer has no room for it");
    /// ```
    pub fn custom(device: impl Into<Box<str>>, message: impl std::fmt::Display) -> Self {
        Self::Custom { device: device.into(), message: message.to_string().into() }
    }

    /// This error with the cell that was being drawn when it happened.
    #[must_use]
    pub fn within(self, device: impl Into<Box<str>>) -> Self {
        Self::Context { device: device.into(), source: Arc::new(self) }
    }

    /// The cell that the outermost layer names; none for a circle, which names its own.
    pub(crate) fn owner(&self) -> Option<&str> {
        match self {
            Self::Param(error) => Some(&error.device),
            Self::NotFinite { device, .. }
            | Self::Refused { device, .. }
            | Self::TooFewPoints { device, .. }
            | Self::EmptyGeometry { device, .. }
            | Self::Duplicate { device, .. }
            | Self::Custom { device, .. }
            | Self::Context { device, .. } => Some(device),
            Self::Unknown { owner, .. } => Some(owner),
            Self::CyclicDependency { .. } => None,
        }
    }

    /// The error at the end of the chain of [`Error::Context`].
    #[must_use]
    pub fn root(&self) -> &Self {
        match self {
            Self::Context { source, .. } => source.root(),
            other => other,
        }
    }

    /// The whole chain in one line: outermost cell first, the rule last.
    #[must_use]
    pub fn report(&self) -> String {
        match self {
            Self::Context { source, .. } => format!("{self}: {}", source.report()),
            other => other.to_string(),
        }
    }
}

impl From<ParamError> for Error {
    fn from(error: ParamError) -> Self {
        Self::Param(Box::new(error))
    }
}

fn known_names(known: &[String]) -> String {
    if known.is_empty() { "there are none".to_owned() } else { format!("known are {}", known.join(", ")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrapped_error_tells_the_way_from_the_outside_to_the_rule() {
        let rule = ParamError {
            device: "ring".into(),
            param: "width".into(),
            value: "-1 µm".into(),
            rule: "be greater than 0 µm".into(),
        };
        let error = Error::from(rule).within("ring_filter").within("chip");
        assert_eq!(error.report(), "in chip: in ring_filter: ring: width is -1 µm, but it must be greater than 0 µm");
        assert!(matches!(error.root(), Error::Param(p) if p.param == "width"));
    }

    #[test]
    fn errors_stay_small_enough_to_be_returned_by_every_word() {
        assert!(size_of::<Error>() <= 80, "{}", size_of::<Error>());
    }
}
