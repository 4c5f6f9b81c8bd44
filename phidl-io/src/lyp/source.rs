//! [`Source`]: which layers of a file a line of the list shows.

use phidl_core::layer::Layer;

/// Which layers are shown: `1/0@1`, `NAME`, `NAME (1/0)`, `*/*@*`, and what else KLayout allows behind it. The text is
/// kept as it is.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct Source(pub String);

/// What a [`Source`] says of the layer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SourceLayer {
    /// Layer and datatype; `None` stands for any.
    Numbers(Option<u16>, Option<u16>),
    /// A layer that has only a name.
    Name(String),
    /// A layer of another file than the first one, or of several.
    OtherFile,
    /// Nothing: a group, or a source that cannot be read.
    None,
}

impl Source {
    /// The source that shows one layer of the first file.
    #[must_use]
    pub fn of(layer: Layer) -> Self {
        Self(format!("{layer}@1"))
    }

    /// What the source says of the layer. Transformations, property filters and levels are not looked at.
    #[must_use]
    pub fn layer(&self) -> SourceLayer {
        let text = self.0.trim();
        if text.is_empty() {
            return SourceLayer::None;
        }
        let (head, file) = match text.split_once('@') {
            Some((head, rest)) => {
                let end = rest.find(|c: char| !(c.is_ascii_digit() || c == '*')).unwrap_or(rest.len());
                (head.trim(), &rest[..end])
            }
            None => (end_of_layer(text), "1"),
        };
        if !matches!(file, "1" | "") {
            return SourceLayer::OtherFile;
        }
        // `NAME (1/0)` has its numbers in parentheses.
        let inside = head.strip_suffix(')').and_then(|head| head.rsplit_once('(')).map(|(_, inside)| inside);
        if let Some(numbers) = inside.and_then(numbers).or_else(|| numbers(head)) {
            return SourceLayer::Numbers(numbers.0, numbers.1);
        }
        if head.is_empty() { SourceLayer::None } else { SourceLayer::Name(head.to_owned()) }
    }
}

impl std::fmt::Display for Source {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// The text up to a transformation, a property filter or levels.
fn end_of_layer(text: &str) -> &str {
    let end = text.find(['[', '#']).unwrap_or(text.len());
    let head = text[..end].trim();
    let Some((before, inside)) = head.strip_suffix(')').and_then(|head| head.rsplit_once('(')) else { return head };
    if numbers(inside).is_some() { head } else { before.trim() }
}

/// `1/0`, `1/*`, `*/*`.
fn numbers(text: &str) -> Option<(Option<u16>, Option<u16>)> {
    let (layer, datatype) = text.trim().split_once('/')?;
    let number = |text: &str| match text.trim() {
        "*" => Some(None),
        digits if digits.bytes().all(|byte| byte.is_ascii_digit()) => digits.parse().ok().map(Some),
        _ => None,
    };
    Some((number(layer)?, number(datatype)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_say_numbers_names_or_neither() {
        let layer = |text: &str| Source(text.to_owned()).layer();
        let numbers = |l, d| SourceLayer::Numbers(l, d);
        for text in ["3/5", "3/5@1", " 3/5 @1", "metal (3/5)", "metal (3/5)@1", "3/5@1 (r90 *2)", "3/5 [a==1] #0..2"] {
            assert_eq!(layer(text), numbers(Some(3), Some(5)), "{text}");
        }
        assert_eq!(layer("*/*@1"), numbers(None, None));
        assert_eq!(layer("7/*"), numbers(Some(7), None));
        assert_eq!([layer("*/*@*"), layer("1/0@2")], [SourceLayer::OtherFile, SourceLayer::OtherFile]);
        assert_eq!(layer("metal@1"), SourceLayer::Name("metal".to_owned()));
        assert_eq!(layer("metal (r90)"), SourceLayer::Name("metal".to_owned()));
        assert_eq!(layer("70000/0"), SourceLayer::Name("70000/0".to_owned()));
        assert_eq!([layer(""), layer("  "), layer("@1")], [SourceLayer::None, SourceLayer::None, SourceLayer::None]);
    }
}
