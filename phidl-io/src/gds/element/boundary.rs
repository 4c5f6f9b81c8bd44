//! BOUNDARY: polygons, the most frequent element of a mask.

use super::fields::{Defect, Fields, put_layer, put_properties};
use crate::gds::record::{kind, put_mark, put_xy};
use crate::model::{Corner, PolygonRef, Polygons};

/// Appends the polygon of an element. `Ok(false)`: it has fewer than three different corners and encloses nothing.
pub(in crate::gds) fn read(fields: &mut Fields<'_>, polygons: &mut Polygons) -> Result<bool, Defect> {
    fields.check()?;
    let layer = fields.layer()?;
    let outline = fields.outline()?;
    if !encloses(outline.clone()) {
        return Ok(false);
    }
    polygons.push(layer, outline);
    polygons.set_properties(fields.properties());
    Ok(true)
}

/// Whether an outline has three different corners.
pub(super) fn encloses(outline: impl IntoIterator<Item = Corner>) -> bool {
    let mut corners = outline.into_iter();
    let Some(first) = corners.next() else { return false };
    let Some(second) = corners.find(|corner| *corner != first) else { return false };
    corners.any(|corner| corner != first && corner != second)
}

/// Appends the records of a polygon. The format repeats the first corner at the end.
pub(in crate::gds) fn write(polygon: &PolygonRef<'_>, bytes: &mut Vec<u8>) {
    put_mark(kind::BOUNDARY, bytes);
    put_layer(polygon.layer, kind::DATATYPE, bytes);
    put_xy(closed(polygon.corners), bytes);
    if let Some(properties) = polygon.properties {
        put_properties(properties, bytes);
    }
    put_mark(kind::ENDEL, bytes);
}

/// The corners, and the first one again.
#[expect(clippy::range_plus_one, reason = "only the half-open range knows its length")]
pub(super) fn closed(corners: &[Corner]) -> impl ExactSizeIterator<Item = &Corner> {
    let count = corners.len();
    (0..count + 1).map(move |index| &corners[if index == count { 0 } else { index }])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_points_enclose_nothing() {
        assert!(!encloses([[1, 1], [1, 1], [1, 1]]));
        assert!(!encloses([[1, 1], [1, 2], [1, 1], [1, 2]]));
        assert!(encloses([[1, 1], [1, 2], [2, 2]]));
    }
}
