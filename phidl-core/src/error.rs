//! The one error of the scene graph and of generators.
//!
//! Every variant prints one sentence that names the cell and the rule. Errors are `Clone` and
//! compare with `==`, so tests can state them. Context is added by
//! wrapping ([`Error::Context`]). `Display` prints the whole chain, outermost cell first, and `Debug` prints the same:
//! `fn main() -> Result<()>` and `unwrap` show the sentence. `source()` is empty for that reason: a reporter that
//! follows sources would print the chain twice.

use std::sync::Arc;

/// The result of every fallible function of phidl's scene graph.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Why a cell could not be drawn, edited or found.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A parameter breaks a rule of its generator.
    #[error("{0}")]
    Param(Box<ParamError>),
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
    /// A value breaks a rule of the scene graph: a negative port width, a mirror line of one point, an empty name.
    #[error("{device}: {problem}")]
    Invalid {
        /// The cell.
        device: Box<str>,
        /// The value and the rule that it breaks, as one sentence.
        problem: Box<str>,
    },
    /// An outline needs three points.
    #[error("{device}: an outline has {points} point{}, but it needs at least 3", plural(*points))]
    TooFewPoints {
        /// The cell.
        device: Box<str>,
        /// How many points it has.
        points: usize,
    },
    /// An edge, center or size was asked of an empty element.
    #[error("{device}: {method} needs a bounding box, but {what} is empty")]
    EmptyGeometry {
        /// The cell.
        device: Box<str>,
        /// The placement method.
        method: &'static str,
        /// The empty element.
        what: Box<str>,
    },
    /// A name that must be unique in its cell is taken.
    #[error("{device}: {kind} \"{name}\" already exists")]
    Duplicate {
        /// The cell.
        device: Box<str>,
        /// What has the name.
        kind: ItemKind,
        /// The name.
        name: Box<str>,
    },
    /// Nothing has this name.
    #[error("{owner}: there is no {kind} \"{name}\"; {}", suggestion(.name, .known))]
    Unknown {
        /// Where it was looked for.
        owner: Box<str>,
        /// What was looked for.
        kind: ItemKind,
        /// The name.
        name: Box<str>,
        /// The names that exist.
        known: Vec<String>,
    },
    /// A key finds nothing, since its element was removed or was never added.
    #[error("{device}: the {kind} of this key is not in the cell any more")]
    Removed {
        /// The cell.
        device: Box<str>,
        /// What the key belonged to.
        kind: ItemKind,
    },
    /// A key was used on a cell that did not make it.
    #[error("{device}: this key of a {kind} belongs to another open cell, \"{owner}\"")]
    ForeignKey {
        /// The cell that was asked.
        device: Box<str>,
        /// What the key belongs to.
        kind: ItemKind,
        /// The cell that made the key.
        owner: Box<str>,
    },
    /// The flat geometry of a hierarchy is larger than a limit. It was counted before memory was taken.
    #[error("{device}: the hierarchy has {} {what}, but the limit is {limit}", counted(*.count, *.limit))]
    TooLarge {
        /// The cell.
        device: Box<str>,
        /// What was counted.
        what: &'static str,
        /// How many there are; `None` if counting stopped at the limit or at `u64::MAX`.
        count: Option<u64>,
        /// How many are accepted.
        limit: u64,
    },
    /// A generator needs itself with the same parameters, directly or through others.
    #[error("a generator needs its own cell: {}", .chain.join(" → "))]
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
    /// An error that occurred while a cell was drawn for another one.
    #[error("in {device}: {error}")]
    Context {
        /// The outer cell.
        device: Box<str>,
        /// The error inside.
        error: Arc<Error>,
    },
}

impl std::fmt::Debug for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}

/// A parameter that breaks a rule; made by [`Check`](crate::param::Check) and by the bounds of `#[param]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{device}: {param} is {value}, but it must {rule}")]
pub struct ParamError {
    /// The generator.
    pub device: String,
    /// The parameter, with the path inside it (`size.width`, `line_widths[3]`) if it has parts.
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
        Self::Context { device: device.into(), error: Arc::new(self) }
    }

    /// The cell that the outermost layer names; none for a circle, which names its own.
    pub(crate) fn owner(&self) -> Option<&str> {
        match self {
            Self::Param(error) => Some(&error.device),
            Self::NotFinite { device, .. }
            | Self::Invalid { device, .. }
            | Self::TooFewPoints { device, .. }
            | Self::EmptyGeometry { device, .. }
            | Self::Duplicate { device, .. }
            | Self::Removed { device, .. }
            | Self::ForeignKey { device, .. }
            | Self::TooLarge { device, .. }
            | Self::Custom { device, .. }
            | Self::Context { device, .. } => Some(device),
            Self::Unknown { owner, .. } => Some(owner),
            Self::CyclicDependency { .. } => None,
        }
    }

    /// The error at the end of the chain of [`Error::Context`].
    #[must_use]
    pub fn root(&self) -> &Self {
        let mut error = self;
        while let Self::Context { error: inner, .. } = error {
            error = inner;
        }
        error
    }

    /// The whole chain in one line: outermost cell first, the rule last. The same as `to_string`.
    #[must_use]
    pub fn report(&self) -> String {
        self.to_string()
    }

    pub(crate) fn invalid(device: &str, problem: impl Into<Box<str>>) -> Self {
        Self::Invalid { device: device.into(), problem: problem.into() }
    }
}

impl From<ParamError> for Error {
    fn from(error: ParamError) -> Self {
        Self::Param(Box::new(error))
    }
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}

fn counted(count: Option<u64>, limit: u64) -> String {
    count.map_or_else(|| format!("more than {limit}"), |count| count.to_string())
}

/// The names that exist, and the one that was probably meant.
fn suggestion(name: &str, known: &[String]) -> String {
    if known.is_empty() {
        return "there are none".to_owned();
    }
    let all = known.join(", ");
    match similar(name, known) {
        Some(meant) => format!("known are {all}; did you mean \"{meant}\"?"),
        None => format!("known are {all}"),
    }
}

/// The known name that differs least, if at most a third of its letters differ.
fn similar<'a>(name: &str, known: &'a [String]) -> Option<&'a str> {
    let name = name.to_lowercase();
    let distance = |other: &str| strsim::damerau_levenshtein(&name, &other.to_lowercase());
    let (distance, meant) = known.iter().map(|other| (distance(other), other.as_str())).min_by_key(|(d, _)| *d)?;
    (distance <= meant.chars().count() / 3).then_some(meant)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrapped_error_prints_its_chain_from_the_outermost_cell_to_the_rule() {
        let rule = ParamError {
            device: "ring".into(),
            param: "width".into(),
            value: "-1 µm".into(),
            rule: "be greater than 0 µm".into(),
        };
        let error = Error::from(rule).within("ring_filter").within("chip");
        let sentence = "in chip: in ring_filter: ring: width is -1 µm, but it must be greater than 0 µm";
        assert_eq!((error.to_string(), format!("{error:?}")), (sentence.to_owned(), sentence.to_owned()));
        assert!(matches!(error.root(), Error::Param(p) if p.param == "width"));
    }

    #[test]
    fn errors_stay_small_enough_to_be_returned_by_every_method() {
        assert!(size_of::<Error>() <= 80, "{}", size_of::<Error>());
    }
}
