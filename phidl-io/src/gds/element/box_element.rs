//! BOX: rectangles that the manual keeps for regions which are not drawn. Every reader draws them.

use super::boundary::{closed, encloses};
use super::fields::{Defect, Fields, put_layer, put_properties};
use crate::gds::record::{kind, put_mark, put_xy};
use crate::model::BoxElement;

/// The box of an element; `None` if it encloses nothing. Two corners, or corners on one line that is not level or
/// upright, are the diagonal of the box.
pub(in crate::gds) fn read(fields: &mut Fields<'_>) -> Result<Option<BoxElement>, Defect> {
    fields.check()?;
    let layer = fields.layer()?;
    let mut corners: Vec<_> = fields.outline()?.collect();
    if !encloses(corners.iter().copied()) {
        let range = |axis: usize| {
            corners.iter().map(move |c| c[axis]).fold((i32::MAX, i32::MIN), |(a, b), v| (a.min(v), b.max(v)))
        };
        let ((left, right), (bottom, top)) = (range(0), range(1));
        if left >= right || bottom >= top {
            return Ok(None);
        }
        corners = vec![[left, bottom], [right, bottom], [right, top], [left, top]];
    }
    Ok(Some(BoxElement { layer, corners, properties: fields.properties(), offset: fields.offset }))
}

/// Appends the records of a box.
pub(in crate::gds) fn write(element: &BoxElement, bytes: &mut Vec<u8>) {
    put_mark(kind::BOX, bytes);
    put_layer(element.layer, kind::BOXTYPE, bytes);
    put_xy(closed(&element.corners), bytes);
    put_properties(&element.properties, bytes);
    put_mark(kind::ENDEL, bytes);
}
