//! [`ParamType`]: what sort of value a parameter takes, in words.

/// The type of a parameter as the registry tells it.
///
/// `Display` gives it in words: `number`, `list of integer`, `one of straight, fillet`.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
#[expect(missing_docs, reason = "most variants are what they are called")]
pub enum ParamType {
    Number,
    Integer,
    Bool,
    Text,
    Character,
    /// Two numbers, x and y.
    Point,
    /// Two numbers, width and height.
    Size,
    Layer,
    Layers,
    Port,
    Device,
    /// A generator with some of its parameters: a [`Partial`](crate::runtime::Partial).
    Generator,
    /// Any [`Value`](super::Value).
    Any,
    /// One of these words.
    Choice(&'static [&'static str]),
    List(Box<ParamType>),
    /// Values by name.
    Map(Box<ParamType>),
    /// The inner kind or nothing.
    Optional(Box<ParamType>),
    /// A type of the user's own, in the user's words.
    Other(&'static str),
}

impl ParamType {
    /// How a number stands inside a value of this kind: `.width` for the first number of a size.
    pub(crate) fn place(&self, index: usize) -> String {
        match (self, index) {
            (Self::Optional(inner), _) => inner.place(index),
            (Self::Point, 0) => ".x".to_owned(),
            (Self::Point, 1) => ".y".to_owned(),
            (Self::Size, 0) => ".width".to_owned(),
            (Self::Size, 1) => ".height".to_owned(),
            _ => format!("[{index}]"),
        }
    }

    /// The kind of what stands inside a list, a map or an option; a coordinate of a point is a number.
    pub(crate) fn inner(&self) -> &Self {
        match self {
            Self::List(inner) | Self::Map(inner) => inner,
            Self::Optional(inner) => inner.inner(),
            Self::Point | Self::Size => &Self::Number,
            other => other,
        }
    }
}

impl std::fmt::Display for ParamType {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Number => "number",
            Self::Integer => "integer",
            Self::Bool => "true or false",
            Self::Text => "text",
            Self::Character => "character",
            Self::Point => "point",
            Self::Size => "size",
            Self::Layer => "layer",
            Self::Layers => "layers",
            Self::Port => "port",
            Self::Device => "device",
            Self::Generator => "generator",
            Self::Any => "any value",
            Self::Choice(words) => return write!(f, "one of {}", words.join(", ")),
            Self::List(inner) => return write!(f, "list of {inner}"),
            Self::Map(inner) => return write!(f, "map of names to {inner}"),
            Self::Optional(inner) => return write!(f, "{inner} or none"),
            Self::Other(words) => words,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_coordinates_of_an_optional_size_have_names() {
        assert_eq!(ParamType::Optional(Box::new(ParamType::Size)).place(1), ".height");
        assert_eq!(ParamType::List(Box::new(ParamType::Size)).place(1), "[1]");
    }

    #[test]
    fn kinds_are_told_in_words() {
        let list = ParamType::List(Box::new(ParamType::Optional(Box::new(ParamType::Number))));
        assert_eq!(list.to_string(), "list of number or none");
        assert_eq!(ParamType::Choice(&["straight", "fillet"]).to_string(), "one of straight, fillet");
    }
}
