//! [`Unit`]: the unit of a parameter, and numbers with it.
//!
//! Which units there are is decided by `#[param(unit = …)]`, which hands both texts over: there is no table here.

/// The unit of a parameter: its name in `#[param(unit = …)]` and its sign in errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unit {
    name: &'static str,
    sign: &'static str,
}

impl Unit {
    /// No unit: a pure number.
    pub const NONE: Self = Self { name: "", sign: "" };

    #[doc(hidden)]
    #[must_use]
    pub const fn new(name: &'static str, sign: &'static str) -> Self {
        Self { name, sign }
    }

    /// `um`, as in `#[param(unit = "um")]`; empty if there is none.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.name
    }

    /// `µm`, as texts show it; empty if there is none.
    #[must_use]
    pub fn sign(self) -> &'static str {
        self.sign
    }
}

/// A number with the sign of its unit, as an error shows it: `0.2 µm`, `90°`.
pub(crate) struct Quantity<'a>(pub(crate) f64, pub(crate) &'a str);

impl std::fmt::Display for Quantity<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match *self {
            Self(number, "") => Readable(number).fmt(f),
            Self(number, sign @ "°") => write!(f, "{}{sign}", Readable(number)),
            Self(number, sign) => write!(f, "{} {sign}", Readable(number)),
        }
    }
}

/// A float as people write it: with an exponent where it would have many zeros. `{:?}` has an exponent only from 1e16 on
/// and `Display` never.
pub(crate) struct Readable(pub(crate) f64);

impl std::fmt::Display for Readable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let v = self.0;
        if v != 0.0 && v.is_finite() && !(1e-6..1e15).contains(&v.abs()) { write!(f, "{v:e}") } else { v.fmt(f) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_people_write_them() {
        let text = |number, sign| Quantity(number, sign).to_string();
        assert_eq!(text(0.2, "µm"), "0.2 µm");
        assert_eq!(text(-90.0, "°"), "-90°");
        assert_eq!(text(1e300, ""), "1e300");
        assert_eq!(text(-1e-300, "µm"), "-1e-300 µm");
        assert_eq!(text(1_000_000.5, ""), "1000000.5");
        assert_eq!(text(f64::NAN, "µm"), "NaN µm");
    }
}
