//! The table of units: the only one. The runtime gets name and sign with every parameter.

/// The name of a unit in `#[param(unit = …)]`, and its sign in errors and documentation.
const UNITS: [(&str, &str); 20] = [
    ("um", "µm"),
    ("um2", "µm²"),
    ("1/um", "µm⁻¹"),
    ("nm", "nm"),
    ("deg", "°"),
    ("turns", "turns"),
    ("Hz", "Hz"),
    ("GHz", "GHz"),
    ("ohm", "Ω"),
    ("ohm/sq", "Ω/sq"),
    ("H", "H"),
    ("H/sq", "H/sq"),
    ("pH/sq", "pH/sq"),
    ("F", "F"),
    ("A", "A"),
    ("V", "V"),
    ("K", "K"),
    ("s", "s"),
    ("m/s", "m/s"),
    ("%", "%"),
];

/// The sign of a unit, if the unit is known.
pub(crate) fn sign(name: &str) -> Option<&'static str> {
    UNITS.iter().find(|unit| unit.0 == name).map(|unit| unit.1)
}

/// The known names, for a message.
pub(crate) fn names() -> String {
    UNITS.map(|unit| unit.0).join(", ")
}
