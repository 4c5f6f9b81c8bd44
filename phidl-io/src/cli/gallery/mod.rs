//! The example of every device as a figure, and all calls on one page.

mod colors;
mod page;
mod plate;

use std::path::Path;

use phidl_core::runtime::GeneratorInfo;

use super::CliError;
use crate::atomic;

pub use colors::{add_layers, figure_options};
pub use page::html;
pub use plate::{Plate, all, krate};

/// Draws the gallery of the devices that a filter accepts into a folder, and says what was written.
///
/// # Errors
/// As for [`all`], and [`CliError::Path`] if the folder cannot be made.
pub fn write(
    folder: &Path,
    is_wanted: impl Fn(&GeneratorInfo) -> bool,
    step: impl FnMut(String),
) -> Result<String, CliError> {
    let plates = all(is_wanted, step)?;
    if plates.is_empty() {
        return Err(CliError::Usage("no device is registered in this program".to_owned()));
    }
    std::fs::create_dir_all(folder).map_err(CliError::path(folder))?;
    for plate in &plates {
        atomic::write(folder.join(format!("{}.svg", plate.name)), plate.figure.as_bytes())?;
    }
    atomic::write(folder.join("index.html"), html(&plates, "cargo run --").as_bytes())?;
    Ok(format!("{} figures and index.html in {}", plates.len(), folder.display()))
}
