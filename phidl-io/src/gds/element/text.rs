//! TEXT: labels.

use phidl_core::scene::Anchor;

use super::fields::{Defect, Fields, put_layer, put_properties, put_transform, text_of};
use crate::gds::record::{kind, put_bits, put_i32, put_mark, put_text, put_u16, put_xy};
use crate::model::{Problems, Text};

/// The text of an element.
pub(in crate::gds) fn read(fields: &mut Fields<'_>, cell: &str, problems: &mut Problems) -> Result<Text, Defect> {
    fields.check()?;
    let (layer, magnification) = (fields.layer()?, fields.magnification()?);
    let [origin] = fields.points(cell, problems)?;
    let string = fields.string.ok_or("it has no string")?;
    Ok(Text {
        layer,
        string: text_of(&string, cell, problems),
        origin,
        x_reflection: fields.x_reflection(),
        magnification,
        rotation: fields.rotation(),
        anchor: fields.presentation.map(anchor),
        font: fields.presentation.map_or(0, font),
        path_type: fields.path_type,
        width: fields.width,
        properties: fields.properties(),
        offset: fields.offset,
    })
}

/// Appends the records of a text.
pub(in crate::gds) fn write(text: &Text, bytes: &mut Vec<u8>) {
    put_mark(kind::TEXT, bytes);
    put_layer(text.layer, kind::TEXTTYPE, bytes);
    if let Some(presentation) = presentation_of(text) {
        put_bits(kind::PRESENTATION, presentation, bytes);
    }
    if let Some(path_type) = text.path_type {
        put_u16(kind::PATHTYPE, path_type.cast_unsigned(), bytes);
    }
    if let Some(width) = text.width {
        put_i32(kind::WIDTH, width, bytes);
    }
    put_transform(text.x_reflection, text.magnification, text.rotation, bytes);
    put_xy([text.origin].iter(), bytes);
    put_text(kind::STRING, &text.string, bytes);
    put_properties(&text.properties, bytes);
    put_mark(kind::ENDEL, bytes);
}

/// The bits of PRESENTATION: two for the font, two for top, middle, bottom, two for left, center, right.
pub(in crate::gds) fn presentation_of(text: &Text) -> Option<u16> {
    text.anchor.map(|anchor| presentation(anchor) | u16::from(text.font & 3) << 4)
}

/// Two bits of the font.
fn font(presentation: u16) -> u8 {
    u8::try_from(presentation >> 4 & 3).unwrap_or(0)
}

/// The anchors by their code: two bits for top, middle, bottom; two for left, center, right.
const ANCHORS: [(u16, Anchor); 9] = [
    (0b0000, Anchor::NorthWest),
    (0b0001, Anchor::North),
    (0b0010, Anchor::NorthEast),
    (0b0100, Anchor::West),
    (0b0101, Anchor::Center),
    (0b0110, Anchor::East),
    (0b1000, Anchor::SouthWest),
    (0b1001, Anchor::South),
    (0b1010, Anchor::SouthEast),
];

fn presentation(anchor: Anchor) -> u16 {
    ANCHORS.iter().find(|(_, known)| *known == anchor).map_or(0, |(code, _)| *code)
}

/// The anchor of a code. Codes without a meaning count as the center.
fn anchor(presentation: u16) -> Anchor {
    ANCHORS.iter().find(|(code, _)| *code == presentation & 0b1111).map_or(Anchor::Center, |(_, anchor)| *anchor)
}
