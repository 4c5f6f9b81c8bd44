//! What a text of OASIS cannot say: anchor, angle, size, reflection, font.
//!
//! It goes into a property of the text, `PHIDL_LABEL`, whose value is JSON; other tools keep the property. A text without
//! it is centered, level and of the usual size.

use std::borrow::Cow;

use phidl_core::scene::Anchor;
use serde_json::{Map, Value, json};

use crate::model::Text;

/// The name of the property.
pub(super) const NAME: &str = "PHIDL_LABEL";

/// The anchors by their names in a file.
const ANCHORS: [(&str, Anchor); 9] = [
    ("nw", Anchor::NorthWest),
    ("n", Anchor::North),
    ("ne", Anchor::NorthEast),
    ("w", Anchor::West),
    ("c", Anchor::Center),
    ("e", Anchor::East),
    ("sw", Anchor::SouthWest),
    ("s", Anchor::South),
    ("se", Anchor::SouthEast),
];

/// What the record of a text leaves out; `None` if nothing.
pub(super) fn describe(text: &Text) -> Option<String> {
    let mut said = Map::new();
    if text.anchor != Some(Anchor::Center) {
        let name = ANCHORS.iter().find(|(_, anchor)| Some(*anchor) == text.anchor).map_or("", |(name, _)| name);
        said.insert("anchor".to_owned(), json!(name));
    }
    if text.rotation != 0.0 {
        said.insert("rotation".to_owned(), json!(text.rotation));
    }
    if let Some(magnification) = text.magnification {
        said.insert("magnification".to_owned(), json!(magnification));
    }
    if text.x_reflection {
        said.insert("x_reflection".to_owned(), json!(true));
    }
    if text.font != 0 {
        said.insert("font".to_owned(), json!(text.font));
    }
    if let Some(path_type) = text.path_type {
        said.insert("path_type".to_owned(), json!(path_type));
    }
    if let Some(width) = text.width {
        said.insert("width".to_owned(), json!(width));
    }
    if shown(text) != text.string {
        said.insert("text".to_owned(), json!(text.string));
    }
    (!said.is_empty()).then(|| ascii(&Value::Object(said).to_string()))
}

/// What other tools see of a text: its first line, without control characters. Letters beyond ASCII are UTF-8, which the
/// standard does not allow and KLayout and gdstk read and write.
pub(super) fn shown(text: &Text) -> Cow<'_, str> {
    let line = text.string.split('\n').next().unwrap_or_default();
    if line.chars().any(char::is_control) {
        return line.chars().map(|c| if c.is_control() { ' ' } else { c }).collect::<String>().into();
    }
    line.into()
}

/// Whether a string is one that the format allows for texts.
pub(super) fn is_ascii(text: &str) -> bool {
    text.bytes().all(|byte| (0x20..0x7f).contains(&byte))
}

/// The same JSON without letters beyond ASCII.
fn ascii(json: &str) -> String {
    let mut out = String::with_capacity(json.len());
    for c in json.chars() {
        if c.is_ascii() {
            out.push(c);
        } else {
            for unit in c.encode_utf16(&mut [0; 2]) {
                out.push_str(&format!("\\u{unit:04x}"));
            }
        }
    }
    out
}

/// Gives texts back what their property says. Returns whether it was understood.
pub(super) fn apply(payload: &str, texts: &mut [Text]) -> bool {
    let Ok(Value::Object(said)) = serde_json::from_str(payload) else { return false };
    texts.iter_mut().all(|text| said.iter().all(|(key, value)| set(text, key, value).is_some()))
}

fn set(text: &mut Text, key: &str, value: &Value) -> Option<()> {
    match key {
        "anchor" => {
            let name = value.as_str()?;
            text.anchor = ANCHORS.iter().find(|(known, _)| *known == name).map(|(_, anchor)| *anchor);
            (name.is_empty() || text.anchor.is_some()).then_some(())?;
        }
        "rotation" => text.rotation = value.as_f64()?,
        "magnification" => text.magnification = Some(value.as_f64().filter(|m| *m > 0.0)?),
        "x_reflection" => text.x_reflection = value.as_bool()?,
        "font" => text.font = value.as_u64().and_then(|font| u8::try_from(font).ok()).filter(|font| *font < 4)?,
        "path_type" => text.path_type = Some(i16::try_from(value.as_i64()?).ok()?),
        "width" => text.width = Some(i32::try_from(value.as_i64()?).ok()?),
        "text" => text.string = value.as_str()?.to_owned(),
        _ => return None,
    }
    Some(())
}
