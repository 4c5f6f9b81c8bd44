//! [`ScaleBar`]: a length that one can say.

use crate::svg::number::length;

/// A bar may be too long by this part: the noise in the size of a device.
const NOISE: f64 = 1e-9;

/// A bar that tells the scale of a picture.
///
/// ```
/// # use phidl_io::svg::ScaleBar;
/// assert_eq!(ScaleBar::within(37.0), Some(ScaleBar { um: 20.0, label: "20 µm".into() }));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ScaleBar {
    /// Its length (µm): 1, 2 or 5 times a power of ten.
    pub um: f64,
    /// The length in words, in nm, µm or mm.
    pub label: String,
}

impl ScaleBar {
    /// The longest that is not longer than `most` (µm), from a picometer to 50 m. None if that is shorter, or no length.
    #[must_use]
    pub fn within(most: f64) -> Option<Self> {
        let most = most * (1.0 + NOISE);
        // Written down, since powers of ten are not exact where they are computed.
        let decades = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7];
        let lengths = decades.into_iter().flat_map(|decade| [1.0, 2.0, 5.0].map(|digit| digit * decade));
        let um = lengths.take_while(|um| *um <= most).last()?;
        Some(Self { um, label: label(um) })
    }
}

/// A length with the unit that makes its number short.
fn label(um: f64) -> String {
    match um {
        _ if um >= 1000.0 => format!("{} mm", length(um / 1000.0)),
        _ if um >= 0.1 => format!("{} µm", length(um)),
        _ => format!("{} nm", length(um * 1000.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_have_lengths_that_one_can_say() {
        for (most, label) in
            [(7.0, "5 µm"), (20.0 - 1e-12, "20 µm"), (0.11, "0.1 µm"), (0.09, "50 nm"), (1500.0, "1 mm")]
        {
            assert_eq!(ScaleBar::within(most).unwrap().label, label, "{most}");
        }
        assert_eq!(ScaleBar::within(1e-7), None);
        assert_eq!(ScaleBar::within(f64::NAN), None);
    }
}
