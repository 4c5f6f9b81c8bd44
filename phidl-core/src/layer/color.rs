//! [`Color`]: the fill of a layer in pictures.

use std::str::FromStr;

use crate::error::{Error, Result};

/// A color of eight bits per channel.
///
/// ```
/// # use phidl_core::layer::Color;
/// assert_eq!("Gold".parse::<Color>()?.to_string(), "#ffd700");
/// assert_eq!(Color::from_fractions(0.4, 0.5, 0.7)?.to_string(), "#6680b2");
/// # Ok::<(), phidl_core::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Color {
    /// Red, 0 to 255.
    pub red: u8,
    /// Green, 0 to 255.
    pub green: u8,
    /// Blue, 0 to 255.
    pub blue: u8,
}

impl Color {
    /// A color from three channels between 0 and 1, rounded to eight bits (halves to even).
    ///
    /// # Errors
    /// [`Error::Invalid`] if a channel is outside 0 to 1.
    pub fn from_fractions(red: f64, green: f64, blue: f64) -> Result<Self> {
        let channel = |v: f64| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255 by the check")]
            let byte = (255.0 * v).round_ties_even() as u8;
            (0.0..=1.0).contains(&v).then_some(byte)
        };
        match (channel(red), channel(green), channel(blue)) {
            (Some(red), Some(green), Some(blue)) => Ok(Self { red, green, blue }),
            _ => Err(invalid(&format!("({red}, {green}, {blue})"), "have channels from 0 to 1")),
        }
    }
}

impl FromStr for Color {
    type Err = Error;

    /// Reads `#rrggbb` or a CSS color name, in any case of letters.
    fn from_str(text: &str) -> Result<Self> {
        let rule = "be #rrggbb or a CSS color name";
        let is_hex = text.len() == 7 && text.starts_with('#');
        let is_name = text.chars().all(|c| c.is_ascii_alphabetic()) && !text.eq_ignore_ascii_case("transparent");
        if !(is_hex || is_name) {
            return Err(invalid(text, rule));
        }
        let [red, green, blue, _] = csscolorparser::parse(text).map_err(|_| invalid(text, rule))?.to_rgba8();
        Ok(Self { red, green, blue })
    }
}

impl std::fmt::Display for Color {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.red, self.green, self.blue)
    }
}

fn invalid(value: &str, rule: &str) -> Error {
    Error::invalid("layer", format!("the color is {value}, but it must {rule}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_hex_and_fractions_are_colors() {
        for (text, hex) in [("goldenrod", "#daa520"), ("TAN", "#d2b48c"), ("#6680B2", "#6680b2")] {
            assert_eq!(text.parse::<Color>().unwrap().to_string(), hex);
        }
        assert_eq!(Color::from_fractions(0.5, 0.1, 0.9).unwrap().to_string(), "#801ae6");
        assert_eq!(Color::from_fractions(0.5, 0.5, 0.5).unwrap().to_string(), "#808080");
    }

    #[test]
    fn anything_else_is_refused() {
        for text in ["#abc", "#12345g", "golden", "", "rgb(1,2,3)", "transparent", "#éa123"] {
            assert!(text.parse::<Color>().is_err(), "{text}");
        }
        assert!(Color::from_fractions(1.1, 0.0, 0.0).is_err());
        assert!(Color::from_fractions(f64::NAN, 0.0, 0.0).is_err());
    }
}
