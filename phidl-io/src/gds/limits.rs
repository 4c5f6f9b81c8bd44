//! What a file can say: checked before it is said, with errors that name the cell and the element.

use phidl_core::layer::Layer;
use phidl_core::scene::Device;

use super::options::{GdsLimits, is_real};
use crate::error::{IoError, Item, Result};

/// The checks of one file.
pub(super) struct Limits<'a>(pub(super) &'a GdsLimits);

impl Limits<'_> {
    pub(super) fn layer(&self, cell: &Device, layer: Layer, item: impl Fn() -> Item) -> Result<()> {
        if layer.number.max(layer.datatype) <= self.0.layer {
            return Ok(());
        }
        Err(refused(cell, item(), "layer", layer, format!("have numbers of at most {}", self.0.layer)))
    }

    pub(super) fn text(&self, cell: &Device, text: &str, item: impl Fn() -> Item) -> Result<()> {
        self.writable(cell, "text", text, self.0.text, item)
    }

    pub(super) fn property(&self, cell: &Device, attribute: u16, text: &str, item: impl Fn() -> Item) -> Result<()> {
        if !self.0.attributes.contains(&attribute) {
            let (first, last) = (self.0.attributes.start(), self.0.attributes.end());
            return Err(refused(cell, item(), "property attribute", attribute, format!("be from {first} to {last}")));
        }
        self.writable(cell, "property", text, self.0.property, item)
    }

    /// The format's real numbers reach only so far.
    pub(super) fn magnification(&self, cell: &Device, magnification: f64, item: impl Fn() -> Item) -> Result<()> {
        if is_real(magnification) {
            return Ok(());
        }
        Err(refused(cell, item(), "magnification", magnification, "be from 1e-70 to 1e70".to_owned()))
    }

    /// Texts are ASCII: gdspy stops at anything else, and every other reader guesses. Line ends are taken by all of them
    /// (and written by PHIDL's `gridsweep`, as by ours).
    fn writable(
        &self,
        cell: &Device,
        what: &'static str,
        text: &str,
        most: usize,
        item: impl Fn() -> Item,
    ) -> Result<()> {
        if text.len() > most {
            let value = format!("{} bytes long", text.len());
            return Err(refused(cell, item(), what, value, format!("have at most {most}")));
        }
        let foreign = |c: &char| !c.is_ascii() || (c.is_ascii_control() && *c != '\n');
        match text.chars().find(foreign) {
            None => Ok(()),
            Some(c) => {
                let rule = format!("be of printable ASCII characters, without {c:?}");
                Err(refused(cell, item(), what, format_args!("{text:?}"), rule))
            }
        }
    }
}

fn refused(cell: &Device, item: Item, what: &'static str, value: impl std::fmt::Display, rule: String) -> IoError {
    IoError::Refused {
        cell: cell.name().into(),
        item: Box::new(item),
        what,
        value: value.to_string().into(),
        rule: rule.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn item() -> Item {
        Item::Label { index: 0, text: "x".into() }
    }

    #[test]
    fn what_the_manual_forbids_most_readers_take() {
        let cell = Device::builder("c").build().unwrap();
        let (manual, readers) = (Limits(&GdsLimits::MANUAL), Limits(&GdsLimits::READERS));
        let long = "x".repeat(513);
        assert!(manual.layer(&cell, Layer::new(256, 0), item).is_err());
        assert!(manual.text(&cell, &long, item).is_err());
        assert!(manual.property(&cell, 128, "x", item).is_err());
        assert!(manual.property(&cell, 0, "x", item).is_err());
        assert!(manual.property(&cell, 1, &long[..127], item).is_err());
        assert!(readers.layer(&cell, Layer::new(65_535, 65_535), item).is_ok());
        assert!(readers.text(&cell, &long, item).is_ok());
        assert!(readers.property(&cell, 65_535, &long, item).is_ok());
    }

    #[test]
    fn texts_that_some_readers_stop_at_are_refused_with_the_character() {
        let cell = Device::builder("c").build().unwrap();
        let error = Limits(&GdsLimits::READERS).text(&cell, "5 µm", item).unwrap_err();
        assert!(error.to_string().contains("'µ'"), "{error}");
        assert!(Limits(&GdsLimits::READERS).text(&cell, "a\0b", item).is_err());
        assert!(Limits(&GdsLimits::MANUAL).text(&cell, "radius=1\nlayer=2", item).is_ok());
    }
}
