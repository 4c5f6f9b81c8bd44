//! Colors, fill patterns and line styles as the files spell them.

use phidl_core::layer::Color;

/// A fill pattern.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Pattern {
    /// One of KLayout's own, `I0` (solid) to `I46`.
    BuiltIn(u32),
    /// One of the file, by its position: `C0`, `C1`, …
    Custom(u32),
}

/// A line style.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LineStyle {
    /// One of KLayout's own, `I0` (solid) to `I7`.
    BuiltIn(u32),
    /// One of the file, by its position: `C0`, `C1`, …
    Custom(u32),
}

/// The number of KLayout's own fill patterns.
const BUILT_IN_PATTERNS: u32 = 47;
/// The number of KLayout's own line styles.
const BUILT_IN_LINES: u32 = 8;
/// In files without letters, numbers from here on are patterns of the file.
const FIRST_OLD_CUSTOM: u32 = 16;

impl Pattern {
    /// Reads `I5`, `C0`, or a number as in old files.
    pub(super) fn parse(text: &str) -> Option<Self> {
        match letter(text)? {
            (Some('C'), number) => Some(Self::Custom(number)),
            (Some(_), number) if number < BUILT_IN_PATTERNS => Some(Self::BuiltIn(number)),
            (None, number) if number < FIRST_OLD_CUSTOM => Some(Self::BuiltIn(number)),
            (None, number) => Some(Self::Custom(number - FIRST_OLD_CUSTOM)),
            _ => None,
        }
    }
}

impl std::fmt::Display for Pattern {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::BuiltIn(number) => write!(f, "I{number}"),
            Self::Custom(number) => write!(f, "C{number}"),
        }
    }
}

impl LineStyle {
    /// Reads `I2` or `C0`.
    pub(super) fn parse(text: &str) -> Option<Self> {
        match letter(text)? {
            (Some('C'), number) => Some(Self::Custom(number)),
            (Some(_), number) if number < BUILT_IN_LINES => Some(Self::BuiltIn(number)),
            _ => None,
        }
    }
}

impl std::fmt::Display for LineStyle {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::BuiltIn(number) => write!(f, "I{number}"),
            Self::Custom(number) => write!(f, "C{number}"),
        }
    }
}

/// The letter `I` or `C`, if there is one, and the number.
fn letter(text: &str) -> Option<(Option<char>, u32)> {
    let letter = text.chars().next().filter(|c| matches!(c, 'I' | 'C'));
    let digits = if letter.is_some() { &text[1..] } else { text };
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    digits.parse().ok().map(|number| (letter, number))
}

/// Reads `#rrggbb`, `#aarrggbb` (whose opacity is dropped) or a name.
pub(super) fn color(text: &str) -> Option<Color> {
    match text.strip_prefix('#') {
        Some(digits) if digits.len() == 8 && digits.is_ascii() => format!("#{}", &digits[2..]).parse().ok(),
        _ => text.parse().ok(),
    }
}

/// A color at a brightness from −255 to 255, as KLayout shows it: halved for every 128 below 0, and the distance from
/// white halved for every 128 above.
#[must_use]
pub fn brightened(color: Color, brightness: i16) -> Color {
    let factor = 0.5_f64.powf(f64::from(brightness.unsigned_abs()) / 128.0);
    let channel = |value: u8| {
        let value = f64::from(value);
        let bright = if brightness < 0 { value * factor } else { 255.0 - (255.0 - value) * factor };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "0 to 255, since the factor is at most 1"
        )]
        let byte = bright.round() as u8;
        byte
    };
    Color { red: channel(color.red), green: channel(color.green), blue: channel(color.blue) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_and_lines_have_letters_or_old_numbers() {
        let pattern = |text| Pattern::parse(text);
        assert_eq!([pattern("I46"), pattern("C3")], [Some(Pattern::BuiltIn(46)), Some(Pattern::Custom(3))]);
        assert_eq!([pattern("15"), pattern("17")], [Some(Pattern::BuiltIn(15)), Some(Pattern::Custom(1))]);
        assert_eq!(["I47", "", "I", "C-1", "X1", "I1x", "é"].map(pattern), [None; 7]);
        assert_eq!(["I7", "I8", "3"].map(LineStyle::parse), [Some(LineStyle::BuiltIn(7)), None, None]);
    }

    #[test]
    fn colors_are_hex_with_or_without_opacity_or_names() {
        for text in ["#ffd700", "#80ffd700", "gold"] {
            assert_eq!(color(text).unwrap().to_string(), "#ffd700");
        }
        assert_eq!(["None", "#12", "#1234567é", ""].map(color), [None; 4]);
    }

    #[test]
    fn brightness_halves_the_distance_from_black_or_white() {
        let gray: Color = "#808080".parse().unwrap();
        assert_eq!(brightened(gray, -128).to_string(), "#404040");
        assert_eq!(brightened(gray, 128).to_string(), "#c0c0c0");
        assert_eq!(brightened(gray, 0), gray);
    }
}
