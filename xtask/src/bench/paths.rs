//! Paths beside PHIDL and gdstk.

use phidl_core::Result;
use phidl_path::{CrossSection, EulerBend, Extrusion, Overlaps, Path, Section as Strip};
use testkit::loads;

use super::table::Section;
use super::{Sitting, clock};

const NOTES: &str = "Extrusion: 10,000 points over three strips side by side, from a list of points to a finished cell \
    with two ports (ours, PHIDL) or to polygons (gdstk; FlexPath miters). Bends: a thousand Euler bends of 90° with 720 \
    points per turn as center lines, then extruded; gdstk has no Euler bends, so it draws the same number of circular \
    ones from a path of one point to polygons, with the tolerance that gives as many points. Within 1 nm: the same with a tolerance on the \
    center line for ours, on the edges for gdstk. Corners: `smooth` with Euler bends.";

/// Times extrusions and bends.
pub(super) fn measure(sitting: &Sitting<'_>) -> anyhow::Result<Section> {
    let times = sitting.peers("paths", sitting.folder)?;
    let mut section = Section::new("Paths", NOTES, &["PHIDL", "FlexPath", "RobustPath"]);
    let (points, strips) = (loads::winding(), three_strips());
    let extrude = || Path::from_points(&points)?.extrude(&strips);
    section.add("extrude 10,000 points over 3 sections", clock::best(extrude), &times, "extrude");
    extrude().map_err(crate::report)?; // an overlap would end it early
    let x =
        || Path::from_points(&points).and_then(|path| Extrusion::new(&path, &strips).overlaps(Overlaps::Keep).build());
    section.add("the same without the check for overlaps", clock::best(x), &times, "extrude");
    let bend = EulerBend::new();
    let (bends, extruded) = (|| drawn(bend, Ok), || drawn(bend, |path| path.extrude_width(0.5, 1)));
    section.add("1,000 Euler bends", clock::best(bends), &times, "bends");
    section.add("the same, extruded", clock::best(extruded), &times, "bends, extruded");
    // Points that are not kept need not be drawn.
    let few = bend.num_pts(1);
    let within = || drawn(few, |path| path.with_tolerance(1e-3));
    section.add("1,000 Euler bends within 1 nm", clock::best(within), &times, "");
    let within = || drawn(few, |path| path.with_tolerance(1e-3)?.extrude_width(0.5, 1));
    section.add("the same, extruded", clock::best(within), &times, "bends within 1 nm, extruded");
    let corners = loads::corners();
    let smooth = || Path::smooth(&corners, 5, EulerBend::new());
    section.add("smooth 1,000 corners", clock::best(smooth), &times, "smooth");
    Ok(section)
}

fn three_strips() -> CrossSection {
    CrossSection::new()
        .add(Strip::new(0.5).layer(1).ports("in", "out"))
        .add(Strip::new(1.0).offset(2).layer(2))
        .add(Strip::new(1.0).offset(-2).layer(3))
}

/// Each of the bends, and what is made of it.
fn drawn<T>(bend: EulerBend, finish: impl Fn(Path) -> Result<T>) -> Result<Vec<T>> {
    loads::radii().into_iter().map(|radius| finish(bend.path(radius, 90)?)).collect()
}
