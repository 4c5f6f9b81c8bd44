//! The elements that gds21 decodes: boxes, paths, texts and arrays.
//!
//! They are collected in portions and handed to gds21 as a library of one cell, since it reads nothing smaller. On the
//! way there, texts are made readable for it. If it refuses a portion, the guilty element is searched for by halves, as
//! its errors mostly do not say where.

use gds21::GdsTextElem;
use gds21::{GdsArrayRef, GdsBox, GdsElement, GdsError, GdsLibrary, GdsPath, GdsPoint, GdsProperty, GdsStrans};
use phidl_core::geom::{Point, Transform};
use phidl_core::layer::Layer;
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Array, Label, Polygon, Properties};

use super::elements::anchor;
use super::frame::{END_CELL, Frame};
use super::options::GdsDate;
use super::path::{Centerline, End};
use super::problem::ProblemKind;
use super::scan::{Fault, Record, Records, kind};
use super::single::{self, Placement};

/// Portions are decoded when they have grown to this many bytes.
const PORTION: usize = 1 << 18;

/// The data type of texts.
const TEXT: u8 = gds21::GdsDataType::Str as u8;

/// Where an element of the portion comes from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Origin {
    /// The number of its cell.
    pub(super) cell: usize,
    /// Where it begins in the file.
    pub(super) offset: usize,
    /// Where it ends in the portion.
    end: usize,
}

/// A decoded element.
pub(super) enum Element {
    Polygon(Polygon),
    Label(Label),
    Reference(Placement),
}

/// A portion of elements.
pub(super) struct Rest {
    frame: Frame,
    bytes: Vec<u8>,
    origins: Vec<Origin>,
}

impl Rest {
    pub(super) fn new() -> Self {
        let frame = Frame::new("rest", GdsDate::default(), (1e-3, 1e-9));
        let frame = frame.expect("invariant: gds21 writes an empty library");
        Self { frame, bytes: Vec::new(), origins: Vec::new() }
    }

    pub(super) fn is_full(&self) -> bool {
        self.bytes.len() >= PORTION
    }

    /// Takes an element over, from the first record, which was taken already, to the last.
    pub(super) fn collect(
        &mut self,
        cell: usize,
        first: Record<'_>,
        records: &mut Records<'_>,
        mut problem: impl FnMut(usize, ProblemKind),
    ) -> Result<(), Fault> {
        self.bytes.extend_from_slice(first.whole);
        loop {
            let record = records.next()?;
            if record.kind == kind::ENDEL {
                self.bytes.extend_from_slice(record.whole);
                self.origins.push(Origin { cell, offset: first.offset, end: self.bytes.len() });
                return Ok(());
            }
            record.check_inside_element()?;
            if record.kind > kind::LAST {
                problem(record.offset, ProblemKind::Record(record.kind));
            } else if record.whole[3] == TEXT {
                self.text(record, &mut problem)?;
            } else {
                self.bytes.extend_from_slice(record.whole);
            }
        }
    }

    /// A text as gds21 can read it: not empty, and in UTF-8.
    fn text(&mut self, record: Record<'_>, mut problem: impl FnMut(usize, ProblemKind)) -> Result<(), Fault> {
        let (text, latin1) = record.text();
        if latin1 {
            problem(record.offset, ProblemKind::Latin1);
        }
        // At least one zero to take away: gds21 looks at the last byte of a text without asking whether there is one.
        let padded = (text.len() + 2) & !1;
        let length = u16::try_from(padded + 4).map_err(|_| Fault::new(record.offset, "a text that is too long"))?;
        self.bytes.extend_from_slice(&length.to_be_bytes());
        self.bytes.extend_from_slice(&record.whole[2..4]);
        self.bytes.extend_from_slice(text.as_bytes());
        self.bytes.resize(self.bytes.len() + padded - text.len(), 0);
        Ok(())
    }

    /// Decodes what was collected, in order, and begins a new portion.
    pub(super) fn decode(&mut self, grid: &Grid) -> Result<Decoded, FaultIn> {
        let elements = self.parse(&self.bytes).map_err(|_| self.culprit())?;
        let mut decoded = Decoded { elements: Vec::with_capacity(elements.len()), problems: Vec::new() };
        for (element, origin) in elements.into_iter().zip(&self.origins) {
            let mut convert = Convert { grid, offset: origin.offset, problems: Vec::new() };
            let element = convert.element(element).map_err(|fault| FaultIn { cell: origin.cell, fault })?;
            let problems = convert.problems.into_iter().map(|kind| (*origin, kind));
            decoded.problems.extend(problems);
            decoded.elements.extend(element.map(|element| (*origin, element)));
        }
        self.bytes.clear();
        self.origins.clear();
        Ok(decoded)
    }

    fn parse(&self, elements: &[u8]) -> Result<Vec<GdsElement>, GdsError> {
        let begin = self.frame.cell("rest")?;
        let library = [&self.frame.head[..], &begin, elements, &END_CELL, &self.frame.tail].concat();
        let mut library = GdsLibrary::from_bytes(&library)?;
        Ok(library.structs.pop().map(|cell| cell.elems).unwrap_or_default())
    }

    /// The first element that cannot be decoded: all portions up to one before it can.
    fn culprit(&self) -> FaultIn {
        let place = self.origins.partition_point(|origin| self.parse(&self.bytes[..origin.end]).is_ok());
        let start = if place == 0 { 0 } else { self.origins[place - 1].end };
        let origin = self.origins.get(place).expect("invariant: what fails as a whole fails at one of its elements");
        let error = self.parse(&self.bytes[start..origin.end]).err();
        let reason = error.map_or_else(|| "it does not end".to_owned(), reason);
        let fault = Fault::new(origin.offset, format!("an element that cannot be decoded: {reason}"));
        FaultIn { cell: origin.cell, fault }
    }
}

/// The elements of a portion, and what could not be kept of them.
pub(super) struct Decoded {
    pub(super) elements: Vec<(Origin, Element)>,
    pub(super) problems: Vec<(Origin, ProblemKind)>,
}

/// A fault with the number of its cell.
pub(super) struct FaultIn {
    pub(super) cell: usize,
    pub(super) fault: Fault,
}

/// What gds21 said, in a few words. (Its own words may hold all coordinates of an element.)
fn reason(error: GdsError) -> String {
    match error {
        GdsError::Parse { msg, .. } | GdsError::Str(msg) => msg,
        GdsError::Boxed(error) => error.to_string(),
        GdsError::RecordDecode(record, data, length) => format!("{record:?} with {length} bytes of {data:?}"),
        GdsError::InvalidRecordType(kind) => format!("a record of kind {kind:#04x}"),
        GdsError::InvalidDataType(data) => format!("data of type {data}"),
        GdsError::RecordLen(length) => format!("a record of {length} bytes"),
        GdsError::Unsupported(..) => "a record that has no place here".to_owned(),
    }
}

/// One element of gds21's into one of ours.
struct Convert<'a> {
    grid: &'a Grid,
    offset: usize,
    problems: Vec<ProblemKind>,
}

impl Convert<'_> {
    fn element(&mut self, element: GdsElement) -> Result<Option<Element>, Fault> {
        Ok(match element {
            GdsElement::GdsBox(e) => Some(Element::Polygon(self.box_element(&e))),
            GdsElement::GdsPath(e) => self.path(&e).map(Element::Polygon),
            GdsElement::GdsTextElem(e) => Some(Element::Label(self.label(e)?)),
            GdsElement::GdsArrayRef(e) => Some(Element::Reference(self.array(e)?)),
            // None of these is ever collected.
            GdsElement::GdsBoundary(_) | GdsElement::GdsStructRef(_) | GdsElement::GdsNode(_) => None,
        })
    }

    fn box_element(&mut self, element: &GdsBox) -> Polygon {
        self.problems.push(ProblemKind::Box);
        let corners = &element.xy[..4];
        let points: Vec<Point> = corners.iter().map(|p| self.point(p)).collect();
        let mut polygon = Polygon::new(points, layer(element.layer, element.boxtype));
        polygon.properties = properties(&element.properties);
        polygon
    }

    fn path(&mut self, element: &GdsPath) -> Option<Polygon> {
        // A negative width shall not be magnified with the cell; outlines always are.
        let width = self.um(element.width.unwrap_or(0)).abs();
        if element.width.is_some_and(|width| width < 0) {
            self.problems.push(ProblemKind::Absolute);
        }
        let extension = |length: Option<i32>| End::Extended(self.um(length.unwrap_or(0)));
        let (begin, end) = match element.path_type {
            Some(1) => {
                let round = End::Round { tolerance: self.grid.step() / 2.0 };
                (round, round)
            }
            Some(2) => (End::Extended(width / 2.0), End::Extended(width / 2.0)),
            Some(4) => (extension(element.begin_extn), extension(element.end_extn)),
            _ => (End::Extended(0.0), End::Extended(0.0)),
        };
        let points = element.xy.iter().map(|p| self.point(p)).collect();
        let Some(outline) = (Centerline { points, width, begin, end }).outline() else {
            self.problems.push(ProblemKind::Empty);
            return None;
        };
        let mut polygon = Polygon::new(outline, layer(element.layer, element.datatype));
        polygon.properties = properties(&element.properties);
        Some(polygon)
    }

    fn label(&mut self, element: GdsTextElem) -> Result<Label, Fault> {
        let transform = self.transform(element.strans.as_ref(), &element.xy)?;
        let text = trimmed(element.string);
        let label = Label::new(text, transform.origin, layer(element.layer, element.texttype));
        // Without a word about it, the text hangs from its upper left corner.
        let presentation = element.presentation.map_or(0, |presentation| presentation.1);
        let mut label = label.with_transform(transform).anchored(anchor(presentation));
        label.properties = properties(&element.properties);
        Ok(label)
    }

    fn array(&mut self, element: GdsArrayRef) -> Result<Placement, Fault> {
        let count = |count: i16| u32::try_from(count).ok().filter(|count| *count > 0);
        let Some((columns, rows)) = count(element.cols).zip(count(element.rows)) else {
            let problem = format!("an array of {} columns and {} rows", element.cols, element.rows);
            return Err(Fault::new(self.offset, problem));
        };
        let [first, column_end, row_end] = &element.xy;
        let transform = self.transform(element.strans.as_ref(), first)?;
        // Steps belong to the array's own frame: what the reader sees, with turn and reflection undone.
        let frame = Transform { magnification: 1.0, origin: Point::ORIGIN, ..transform }.inverse();
        let step = |end, count| frame.apply_vector((self.point(end) - self.point(first)) / f64::from(count));
        let array = Array { columns, rows, column_step: step(column_end, columns), row_step: step(row_end, rows) };
        Ok(Placement {
            transform,
            child: trimmed(element.name),
            array: Some(array),
            properties: properties(&element.properties),
            offset: self.offset,
        })
    }

    fn transform(&mut self, strans: Option<&GdsStrans>, origin: &GdsPoint) -> Result<Transform, Fault> {
        let origin = self.point(origin);
        let Some(strans) = strans else { return Ok(Transform::translation(origin)) };
        if strans.abs_mag || strans.abs_angle {
            self.problems.push(ProblemKind::Absolute);
        }
        single::transform(strans.reflected, strans.mag, strans.angle, origin, self.offset)
    }

    fn point(&self, point: &GdsPoint) -> Point {
        Point::new(self.um(point.x), self.um(point.y))
    }

    fn um(&self, steps: i32) -> f64 {
        self.grid.um(i64::from(steps))
    }
}

fn layer(number: i16, datatype: i16) -> Layer {
    Layer::new(number.cast_unsigned(), datatype.cast_unsigned())
}

fn properties(properties: &[GdsProperty]) -> Properties {
    properties.iter().map(|p| (p.attr.cast_unsigned(), p.value.trim_end_matches('\0').to_owned())).collect()
}

fn trimmed(mut text: String) -> String {
    text.truncate(text.trim_end_matches('\0').len());
    text
}
