//! GDSII files beside gdstk.

use phidl_io::gds::{self, GdsOptions, ReadOptions};
use testkit::loads;

use super::table::Section;
use super::{Sitting, clock};

const NOTES: &str = "Both sides read a file into cells and write cells into a file, on the same disk. Squares: a million \
    in one cell. Placements: a thousand cells, each placed a thousand times at odd angles.";

/// Times reading and writing of two files.
pub(super) fn measure(sitting: &Sitting<'_>) -> anyhow::Result<Section> {
    let options = GdsOptions::default();
    let devices = [("squares", loads::squares(1_000_000)), ("placements", loads::placements(1000, 1000))];
    let file = |name: &str| sitting.folder.join(format!("{name}.gds"));
    for (name, device) in &devices {
        gds::write(device, file(name), &options).map_err(|error| anyhow::anyhow!(error.report()))?;
    }
    let times = sitting.peers("files", sitting.folder)?;
    let mut section = Section::new("Files", NOTES, &["gdstk"]);
    for (name, device) in &devices {
        let (write, again) = (format!("{name}, write"), file("again"));
        section.add(&write, clock::best(|| gds::write(device, &again, &options)), &times, &write);
        let read = format!("{name}, read");
        section.add(&read, clock::best(|| gds::read(file(name), &ReadOptions::default())), &times, &read);
    }
    Ok(section)
}
