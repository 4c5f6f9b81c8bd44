//! [`ParamType`]: which values a parameter takes.

/// The type of a parameter in the registry.
///
/// `Display` writes it as text: `number`, `list of integer`, `one of straight, fillet`.
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
    /// One of these names.
    Choice(&'static [&'static str]),
    List(Box<ParamType>),
    /// Values by name.
    Map(Box<ParamType>),
    /// A value of the inner type or none.
    Optional(Box<ParamType>),
    /// A type of the user, described by the user.
    Other(&'static str),
}

impl ParamType {
    /// The path of a component inside a value of this type: `.width` for the first number of a size.
    pub(crate) fn component(&self, index: usize) -> String {
        match (self, index) {
            (Self::Optional(inner), _) => inner.component(index),
            (Self::Point, 0) => ".x".to_owned(),
            (Self::Point, 1) => ".y".to_owned(),
            (Self::Size, 0) => ".width".to_owned(),
            (Self::Size, 1) => ".height".to_owned(),
            _ => format!("[{index}]"),
        }
    }

    /// The type of the items of a list, a map or an option; a coordinate of a point is a number.
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
            Self::Choice(names) => return write!(f, "one of {}", names.join(", ")),
            Self::List(inner) => return write!(f, "list of {inner}"),
            Self::Map(inner) => return write!(f, "map of names to {inner}"),
            Self::Optional(inner) => return write!(f, "{inner} or none"),
            Self::Other(description) => description,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_coordinates_of_an_optional_size_have_names() {
        assert_eq!(ParamType::Optional(Box::new(ParamType::Size)).component(1), ".height");
        assert_eq!(ParamType::List(Box::new(ParamType::Size)).component(1), "[1]");
    }

    #[test]
    fn types_are_written_as_text() {
        let list = ParamType::List(Box::new(ParamType::Optional(Box::new(ParamType::Number))));
        assert_eq!(list.to_string(), "list of number or none");
        assert_eq!(ParamType::Choice(&["straight", "fillet"]).to_string(), "one of straight, fillet");
    }
}
