//! [`Fields`]: the records of one element, collected up to its ENDEL.
//!
//! One loop serves all kinds of elements, so that one place decides what is tolerated: records in any order, several XY
//! records, records that the kind does not use. A broken record makes the element a problem and not the file.

use std::borrow::Cow;

use phidl_core::layer::Layer;
use phidl_core::num::angle;
use phidl_core::scene::Properties;

use crate::error::real;
use crate::gds::real::is_representable;
use crate::gds::record::{FormatError, Record, Records, kind, put_text, put_u16};
use crate::model::{Corner, ProblemKind, Problems};

/// Bytes of a corner.
const CORNER: usize = 8;

/// Why an element is left out: a sentence without a full stop.
pub(in crate::gds) type Defect = Box<str>;

/// The second byte of STRANS: an absolute magnification or angle.
const ABSOLUTE: u16 = 0x0006;

/// The first bit of STRANS: the reflection.
const REFLECTED: u16 = 0x8000;

/// What the records of an element state.
#[derive(Debug, Default)]
pub(in crate::gds) struct Fields<'a> {
    /// Where the element begins in the file.
    pub(in crate::gds) offset: usize,
    layer: Option<u16>,
    /// DATATYPE, TEXTTYPE, BOXTYPE or NODETYPE.
    datatype: Option<u16>,
    xy: Option<Cow<'a, [u8]>>,
    pub(in crate::gds) name: Option<Record<'a>>,
    pub(in crate::gds) string: Option<Record<'a>>,
    pub(in crate::gds) columns_and_rows: Option<(u16, u16)>,
    transform: Option<u16>,
    magnification: Option<f64>,
    angle: Option<f64>,
    pub(in crate::gds) width: Option<i32>,
    pub(in crate::gds) path_type: Option<i16>,
    pub(in crate::gds) start_extension: Option<i32>,
    pub(in crate::gds) end_extension: Option<i32>,
    pub(in crate::gds) presentation: Option<u16>,
    properties: Properties,
    defect: Option<Defect>,
}

impl<'a> Fields<'a> {
    /// Reads the records of an element whose first record, at `offset`, was taken already.
    ///
    /// # Errors
    /// If the element does not end.
    pub(in crate::gds) fn read(
        offset: usize,
        records: &mut Records<'a>,
        cell: &str,
        problems: &mut Problems,
    ) -> Result<Self, FormatError> {
        let mut fields = Self { offset, ..Self::default() };
        loop {
            let record = records.next()?;
            if record.kind == kind::ENDEL {
                return Ok(fields);
            }
            if record.is_outside_elements() {
                let problem = format!("record {:#04x} stands inside an element, which has no ENDEL", record.kind);
                return Err(FormatError::new(record.offset, problem));
            }
            if record.kind == kind::PROPATTR {
                fields.property(&record, records, cell, problems)?;
            } else if let Err(error) = fields.take(&record, cell, problems) {
                fields.defect.get_or_insert(error.problem);
            }
        }
    }

    /// Takes one record.
    fn take(&mut self, record: &Record<'a>, cell: &str, problems: &mut Problems) -> Result<(), FormatError> {
        match record.kind {
            kind::LAYER => self.layer = Some(record.u16()?),
            kind::DATATYPE | kind::TEXTTYPE | kind::BOXTYPE | kind::NODETYPE => self.datatype = Some(record.u16()?),
            kind::XY => self.corners_of(record)?,
            kind::SNAME => self.name = Some(*record),
            kind::STRING => self.string = Some(*record),
            kind::COLROW => self.columns_and_rows = Some(columns_and_rows(record)?),
            kind::STRANS => {
                let bits = record.u16()?;
                if bits & ABSOLUTE != 0 {
                    problems.push(cell, record.offset, ProblemKind::Absolute);
                }
                self.transform = Some(bits);
            }
            kind::MAG => self.magnification = Some(record.real()?),
            kind::ANGLE => self.angle = Some(record.real()?),
            kind::WIDTH => self.width = Some(record.i32()?),
            kind::PATHTYPE => self.path_type = Some(record.u16()?.cast_signed()),
            kind::BGNEXTN => self.start_extension = Some(record.i32()?),
            kind::ENDEXTN => self.end_extension = Some(record.i32()?),
            kind::PRESENTATION => self.presentation = Some(record.u16()?),
            kind::ELFLAGS | kind::PLEX => {}
            other => problems.push(cell, record.offset, ProblemKind::Record(other)),
        }
        Ok(())
    }

    /// Adds corners. Some writers continue long outlines in further records.
    fn corners_of(&mut self, record: &Record<'a>) -> Result<(), FormatError> {
        if !record.content.len().is_multiple_of(CORNER) {
            return Err(FormatError::new(record.offset, "its coordinates are not pairs of 32-bit numbers"));
        }
        match &mut self.xy {
            None => self.xy = Some(Cow::Borrowed(record.content)),
            Some(xy) => xy.to_mut().extend_from_slice(record.content),
        }
        Ok(())
    }

    /// Takes a property, whose attribute was read already. The first property of an attribute is kept.
    fn property(
        &mut self,
        attribute: &Record<'_>,
        records: &mut Records<'a>,
        cell: &str,
        problems: &mut Problems,
    ) -> Result<(), FormatError> {
        let start = records.offset;
        let value = records.next()?;
        let Ok(number) = attribute.u16() else {
            problems.push(cell, attribute.offset, ProblemKind::Record(kind::PROPATTR));
            return Ok(());
        };
        if value.kind != kind::PROPVALUE {
            problems.push(cell, attribute.offset, ProblemKind::Record(kind::PROPATTR));
            records.offset = start;
            return Ok(());
        }
        let text = text_of(&value, cell, problems);
        match self.properties.entry(number) {
            std::collections::btree_map::Entry::Vacant(entry) => {
                entry.insert(text);
            }
            std::collections::btree_map::Entry::Occupied(_) => {
                problems.push(cell, attribute.offset, ProblemKind::RepeatedProperty(number));
            }
        }
        Ok(())
    }

    /// Refuses an element with a broken record.
    pub(in crate::gds) fn check(&mut self) -> Result<(), Defect> {
        self.defect.take().map_or(Ok(()), Err)
    }

    /// The layer. A type that is not stated is 0, as all readers take it.
    pub(in crate::gds) fn layer(&self) -> Result<Layer, Defect> {
        let number = self.layer.ok_or("it states no layer")?;
        Ok(Layer::new(number, self.datatype.unwrap_or(0)))
    }

    /// The corners, as often as the file repeats them.
    pub(in crate::gds) fn corners(
        &self,
    ) -> Result<impl ExactSizeIterator<Item = Corner> + DoubleEndedIterator, Defect> {
        let xy = self.xy.as_deref().ok_or("it has no coordinates")?;
        Ok(xy.chunks_exact(CORNER).map(corner))
    }

    /// The corners of a closed outline, without the repeated first one at the end.
    pub(in crate::gds) fn outline(&self) -> Result<impl ExactSizeIterator<Item = Corner> + Clone, Defect> {
        let mut xy = self.xy.as_deref().ok_or("it has no coordinates")?;
        if xy.len() > CORNER && xy[..CORNER] == xy[xy.len() - CORNER..] {
            xy = &xy[..xy.len() - CORNER];
        }
        Ok(xy.chunks_exact(CORNER).map(corner))
    }

    /// The points of an element that has `N` of them. Further points are a problem.
    pub(in crate::gds) fn points<const N: usize>(
        &self,
        cell: &str,
        problems: &mut Problems,
    ) -> Result<[Corner; N], Defect> {
        let corners = self.corners()?;
        let stated = corners.len();
        if stated > N {
            problems.push(cell, self.offset, ProblemKind::FurtherPoints);
        }
        let points: Vec<Corner> = corners.take(N).collect();
        points.try_into().map_err(|_| format!("it has {stated} points instead of {N}").into())
    }

    /// Whether the element is mirrored about the x axis.
    pub(in crate::gds) fn x_reflection(&self) -> bool {
        self.transform.is_some_and(|bits| bits & REFLECTED != 0)
    }

    /// The magnification, if it is stated. STRANS need not be there.
    pub(in crate::gds) fn magnification(&self) -> Result<Option<f64>, Defect> {
        match self.magnification {
            Some(stated) if !is_representable(stated) => Err(format!("its magnification is {}", real(stated)).into()),
            stated => Ok(stated),
        }
    }

    /// The rotation in `[0, 360)`.
    pub(in crate::gds) fn rotation(&self) -> f64 {
        angle::normalized(self.angle.unwrap_or(0.0))
    }

    /// The properties, which are taken out.
    pub(in crate::gds) fn properties(&mut self) -> Properties {
        std::mem::take(&mut self.properties)
    }
}

fn columns_and_rows(record: &Record<'_>) -> Result<(u16, u16), FormatError> {
    match *record.content {
        [a, b, c, d] => Ok((u16::from_be_bytes([a, b]), u16::from_be_bytes([c, d]))),
        _ => Err(FormatError::new(record.offset, "its columns and rows are not two 16-bit numbers")),
    }
}

fn corner(bytes: &[u8]) -> Corner {
    match *bytes {
        [a, b, c, d, e, f, g, h] => [i32::from_be_bytes([a, b, c, d]), i32::from_be_bytes([e, f, g, h])],
        _ => unreachable!("invariant: chunks of eight bytes"),
    }
}

/// A text; one that is not UTF-8 is a problem.
pub(in crate::gds) fn text_of(record: &Record<'_>, cell: &str, problems: &mut Problems) -> String {
    let (text, latin1) = record.text();
    if latin1 {
        problems.push(cell, record.offset, ProblemKind::Latin1);
    }
    text
}

/// Appends LAYER and the record of the type.
pub(in crate::gds) fn put_layer(layer: Layer, type_kind: u8, bytes: &mut Vec<u8>) {
    put_u16(kind::LAYER, layer.number, bytes);
    put_u16(type_kind, layer.datatype, bytes);
}

/// Appends PROPATTR and PROPVALUE of each property.
pub(in crate::gds) fn put_properties(properties: &Properties, bytes: &mut Vec<u8>) {
    for (attribute, text) in properties {
        put_u16(kind::PROPATTR, *attribute, bytes);
        put_text(kind::PROPVALUE, text, bytes);
    }
}

/// Appends STRANS, MAG and ANGLE as far as they are not the default.
pub(in crate::gds) fn put_transform(
    x_reflection: bool,
    magnification: Option<f64>,
    rotation: f64,
    bytes: &mut Vec<u8>,
) {
    use crate::gds::record::{put_bits, put_reals};
    if x_reflection || magnification.is_some() || rotation != 0.0 {
        put_bits(kind::STRANS, if x_reflection { REFLECTED } else { 0 }, bytes);
    }
    if let Some(magnification) = magnification {
        put_reals(kind::MAG, [magnification], bytes);
    }
    if rotation != 0.0 {
        put_reals(kind::ANGLE, [rotation], bytes);
    }
}
