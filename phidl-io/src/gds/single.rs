//! Single references to SREF records and back: masks have millions of them, so they take the short way, too.

use gds21::{GdsDataType, GdsFloat64, GdsRecordType};
use phidl_core::geom::{Point, Transform};
use phidl_core::num::{angle, grid::Grid};
use phidl_core::scene::{Array, Properties};

use super::problem::ProblemKind;
use super::record::{header, put_mark, put_property, put_real, put_text};
use super::scan::{Fault, Record, Records, kind};
use super::split::Corner;

/// A reference to a cell that is known by name so far.
pub(super) struct Placement {
    pub(super) child: String,
    pub(super) transform: Transform,
    pub(super) array: Option<Array>,
    pub(super) properties: Properties,
    /// Where it stands in the file.
    pub(super) offset: usize,
}

/// The first byte of STRANS: the reflection.
const REFLECTED: u8 = 0x80;

/// The second byte of STRANS: an absolute magnification or angle.
const ABSOLUTE: u8 = 0x06;

/// Appends the records of one placement. What is not the default is not said.
pub(super) fn put(child: &str, place: Corner, transform: &Transform, properties: &Properties, bytes: &mut Vec<u8>) {
    let Transform { x_reflection, magnification, rotation, .. } = *transform;
    put_mark(GdsRecordType::StructRef, bytes);
    put_text(GdsRecordType::StructRefName, child, bytes);
    if x_reflection || magnification != 1.0 || rotation != 0.0 {
        bytes.extend_from_slice(&header(GdsRecordType::Strans, GdsDataType::BitArray, 2));
        bytes.extend_from_slice(&[if x_reflection { REFLECTED } else { 0 }, 0]);
    }
    if magnification != 1.0 {
        put_real(GdsRecordType::Mag, magnification, bytes);
    }
    if rotation != 0.0 {
        put_real(GdsRecordType::Angle, rotation, bytes);
    }
    bytes.extend_from_slice(&header(GdsRecordType::Xy, GdsDataType::I32, 8));
    bytes.extend_from_slice(&place[0].to_be_bytes());
    bytes.extend_from_slice(&place[1].to_be_bytes());
    for (attribute, text) in properties {
        put_property(*attribute, text, bytes);
    }
    put_mark(GdsRecordType::EndElement, bytes);
}

/// Reads a placement whose first record was taken already.
pub(super) fn read(
    start: usize,
    records: &mut Records<'_>,
    grid: &Grid,
    mut problem: impl FnMut(usize, ProblemKind),
) -> Result<Placement, Fault> {
    let (mut child, mut origin, mut properties) = (None, None, Properties::new());
    let (mut reflected, mut magnification, mut rotation) = (false, None, None);
    loop {
        let record = records.next()?;
        match record.kind {
            kind::ENDEL => break,
            kind::SNAME => {
                let (name, latin1) = record.text();
                if latin1 {
                    problem(record.offset, ProblemKind::Latin1);
                }
                child = Some(name);
            }
            kind::STRANS => {
                let [first, second] = record.number()?.to_be_bytes();
                reflected = first & REFLECTED != 0;
                if second & ABSOLUTE != 0 {
                    problem(record.offset, ProblemKind::Absolute);
                }
            }
            kind::MAG => magnification = Some(real(&record)?),
            kind::ANGLE => rotation = Some(real(&record)?),
            kind::XY => origin = Some(point(&record, grid)?),
            kind::PROPATTR => {
                let (attribute, text) = records.property(&record, &mut problem)?;
                properties.insert(attribute, text);
            }
            kind::ELFLAGS | kind::PLEX => {}
            other => {
                record.check_inside_element()?;
                problem(record.offset, ProblemKind::Record(other));
            }
        }
    }
    let missing = |what: &str| Fault::new(start, format!("a reference without {what}"));
    let origin = origin.ok_or_else(|| missing("a place"))?;
    Ok(Placement {
        transform: transform(reflected, magnification, rotation, origin, start)?,
        child: child.ok_or_else(|| missing("a cell"))?,
        array: None,
        properties,
        offset: start,
    })
}

/// A placement from what a file says of it; what it does not say is the default.
pub(super) fn transform(
    x_reflection: bool,
    magnification: Option<f64>,
    rotation: Option<f64>,
    origin: Point,
    offset: usize,
) -> Result<Transform, Fault> {
    let magnification = magnification.unwrap_or(1.0);
    if magnification.is_nan() || magnification <= 0.0 {
        return Err(Fault::new(offset, format!("a magnification of {magnification}")));
    }
    let rotation = angle::normalized(rotation.unwrap_or(0.0));
    Ok(Transform { x_reflection, magnification, rotation, origin })
}

fn real(record: &Record<'_>) -> Result<f64, Fault> {
    let bytes = <[u8; 8]>::try_from(record.content());
    let bytes = bytes.map_err(|_| Fault::new(record.offset, "a real number that does not have 8 bytes"))?;
    Ok(GdsFloat64::decode(u64::from_be_bytes(bytes)))
}

fn point(record: &Record<'_>, grid: &Grid) -> Result<Point, Fault> {
    let &[a, b, c, d, e, f, g, h] = record.content() else {
        return Err(Fault::new(record.offset, "a place that is not one pair of 32-bit numbers"));
    };
    let um = |bytes| grid.um(i64::from(i32::from_be_bytes(bytes)));
    Ok(Point::new(um([a, b, c, d]), um([e, f, g, h])))
}
