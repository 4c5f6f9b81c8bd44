//! [`FileLimits`]: the sizes of texts and numbers that a file may have.

use std::ops::RangeInclusive;

use phidl_core::layer::Layer;
use phidl_core::scene::Properties;

use crate::error::Item;

/// The longest text that a GDSII record holds (bytes).
const MOST_TEXT: usize = 65_530;

/// How large texts and numbers of a file may be. What is larger is an error, never cut off.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileLimits {
    /// The largest layer number, datatype and texttype.
    pub layer: u16,
    /// The longest text of a label (bytes).
    pub text: usize,
    /// The attributes that a property may have.
    pub attributes: RangeInclusive<u16>,
    /// The longest text of a property (bytes).
    pub property: usize,
    /// The longest name of a cell (bytes).
    pub cell_name: usize,
    /// Whether texts are printable ASCII characters and line ends, and cell names letters, digits, `_`, `?` and `$`.
    /// Otherwise texts are UTF-8, and cell names any printable ASCII characters.
    pub strict_characters: bool,
}

/// A value that a file cannot have: what it is, the value, and the rule as the end of "it must …".
pub(crate) struct Refusal {
    pub(crate) what: &'static str,
    pub(crate) value: String,
    pub(crate) rule: String,
}

impl FileLimits {
    /// What today's readers (KLayout, gdstk) take: as much as the records hold.
    pub const READERS: Self = Self {
        layer: u16::MAX,
        text: MOST_TEXT,
        attributes: 0..=u16::MAX,
        property: MOST_TEXT,
        cell_name: 1024,
        strict_characters: false,
    };

    /// What the manual of GDSII allows (release 6), for mask houses that insist.
    pub const MANUAL: Self =
        Self { layer: 255, text: 512, attributes: 1..=127, property: 126, cell_name: 32, strict_characters: true };

    /// Whether a file may have a cell of this name.
    pub(crate) fn is_legal(&self, name: &str) -> bool {
        (1..=self.cell_name).contains(&name.len()) && name.chars().all(|c| self.is_name_character(c))
    }

    /// The name with `_` for each character that the file may not have. Its length is not changed.
    pub(crate) fn legal(&self, name: &str) -> String {
        let legal: String = name.chars().map(|c| if self.is_name_character(c) { c } else { '_' }).collect();
        if legal.is_empty() { "_".to_owned() } else { legal }
    }

    /// The characters of cell names, for errors.
    pub(crate) fn characters(&self) -> &'static str {
        if self.strict_characters {
            "of the characters A–Z, a–z, 0–9, _, ? and $"
        } else {
            "printable ASCII characters"
        }
    }

    fn is_name_character(&self, c: char) -> bool {
        match self.strict_characters {
            true => c.is_ascii_alphanumeric() || matches!(c, '_' | '?' | '$'),
            false => (' '..='~').contains(&c),
        }
    }

    /// Refuses layers above the limit.
    pub(crate) fn check_layer(&self, layer: Layer) -> Result<(), Refusal> {
        if layer.number.max(layer.datatype) <= self.layer {
            return Ok(());
        }
        let rule = format!("have numbers of at most {}", self.layer);
        Err(Refusal { what: "layer", value: layer.to_string(), rule })
    }

    /// Refuses the text of a label.
    pub(crate) fn check_text(&self, text: &str) -> Result<(), Refusal> {
        self.writable("text", text, self.text)
    }

    /// Refuses properties.
    pub(crate) fn check_properties(&self, properties: &Properties) -> Result<(), Refusal> {
        for (attribute, text) in properties {
            if !self.attributes.contains(attribute) {
                let (first, last) = (self.attributes.start(), self.attributes.end());
                let rule = format!("be from {first} to {last}");
                return Err(Refusal { what: "property attribute", value: attribute.to_string(), rule });
            }
            self.writable("property", text, self.property)?;
        }
        Ok(())
    }

    /// Texts are UTF-8, as KLayout and gdstk read them. A text that is too long so may fit a byte for each character
    /// (Latin-1): it came from a file of that kind. Zeros at the end are padding for every reader, so they are refused.
    fn writable(&self, what: &'static str, text: &str, most: usize) -> Result<(), Refusal> {
        let latin1 = !self.strict_characters && text.chars().all(|c| u32::from(c) <= 0xff);
        let length = if latin1 && text.len() > most { text.chars().count() } else { text.len() };
        if length > most {
            return Err(Refusal {
                what,
                value: format!("{length} bytes long"),
                rule: format!("have at most {most} bytes"),
            });
        }
        let foreign = |c: &char| !c.is_ascii() || (c.is_ascii_control() && *c != '\n');
        if let Some(c) = text.chars().find(|c| self.strict_characters && foreign(c)) {
            let rule = format!("be of printable ASCII characters, without {c:?}");
            return Err(Refusal { what, value: format!("{text:?}"), rule });
        }
        if text.ends_with('\0') {
            let rule = "not end with a NUL character, which pads texts in files".to_owned();
            return Err(Refusal { what, value: format!("{text:?}"), rule });
        }
        Ok(())
    }
}

impl Refusal {
    /// The error for an element of a cell.
    pub(crate) fn in_element(self, cell: &str, item: Item) -> crate::error::IoError {
        let Self { what, value, rule } = self;
        crate::error::IoError::Refused {
            cell: cell.into(),
            item: Box::new(item),
            what,
            value: value.into(),
            rule: rule.into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn readers_take_what_the_manual_forbids() {
        let (manual, readers) = (FileLimits::MANUAL, FileLimits::READERS);
        let long = "x".repeat(513);
        let property = |attribute, text: &str| Properties::from([(attribute, text.to_owned())]);
        assert!(manual.check_layer(Layer::new(256, 0)).is_err());
        assert!(manual.check_text(&long).is_err());
        assert!(manual.check_properties(&property(128, "x")).is_err());
        assert!(manual.check_properties(&property(0, "x")).is_err());
        assert!(manual.check_properties(&property(1, &long[..127])).is_err());
        assert!(readers.check_layer(Layer::new(65_535, 65_535)).is_ok());
        assert!(readers.check_text(&long).is_ok());
        assert!(readers.check_properties(&property(65_535, &long)).is_ok());
    }

    #[test]
    fn the_manual_refuses_a_text_with_its_first_foreign_character() {
        let refusal = FileLimits::MANUAL.check_text("5 µm").unwrap_err();
        assert!(refusal.rule.contains("'µ'"), "{}", refusal.rule);
        assert!(FileLimits::MANUAL.check_text("a\0b").is_err());
        assert!(FileLimits::MANUAL.check_text("radius=1\nlayer=2").is_ok());
    }

    #[test]
    fn readers_take_any_characters_but_padding() {
        assert!(FileLimits::READERS.check_text("5 µm\tΩ \u{1b}[31m a\0b").is_ok());
        assert!(FileLimits::READERS.check_text("a\0").is_err());
        assert!(FileLimits::READERS.check_text(&"µ".repeat(MOST_TEXT)).is_ok());
        assert!(FileLimits::READERS.check_text(&"Ω".repeat(MOST_TEXT / 2 + 1)).is_err());
    }
}
