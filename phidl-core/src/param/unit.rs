//! Units as they stand in `#[param(unit = …)]` and as they are shown.

/// A number with its unit, as an error shows it: `0.2 µm`, `90°`.
pub(crate) struct Quantity<'a>(pub(crate) f64, pub(crate) &'a str);

impl std::fmt::Display for Quantity<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self(number, unit) = self;
        match *unit {
            "" => number.fmt(f),
            "deg" => write!(f, "{number}°"),
            "um" => write!(f, "{number} µm"),
            "um2" => write!(f, "{number} µm²"),
            "1/um" => write!(f, "{number} /µm"),
            "ohm" => write!(f, "{number} Ω"),
            "ohm/sq" => write!(f, "{number} Ω/sq"),
            other => write!(f, "{number} {other}"),
        }
    }
}
