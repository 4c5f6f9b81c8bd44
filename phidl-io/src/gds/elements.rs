//! Labels and references in the words of gds21, which encodes them.

use gds21::{GdsArrayRef, GdsElement, GdsPoint, GdsPresentation, GdsProperty, GdsStrans, GdsStructRef, GdsTextElem};
use phidl_core::geom::Transform;
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Anchor, Device, Label, Properties, Reference};

use super::cells::CellTable;
use super::lattice::{self, Block, LatticeError, MOST_BLOCKS};
use super::limits::Limits;
use super::split::Corner;
use crate::error::{IoError, Item, Result};

/// The labels and references of one cell, on their way into the file.
pub(super) struct Elements<'a> {
    pub(super) cell: &'a Device,
    pub(super) table: &'a CellTable,
    pub(super) grid: &'a Grid,
    pub(super) limits: &'a Limits<'a>,
}

impl Elements<'_> {
    /// Labels first, then references, as PHIDL writes them; with the number of arrays that were taken apart.
    pub(super) fn all(&self) -> Result<(Vec<GdsElement>, u64)> {
        let mut elements = Vec::new();
        let mut taken_apart = 0;
        for (index, label) in self.cell.labels().iter().enumerate() {
            elements.push(self.label(index, label)?.into());
        }
        for (index, reference) in self.cell.references().iter().enumerate() {
            let blocks = self.blocks(index, reference)?;
            taken_apart += u64::from(blocks.len() > 1);
            for block in &blocks {
                elements.push(self.block(index, reference, block)?);
            }
        }
        Ok((elements, taken_apart))
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

    fn block(&self, index: usize, reference: &Reference, block: &Block) -> Result<GdsElement> {
        let item = || reference_item(index, reference);
        let name = self.table.name_of(reference.device()).to_owned();
        let strans = self.strans(reference.transform(), item)?;
        let properties = self.properties(&reference.properties, item)?;
        let (elflags, plex) = (None, None);
        if block.columns == 1 && block.rows == 1 {
            return Ok(GdsStructRef { name, xy: point(block.first), strans, elflags, plex, properties }.into());
        }
        let xy = [block.first, block.column_end, block.row_end].map(point);
        let (cols, rows) = (block.columns.cast_signed(), block.rows.cast_signed());
        Ok(GdsArrayRef { name, xy, cols, rows, strans, elflags, plex, properties }.into())
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
