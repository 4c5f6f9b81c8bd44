//! PATH: centerlines with a width.

use super::fields::{Defect, Fields, put_layer, put_properties};
use crate::gds::record::{kind, put_i32, put_mark, put_u16, put_xy};
use crate::model::{Path, PathEnd};

/// The path of an element.
pub(in crate::gds) fn read(fields: &mut Fields<'_>) -> Result<Path, Defect> {
    fields.check()?;
    let (layer, points) = (fields.layer()?, fields.corners()?.collect());
    let width = fields.width.unwrap_or(0);
    Ok(Path {
        layer,
        points,
        width: i64::from(width).abs(),
        fixed_width: width < 0,
        start: end(fields.path_type, fields.start_extension),
        end: end(fields.path_type, fields.end_extension),
        properties: fields.properties(),
        offset: fields.offset,
    })
}

/// The end of a path type. Extensions count for type 0 as well: KLayout reads them so, and no other meaning is known.
fn end(path_type: Option<i16>, extension: Option<i32>) -> PathEnd {
    match (path_type.unwrap_or(0), extension) {
        (1, _) => PathEnd::Round,
        (2, _) => PathEnd::Square,
        (_, Some(extension)) if extension != 0 => PathEnd::Extended(i64::from(extension)),
        _ => PathEnd::Flush,
    }
}

/// Appends the records of a path. Widths and extensions must fit 32 bits.
pub(in crate::gds) fn write(path: &Path, bytes: &mut Vec<u8>) {
    let length = |steps: i64| i32::try_from(steps).unwrap_or(i32::MAX);
    let path_type = match (path.start, path.end) {
        (PathEnd::Flush, PathEnd::Flush) => 0,
        (PathEnd::Round, PathEnd::Round) => 1,
        (PathEnd::Square, PathEnd::Square) => 2,
        _ => 4,
    };
    put_mark(kind::PATH, bytes);
    put_layer(path.layer, kind::DATATYPE, bytes);
    put_u16(kind::PATHTYPE, path_type, bytes);
    let width = length(path.width);
    put_i32(kind::WIDTH, if path.fixed_width { -width } else { width }, bytes);
    if path_type == 4 {
        for (kind, end) in [(kind::BGNEXTN, path.start), (kind::ENDEXTN, path.end)] {
            let extension = match end {
                PathEnd::Flush => 0,
                // One round and one square end cannot be said; the square covers the half circle.
                PathEnd::Round | PathEnd::Square => path.width / 2,
                PathEnd::Extended(by) => by,
            };
            put_i32(kind, length(extension), bytes);
        }
    }
    put_xy(path.points.iter(), bytes);
    put_properties(&path.properties, bytes);
    put_mark(kind::ENDEL, bytes);
}
