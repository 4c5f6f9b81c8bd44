//! BOUNDARY records to polygons: the hot path of the reader, from the file's bytes to the cell's buffer.

use std::borrow::Cow;

use phidl_core::geom::{Outline, Point};
use phidl_core::layer::Layer;
use phidl_core::num::grid::Grid;
use phidl_core::scene::Properties;

use super::problem::ProblemKind;
use super::scan::{Fault, Records, kind};

/// A boundary as the file has it.
pub(super) struct Boundary<'a> {
    pub(super) layer: Layer,
    pub(super) corners: Corners<'a>,
    pub(super) properties: Properties,
}

/// Corners as the file has them: pairs of 32-bit numbers, the repeated first one taken off.
pub(super) struct Corners<'a> {
    bytes: Cow<'a, [u8]>,
    grid: &'a Grid,
}

/// Bytes of a corner.
const CORNER: usize = 8;

impl<'a> Corners<'a> {
    fn new(mut bytes: Cow<'a, [u8]>, grid: &'a Grid) -> Self {
        let length = bytes.len();
        if length > CORNER && bytes[..CORNER] == bytes[length - CORNER..] {
            match &mut bytes {
                Cow::Borrowed(bytes) => *bytes = &bytes[..length - CORNER],
                Cow::Owned(bytes) => bytes.truncate(length - CORNER),
            }
        }
        Self { bytes, grid }
    }

    pub(super) fn len(&self) -> usize {
        self.bytes.len() / CORNER
    }
}

impl Outline for &Corners<'_> {
    fn append_to(self, buffer: &mut Vec<Point>) {
        let number = |bytes: &[u8]| match *bytes {
            [a, b, c, d] => self.grid.um(i64::from(i32::from_be_bytes([a, b, c, d]))),
            _ => f64::NAN,
        };
        buffer.extend(self.bytes.chunks_exact(CORNER).map(|c| Point::new(number(&c[..4]), number(&c[4..]))));
    }
}

/// Reads a boundary whose first record was taken already.
pub(super) fn read<'a>(
    records: &mut Records<'a>,
    grid: &'a Grid,
    mut problem: impl FnMut(usize, ProblemKind),
) -> Result<Boundary<'a>, Fault> {
    let start = records.offset - 4;
    let (mut number, mut datatype, mut xy) = (None, None, None::<Cow<'a, [u8]>>);
    let mut properties = Properties::new();
    loop {
        let record = records.next()?;
        match record.kind {
            kind::ENDEL => break,
            kind::LAYER => number = Some(record.number()?),
            kind::DATATYPE => datatype = Some(record.number()?),
            kind::XY if record.content().len() % CORNER != 0 => {
                return Err(Fault::new(record.offset, "coordinates that are not pairs of 32-bit numbers"));
            }
            // Some writers continue long outlines in further records.
            kind::XY => match &mut xy {
                None => xy = Some(Cow::Borrowed(record.content())),
                Some(xy) => xy.to_mut().extend_from_slice(record.content()),
            },
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
    let missing = |what: &str| Fault::new(start, format!("a boundary without {what}"));
    Ok(Boundary {
        layer: Layer::new(number.ok_or_else(|| missing("layer"))?, datatype.ok_or_else(|| missing("datatype"))?),
        corners: Corners::new(xy.ok_or_else(|| missing("coordinates"))?, grid),
        properties,
    })
}
