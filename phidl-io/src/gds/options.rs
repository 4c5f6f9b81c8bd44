//! What the writer can be told, and the limits it keeps.

use std::ops::RangeInclusive;

use phidl_core::num::grid::Grid;

use super::names;
use crate::error::{IoError, Result};
use crate::weld::WeldOptions;

/// How a GDSII file is written. All lengths are micrometers.
///
/// ```
/// # use phidl_io::gds::GdsOptions;
/// let fine = GdsOptions { grid: 1e-4, top_name: Some("mask_3".into()), ..Default::default() };
/// # assert_eq!(fine.max_points, 4094);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct GdsOptions {
    /// The unit in which other programs show lengths (µm); 1 µm unless told otherwise. It moves nothing.
    pub user_unit: f64,
    /// The step that every coordinate is rounded to (µm); 1 nm unless told otherwise.
    pub grid: f64,
    /// The date that the file carries: fixed, so that the same source gives the same bytes.
    pub date: GdsDate,
    /// The longest cell name, from 12 to 1024 characters; 32, which every reader takes.
    pub max_cellname_length: usize,
    /// The name of the top cell; the device's own name unless given.
    pub top_name: Option<String>,
    /// The name of the library, as the file states it.
    pub library_name: String,
    /// The most corners of an outline, from 16 to 8190 (what a record can hold); those with more are cut. It is 4094
    /// unless told otherwise: longer records make KLayout warn, as the manual has their length as a signed number.
    pub max_points: usize,
    /// How large texts and numbers may be.
    pub limits: GdsLimits,
    /// How joints are welded.
    pub weld: WeldOptions,
}

impl Default for GdsOptions {
    fn default() -> Self {
        Self {
            user_unit: 1.0,
            grid: 1e-3,
            date: GdsDate::default(),
            max_cellname_length: 32,
            top_name: None,
            library_name: "phidl".to_owned(),
            max_points: 4094,
            limits: GdsLimits::READERS,
            weld: WeldOptions::default(),
        }
    }
}

/// What a record of 65,534 bytes can hold, the repeated first point aside.
const MOST_POINTS: usize = 8190;

/// The longest text that fits a record.
const MOST_TEXT: usize = 65_530;

/// How large texts and numbers of a file may be. What is larger is an error, never cut off.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GdsLimits {
    /// The largest layer number, datatype and texttype.
    pub layer: u16,
    /// The longest text of a label (bytes).
    pub text: usize,
    /// The attributes that a property may have.
    pub attributes: RangeInclusive<u16>,
    /// The longest text of a property (bytes).
    pub property: usize,
}

impl GdsLimits {
    /// What today's readers (KLayout, gdstk, gdspy) take: as much as the records can hold.
    pub const READERS: Self = Self { layer: u16::MAX, text: MOST_TEXT, attributes: 0..=u16::MAX, property: MOST_TEXT };

    /// What the format's manual allows (release 6): for mask houses that insist.
    pub const MANUAL: Self = Self { layer: 255, text: 512, attributes: 1..=127, property: 126 };
}

/// A date and time of day, as a file carries it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[expect(missing_docs, reason = "the fields hold what they are called")]
pub struct GdsDate {
    pub year: i16,
    pub month: u8,
    pub day: u8,
    pub hour: u8,
    pub minute: u8,
    pub second: u8,
}

impl GdsDate {
    /// Midnight of a day.
    #[must_use]
    pub const fn new(year: i16, month: u8, day: u8) -> Self {
        Self { year, month, day, hour: 0, minute: 0, second: 0 }
    }

    fn check(&self) -> Result<()> {
        let sound = self.year >= 0
            && (1..=12).contains(&self.month)
            && (1..=31).contains(&self.day)
            && self.hour < 24
            && self.minute < 60
            && self.second < 60;
        if sound { Ok(()) } else { Err(IoError::option("date", self, "be a day of the calendar and a time of day")) }
    }
}

impl Default for GdsDate {
    /// The first day of 2000. Any constant would do; the clock would not.
    fn default() -> Self {
        Self::new(2000, 1, 1)
    }
}

impl std::fmt::Display for GdsDate {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { year, month, day, hour, minute, second } = self;
        write!(f, "{year:04}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}")
    }
}

impl GdsOptions {
    /// Refuses what no file can have, and returns the grid.
    pub(super) fn check(&self) -> Result<Grid> {
        let grid = Grid::new(self.grid)
            .ok()
            .filter(|grid| is_real(grid.step()) && is_real(grid.step() * 1e-6))
            .ok_or_else(|| IoError::option("grid", format!("{} µm", self.grid), "be a positive length"))?;
        if !(self.user_unit > 0.0 && is_real(self.user_unit) && is_real(self.grid / self.user_unit)) {
            return Err(IoError::option("user_unit", format!("{} µm", self.user_unit), "be a positive length"));
        }
        self.date.check()?;
        between("max_cellname_length", self.max_cellname_length, 12..=1024)?;
        between("max_points", self.max_points, 16..=MOST_POINTS)?;
        between("limits.text", self.limits.text, 0..=MOST_TEXT)?;
        between("limits.property", self.limits.property, 0..=MOST_TEXT)?;
        names::check("library_name", &self.library_name, MOST_TEXT)?;
        if let Some(top) = &self.top_name {
            names::check("top_name", top, self.max_cellname_length)?;
        }
        Ok(grid)
    }

    /// The two numbers of the UNITS record: the grid in user units, and in meters.
    pub(super) fn units(&self, grid: &Grid) -> (f64, f64) {
        // Divided once by the whole number of steps, where there is one: that gives the double next to a nanometer.
        let per_um = 1.0 / grid.um(1);
        (1.0 / (per_um * self.user_unit), 1.0 / (per_um * 1e6))
    }
}

/// Whether the format's real numbers reach so far (16⁻⁶⁵ to 16⁶³), with a margin.
pub(super) fn is_real(v: f64) -> bool {
    (1e-70..1e70).contains(&v)
}

fn between(option: &'static str, value: usize, range: RangeInclusive<usize>) -> Result<()> {
    if range.contains(&value) {
        return Ok(());
    }
    Err(IoError::option(option, value, format!("be from {} to {}", range.start(), range.end())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_usual_units_are_a_nanometer_in_micrometers() {
        let options = GdsOptions::default();
        let grid = options.check().unwrap();
        assert_eq!(options.units(&grid), (1e-3, 1e-9));
        let options = GdsOptions { grid: 5e-3, user_unit: 1e-3, ..GdsOptions::default() };
        assert_eq!(options.units(&options.check().unwrap()), (5.0, 5e-9));
    }

    #[test]
    fn options_that_no_file_can_have_are_refused_by_name() {
        let good = GdsOptions::default;
        let bad = [
            ("grid", GdsOptions { grid: 0.0, ..good() }),
            ("grid", GdsOptions { grid: 1e-75, ..good() }),
            ("user_unit", GdsOptions { user_unit: f64::NAN, ..good() }),
            ("date", GdsOptions { date: GdsDate::new(2000, 13, 1), ..good() }),
            ("max_cellname_length", GdsOptions { max_cellname_length: 3, ..good() }),
            ("max_points", GdsOptions { max_points: 8191, ..good() }),
            ("top_name", GdsOptions { top_name: Some("a b".into()), ..good() }),
            ("library_name", GdsOptions { library_name: String::new(), ..good() }),
        ];
        for (name, options) in bad {
            match options.check() {
                Err(IoError::Option { option, .. }) => assert_eq!(option, name),
                other => panic!("{name}: {other:?}"),
            }
        }
    }
}
