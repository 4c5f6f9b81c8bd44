//! Cells beside gdstk: building, flattening, measuring.

use phidl_core::place::Bounded as _;
use testkit::loads;

use super::table::Section;
use super::{Sitting, clock};

const NOTES: &str = "Ours flattens on all cores. The box is that of new cells, of which nothing is remembered; gdstk \
    remembers nothing.";

/// Times a million rectangles, a flatten and a box.
pub(super) fn measure(sitting: &Sitting<'_>) -> anyhow::Result<Section> {
    let times = sitting.peers("scene", sitting.folder)?;
    let mut section = Section::new("Cells", NOTES, &["gdstk"]);
    let rectangles = clock::best(loads::rectangles);
    section.add("build a million rectangles, each added on its own", rectangles, &times, "rectangles");
    let array = loads::turned_array();
    let flatten = clock::best(|| array.flattened().expect("within the limit"));
    section.add("flatten 1000 × 1000 cells of 10 polygons, turned by 30°", flatten, &times, "flatten");
    let first = clock::best_of_fresh(loads::turned_hierarchy, |top| top.bbox());
    section.add("box of 6 levels, a million turned instances, first time", first, &times, "box");
    let top = loads::turned_hierarchy();
    section.add("the same again, remembered", clock::best(|| top.bbox()), &times, "box");
    Ok(section)
}
