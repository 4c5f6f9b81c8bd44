//! Lettering beside PHIDL.

use anyhow::Context;
use phidl_core::cache;
use phidl_geometry::TextParams;
use testkit::loads;

use super::table::Section;
use super::{Sitting, clock};

const NOTES: &str = "A thousand characters in twenty lines, as one cell. The built-in font of ours is our own drawing of a \
    stencil font, that of PHIDL its own; the outline font, DejaVu Sans, is the same file for both. Ours shapes and kerns \
    the text, and flattens curves within 5 nm.";

/// Times both kinds of fonts.
pub(super) fn measure(sitting: &Sitting<'_>) -> anyhow::Result<Section> {
    let file = sitting.folder.join("DejaVuSans.ttf");
    std::fs::write(&file, dejavu::sans::regular()).with_context(|| file.display().to_string())?;
    let times = sitting.peers("text", &file)?;
    let mut section = Section::new("Text", NOTES, &["PHIDL"]);
    let file = file.to_str().context("the path of the font is text")?;
    for (kind, font) in [("built-in font", "DEPLOF"), ("outline font", file)] {
        let params = TextParams::default().text(loads::lines()).font(font);
        let draw = || cache::bypass(|| params.build());
        draw().map_err(crate::report)?;
        section.add(format!("1,000 characters, {kind}"), clock::best(draw), &times, kind);
    }
    Ok(section)
}
