//! The options of the writer.

use std::ops::RangeInclusive;

use phidl_core::num::grid::Grid;

use super::real::is_representable;
use super::record::MOST_TEXT;
use crate::error::{IoError, Result, real};
use crate::model::{Date, FileLimits, MergeCells, Naming, Rules, check_name};
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
    /// The unit in which other programs show lengths (µm); 1 µm by default. Coordinates do not depend on it.
    pub user_unit: f64,
    /// The step to which every coordinate is rounded (µm); 1 nm by default.
    pub grid: f64,
    /// The date that the file carries: fixed, so that the same source gives the same bytes.
    pub date: Date,
    /// The longest cell name that the writer makes up, from 12 to 1024 characters; 32 by default, which every reader takes.
    /// Names that a file can have are kept up to [`FileLimits::cell_name`].
    pub max_cellname_length: usize,
    /// The name of the top cell; the device's own name unless given. Several top cells keep their names.
    pub top_name: Option<String>,
    /// The name of the library, as the file states it.
    pub library_name: String,
    /// The most corners of an outline, from 16 to 8190 (what a record holds); outlines with more are cut. 4094 by default:
    /// longer records make KLayout warn, as the manual has their length as a signed number.
    pub max_points: usize,
    /// How large texts and numbers may be.
    pub limits: FileLimits,
    /// How joints are welded.
    pub weld: WeldOptions,
    /// Which devices are one cell of the file.
    pub merge_cells: MergeCells,
    /// Whether arrays whose lattice is not rectangular in the frame of their cell are arrays in the file; true by default.
    /// gdspy, and with it PHIDL, reads every lattice as rectangular: for them, such arrays are single references.
    pub skew_arrays: bool,
    /// Whether a file may have no polygon and no label at all. False by default: an empty mask is an error.
    pub allow_empty: bool,
}

impl Default for GdsOptions {
    fn default() -> Self {
        Self {
            user_unit: 1.0,
            grid: 1e-3,
            date: Date::default(),
            max_cellname_length: 32,
            top_name: None,
            library_name: "phidl".to_owned(),
            max_points: 4094,
            limits: FileLimits::READERS,
            weld: WeldOptions::default(),
            merge_cells: MergeCells::default(),
            skew_arrays: true,
            allow_empty: false,
        }
    }
}

/// What a record of 65,534 bytes holds, the repeated first point aside.
pub(super) const MOST_POINTS: usize = 8190;

impl GdsOptions {
    /// Refuses what no file can have, and returns the grid.
    pub(crate) fn check(&self) -> Result<Grid> {
        let grid = Grid::new(self.grid)
            .ok()
            .filter(|grid| is_representable(grid.step()) && is_representable(grid.step() * 1e-6))
            .ok_or_else(|| IoError::option("grid", format!("{} µm", real(self.grid)), "be a positive length"))?;
        if !(self.user_unit > 0.0 && is_representable(self.user_unit) && is_representable(self.grid / self.user_unit)) {
            return Err(IoError::option("user_unit", format!("{} µm", real(self.user_unit)), "be a positive length"));
        }
        if !self.date.is_valid() {
            return Err(IoError::option("date", self.date, "be a day of the calendar and a time of day"));
        }
        between("max_cellname_length", self.max_cellname_length, 12..=1024)?;
        between("max_points", self.max_points, 16..=MOST_POINTS)?;
        between("limits.text", self.limits.text, 0..=MOST_TEXT)?;
        between("limits.property", self.limits.property, 0..=MOST_TEXT)?;
        between("limits.cell_name", self.limits.cell_name, 12..=MOST_TEXT)?;
        check_name("library_name", &self.library_name, &self.limits)?;
        if let Some(top) = &self.top_name {
            check_name("top_name", top, &self.limits)?;
        }
        Ok(grid)
    }

    /// How cells are chosen and named.
    pub(crate) fn naming(&self) -> Naming<'_> {
        Naming {
            top_name: self.top_name.as_deref(),
            max_cellname_length: self.max_cellname_length,
            limits: &self.limits,
            merge: self.merge_cells,
        }
    }

    /// The rules for elements.
    pub(super) fn rules(&self, grid: Grid) -> Rules<'_> {
        Rules {
            grid,
            limits: &self.limits,
            max_points: self.max_points,
            skew_arrays: self.skew_arrays,
            is_representable,
        }
    }
}

/// The two numbers of the UNITS record: the grid in user units, and in meters.
pub(super) fn units(grid: &Grid, user_unit: f64) -> (f64, f64) {
    // Divided once by the whole number of steps, where there is one: that gives the double next to a nanometer.
    let per_um = 1.0 / grid.um(1);
    (1.0 / (per_um * user_unit), 1.0 / (per_um * 1e6))
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
        assert_eq!(units(&grid, options.user_unit), (1e-3, 1e-9));
        let options = GdsOptions { grid: 5e-3, user_unit: 1e-3, ..GdsOptions::default() };
        assert_eq!(units(&options.check().unwrap(), options.user_unit), (5.0, 5e-9));
    }

    #[test]
    fn options_that_no_file_can_have_are_refused_by_name() {
        let good = GdsOptions::default;
        let bad = [
            ("grid", GdsOptions { grid: 0.0, ..good() }),
            ("grid", GdsOptions { grid: 1e-75, ..good() }),
            ("user_unit", GdsOptions { user_unit: f64::NAN, ..good() }),
            ("date", GdsOptions { date: Date::new(2000, 13, 1), ..good() }),
            ("max_cellname_length", GdsOptions { max_cellname_length: 3, ..good() }),
            ("max_points", GdsOptions { max_points: 8191, ..good() }),
            ("top_name", GdsOptions { top_name: Some("a\tb".into()), ..good() }),
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
