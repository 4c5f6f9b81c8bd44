//! What welding does, and how far it goes.

use phidl_core::num::grid::Grid;

use crate::error::{IoError, Result};

/// How the writer treats joints.
///
/// ```
/// use phidl_io::weld::WeldOptions;
/// let off: WeldOptions = false.into();
/// assert_ne!(off, WeldOptions::default());
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct WeldOptions {
    /// Whether joints are welded, listed only, or not looked for.
    pub joints: Joints,
    /// What becomes of joints that are exact in their own circuit below a reference at an odd angle.
    pub beneath: Beneath,
    /// How far apart ports of one joint may be (µm): at most a tenth of a grid step, which is the default below 1e-6 µm.
    pub reach: Option<f64>,
    /// Whether a port is welded to an edge that has no port.
    pub bare: bool,
    /// Names of cells that are never varied, as black boxes of a foundry; `*` stands for any text. Cells whose info has
    /// `"rigid": true` are rigid as well.
    pub rigid: Vec<String>,
    /// Whether a joint that cannot be welded is an error.
    pub strict: bool,
    /// More forms than this are an error, which names the cell with most.
    pub most_forms: usize,
    /// Which joints the report lists; its counts are always complete.
    pub list: Listing,
}

/// Whether joints are welded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Joints {
    /// Joints are welded.
    #[default]
    Weld,
    /// Joints are found and listed; nothing is changed.
    Report,
    /// Joints are not looked for.
    Ignore,
}

/// What becomes of joints below references at odd angles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Beneath {
    /// They are written in place: exact for every reader.
    #[default]
    Bake,
    /// A circuit that is exact in itself stays one cell, and the arithmetic of the reader is relied upon.
    Trust,
}

/// Which joints a report lists.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Listing {
    /// Those with a problem.
    #[default]
    Problems,
    /// Those that are open if written without welding, and those with a problem.
    Open,
    /// All.
    All,
}

impl Default for WeldOptions {
    fn default() -> Self {
        Self {
            joints: Joints::Weld,
            beneath: Beneath::Bake,
            reach: None,
            bare: true,
            rigid: Vec::new(),
            strict: false,
            most_forms: 100_000,
            list: Listing::Problems,
        }
    }
}

impl From<bool> for WeldOptions {
    /// `true` welds, `false` leaves joints alone.
    fn from(weld: bool) -> Self {
        Self { joints: if weld { Joints::Weld } else { Joints::Ignore }, ..Self::default() }
    }
}

impl WeldOptions {
    /// How far apart corners of one joint may be (µm).
    pub(super) fn reach(&self, grid: &Grid) -> Result<f64> {
        let most = grid.step() / 10.0;
        match self.reach {
            None => Ok(most.min(1e-6)),
            Some(reach) if reach > 0.0 && reach <= most => Ok(reach),
            Some(reach) => {
                let rule = format!("be greater than 0 µm and at most a tenth of a grid step, {most} µm");
                Err(IoError::option("weld.reach", format_args!("{reach} µm"), rule))
            }
        }
    }

    /// Whether a cell of this name is rigid.
    pub(super) fn is_rigid(&self, name: &str) -> bool {
        self.rigid.iter().any(|pattern| matches(pattern, name))
    }
}

/// Whether a name matches a pattern in which `*` stands for any text.
fn matches(pattern: &str, name: &str) -> bool {
    let mut parts = pattern.split('*');
    let first = parts.next().unwrap_or_default();
    let Some(mut rest) = name.strip_prefix(first) else { return false };
    let Some(last) = parts.next_back() else { return rest.is_empty() };
    for part in parts {
        match rest.find(part) {
            Some(at) => rest = &rest[at + part.len()..],
            None => return false,
        }
    }
    rest.ends_with(last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stands_for_any_text() {
        for (pattern, name, expected) in [
            ("gc", "gc", true),
            ("gc", "gc2", false),
            ("gc*", "gc2", true),
            ("*pad", "bond_pad", true),
            ("a*b*c", "a1b2c", true),
            ("a*b*c", "a1c", false),
            ("*", "", true),
            ("ab*ba", "aba", false),
        ] {
            assert_eq!(matches(pattern, name), expected, "{pattern} {name}");
        }
    }

    #[test]
    fn the_reach_is_at_most_a_tenth_of_a_step() {
        let grid = Grid::new(1e-3).unwrap();
        assert_eq!(WeldOptions::default().reach(&grid).unwrap(), 1e-6);
        let fine = Grid::new(1e-6).unwrap();
        assert!((WeldOptions::default().reach(&fine).unwrap() - 1e-7).abs() < 1e-20);
        let wide = WeldOptions { reach: Some(2e-4), ..Default::default() };
        let error = wide.reach(&grid).unwrap_err().to_string();
        assert!(error.contains("weld.reach is 0.0002 µm"), "{error}");
    }
}
