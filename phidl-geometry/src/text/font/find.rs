//! A font by its path or by its name.

use std::path::Path;
use std::sync::LazyLock;

use fontdb::{Database, Family, Query, Source};
use harfrust::font::Font;
use phidl_core::prelude::*;

/// The font in this file, or the one that the system knows by this name.
pub(super) fn font(check: Check<'_>, name: &str) -> Result<Font> {
    if Path::new(name).is_file() {
        return from_file(check, Path::new(name), 0, name);
    }
    from_system(check, name, &SYSTEM)
}

/// The fonts of the system, listed once.
static SYSTEM: LazyLock<Database> = LazyLock::new(|| {
    let mut system = Database::new();
    system.load_system_fonts();
    system
});

fn from_file(check: Check<'_>, path: &Path, index: u32, name: &str) -> Result<Font> {
    let bytes = std::fs::read(path).map_err(|error| refused(check, name, &format!("be readable: {error}")))?;
    from_bytes(check, bytes, index, name)
}

fn from_bytes(check: Check<'_>, bytes: Vec<u8>, index: u32, name: &str) -> Result<Font> {
    Font::new(bytes, index).ok_or_else(|| refused(check, name, "be a TrueType or OpenType font"))
}

/// A font by its PostScript name or the name of its family; of a family, the regular one.
fn from_system(check: Check<'_>, name: &str, system: &Database) -> Result<Font> {
    let by_name = system.faces().find(|face| face.post_script_name == name).map(|face| face.id);
    let id = by_name.or_else(|| system.query(&Query { families: &[Family::Name(name)], ..Query::default() }));
    let Some((source, index)) = id.and_then(|id| system.face_source(id)) else {
        let rule = format!(
            "be DEPLOF, the path of an existing font file, or the name of one of the {} fonts of the system",
            system.len()
        );
        return Err(refused(check, name, &rule));
    };
    match source {
        Source::Binary(bytes) => from_bytes(check, (*bytes).as_ref().to_vec(), index, name),
        Source::File(path) => from_file(check, &path, index, name),
    }
}

fn refused(check: Check<'_>, name: &str, rule: &str) -> Error {
    check.that("font", format_args!("{name:?}"), false, rule).expect_err("invariant: the condition is false")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A system that knows DejaVu Sans and its bold face.
    fn system() -> Database {
        let mut system = Database::new();
        system.load_font_data(dejavu::sans::bold().to_vec());
        system.load_font_data(dejavu::sans::regular().to_vec());
        system
    }

    /// The advance of H, by which the faces differ: 1540 units in the regular one, 1714 in the bold one.
    fn advance(font: &Font) -> f32 {
        let glyph = font.charmap().map_unicode('H').expect("an H");
        font.glyph_metrics().h_advance(glyph)
    }

    #[test]
    fn a_family_gives_its_regular_face_and_a_postscript_name_just_that_one() {
        assert_eq!(advance(&from_system(Check::new("text"), "DejaVu Sans", &system()).unwrap()), 1540.0);
        assert_eq!(advance(&from_system(Check::new("text"), "DejaVuSans-Bold", &system()).unwrap()), 1714.0);
    }

    #[test]
    fn what_is_not_known_is_refused_with_what_was_tried() {
        let error =
            from_system(Check::new("text"), "DejaVu", &system()).err().expect("no family of this name").to_string();
        let expected = "text: font is \"DejaVu\", but it must be DEPLOF, the path of an existing font file, \
                        or the name of one of the 2 fonts of the system";
        assert_eq!(error, expected);
        let garbage =
            from_bytes(Check::new("text"), b"not a font".to_vec(), 0, "x.ttf").err().expect("no font").to_string();
        assert!(garbage.ends_with("be a TrueType or OpenType font"));
    }
}
