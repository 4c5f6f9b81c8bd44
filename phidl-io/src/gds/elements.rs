//! Labels and references to records: labels and arrays in the words of gds21, which encodes them; single references not.

use gds21::{GdsArrayRef, GdsElement, GdsError, GdsPoint, GdsPresentation, GdsProperty, GdsStrans, GdsTextElem};
use phidl_core::geom::Transform;
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Anchor, Device, Label, Properties, Reference};

use super::cells::CellTable;
use super::frame::Frame;
use super::lattice::{self, Block, LatticeError, MOST_BLOCKS};
use super::limits::Limits;
use super::single;
use super::split::Corner;
use crate::error::{IoError, Item, Result};

/// So many elements are handed to gds21 at a time: few enough to stay near the processor, where a million at once would
/// take three hundred megabytes.
const PORTION: usize = 4096;

/// The labels and references of one cell, on their way into the file.
pub(super) struct Elements<'a> {
    pub(super) cell: &'a Device,
    pub(super) table: &'a CellTable,
    pub(super) frame: &'a Frame,
    pub(super) grid: &'a Grid,
    pub(super) limits: &'a Limits<'a>,
}

impl Elements<'_> {
    /// Appends the records of all labels, then of all references, as PHIDL orders them; `flush` takes the bytes away
    /// from time to time. Returns how many arrays were taken apart.
    pub(super) fn write(&self, bytes: &mut Vec<u8>, mut flush: impl FnMut(&mut Vec<u8>) -> Result<()>) -> Result<u64> {
        let mut portion = Vec::new();
        let mut taken_apart = 0;
        for (index, label) in self.cell.labels().iter().enumerate() {
            portion.push(self.label(index, label)?.into());
            if portion.len() >= PORTION {
                self.encode(&mut portion, bytes)?;
                flush(bytes)?;
            }
        }
        self.encode(&mut portion, bytes)?;
        for (index, reference) in self.cell.references().iter().enumerate() {
            taken_apart += u64::from(self.reference(index, reference, bytes)? > 1);
            flush(bytes)?;
        }
        Ok(taken_apart)
    }

    /// Hands some elements to gds21.
    fn encode(&self, elements: &mut Vec<GdsElement>, bytes: &mut Vec<u8>) -> Result<()> {
        if !elements.is_empty() {
            let encoded = self.frame.elements(std::mem::take(elements));
            bytes.extend_from_slice(&encoded.map_err(unfit)?);
        }
        Ok(())
    }

    /// Appends the records of a reference, and returns how many placements and arrays it became.
    fn reference(&self, index: usize, reference: &Reference, bytes: &mut Vec<u8>) -> Result<usize> {
        let item = || reference_item(index, reference);
        self.limits.magnification(self.cell, reference.transform().magnification, item)?;
        for (attribute, text) in &reference.properties {
            self.limits.property(self.cell, *attribute, text, item)?;
        }
        let child = self.table.name_of(reference.device());
        let single = |place, bytes: &mut Vec<u8>| {
            single::put(child, place, reference.transform(), &reference.properties, bytes);
        };
        if reference.array().is_none() {
            let place = super::corner(self.grid, reference.transform().origin);
            single(place.map_err(|source| self.out_of_range(item(), source))?, bytes);
            return Ok(1);
        }
        let blocks = self.blocks(index, reference)?;
        for block in &blocks {
            if block.columns == 1 && block.rows == 1 {
                single(block.first, bytes);
            } else {
                self.encode(&mut vec![self.array(index, reference, block)?.into()], bytes)?;
            }
        }
        Ok(blocks.len())
    }

    fn label(&self, index: usize, label: &Label) -> Result<GdsTextElem> {
        let item = || Item::Label { index, text: label.text.clone() };
        self.limits.layer(self.cell, label.layer, item)?;
        self.limits.text(self.cell, &label.text, item)?;
        let place = super::corner(self.grid, label.position()).map_err(|source| self.out_of_range(item(), source))?;
        Ok(GdsTextElem {
            string: label.text.clone(),
            layer: label.layer.number.cast_signed(),
            texttype: label.layer.datatype.cast_signed(),
            xy: point(place),
            presentation: Some(GdsPresentation(0, presentation(label.anchor))),
            path_type: None,
            width: None,
            strans: self.strans(label.transform(), item)?,
            elflags: None,
            plex: None,
            properties: self.properties(&label.properties, item)?,
        })
    }

    fn blocks(&self, index: usize, reference: &Reference) -> Result<Vec<Block>> {
        lattice::blocks(reference, self.grid).map_err(|error| {
            let item = reference_item(index, reference);
            match error {
                LatticeError::OutOfRange(source) => self.out_of_range(item, source),
                LatticeError::TooManyBlocks => IoError::Refused {
                    cell: self.cell.name().into(),
                    item: Box::new(item),
                    what: "array",
                    value: format!("of {} elements off the grid", reference.count()).into(),
                    rule: format!("have at most {MOST_BLOCKS} of these").into(),
                },
            }
        })
    }

    fn array(&self, index: usize, reference: &Reference, block: &Block) -> Result<GdsArrayRef> {
        let item = || reference_item(index, reference);
        Ok(GdsArrayRef {
            name: self.table.name_of(reference.device()).to_owned(),
            xy: [block.first, block.column_end, block.row_end].map(point),
            cols: block.columns.cast_signed(),
            rows: block.rows.cast_signed(),
            strans: self.strans(reference.transform(), item)?,
            elflags: None,
            plex: None,
            properties: self.properties(&reference.properties, item)?,
        })
    }

    /// What is not the default: most placements need no record for it.
    fn strans(&self, transform: &Transform, item: impl Fn() -> Item) -> Result<Option<GdsStrans>> {
        self.limits.magnification(self.cell, transform.magnification, item)?;
        let strans = GdsStrans {
            reflected: transform.x_reflection,
            abs_mag: false,
            abs_angle: false,
            mag: (transform.magnification != 1.0).then_some(transform.magnification),
            angle: (transform.rotation != 0.0).then_some(transform.rotation),
        };
        let plain = !strans.reflected && strans.mag.is_none() && strans.angle.is_none();
        Ok((!plain).then_some(strans))
    }

    fn properties(&self, properties: &Properties, item: impl Fn() -> Item) -> Result<Vec<GdsProperty>> {
        let property = |(attribute, text): (&u16, &String)| {
            self.limits.property(self.cell, *attribute, text, &item)?;
            Ok(GdsProperty { attr: attribute.cast_signed(), value: text.clone() })
        };
        properties.iter().map(property).collect()
    }

    fn out_of_range(&self, item: Item, source: phidl_core::num::grid::GridError) -> IoError {
        IoError::OutOfRange { cell: self.cell.name().into(), item: Box::new(item), source }
    }
}

/// Only a text that is too long for a record can fail in gds21, and those were refused before.
pub(super) fn unfit(error: GdsError) -> IoError {
    IoError::option("limits", error, "fit the records of the format")
}

fn reference_item(index: usize, reference: &Reference) -> Item {
    Item::Reference { index, child: reference.device().name().to_owned() }
}

fn point(corner: Corner) -> GdsPoint {
    GdsPoint::new(corner[0], corner[1])
}

/// Two bits for top, middle, bottom; two for left, center, right.
fn presentation(anchor: Anchor) -> u8 {
    match anchor {
        Anchor::NorthWest => 0b0000,
        Anchor::North => 0b0001,
        Anchor::NorthEast => 0b0010,
        Anchor::West => 0b0100,
        Anchor::Center => 0b0101,
        Anchor::East => 0b0110,
        Anchor::SouthWest => 0b1000,
        Anchor::South => 0b1001,
        Anchor::SouthEast => 0b1010,
    }
}

/// The inverse of [`presentation`]; the codes that mean nothing count as the center.
pub(super) fn anchor(presentation: u8) -> Anchor {
    const ALL: [Anchor; 9] = [
        Anchor::NorthWest,
        Anchor::North,
        Anchor::NorthEast,
        Anchor::West,
        Anchor::Center,
        Anchor::East,
        Anchor::SouthWest,
        Anchor::South,
        Anchor::SouthEast,
    ];
    let known = ALL.into_iter().find(|anchor| self::presentation(*anchor) == presentation & 0b1111);
    known.unwrap_or(Anchor::Center)
}
