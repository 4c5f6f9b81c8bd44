//! The identity of a cell: digests of its content and of its drawing.
//!
//! BLAKE3 over a canonical byte stream: every number as its bits (both zeros alike), every list and text after its length,
//! every variant after a tag. A placed cell enters as its digest, so each distinct cell is hashed once.

use crate::geom::{Point, Transform};
use crate::param::{Value, float_key};
use crate::port::Port;
use crate::scene::{Anchor, Cell, Device, Label, Properties, Reference, Source, TextStyle};

/// The identity of a cell's content: 32 bytes, the same on every machine and in every run.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Digest([u8; 32]);

impl Digest {
    /// The bytes.
    #[must_use]
    pub fn bytes(&self) -> &[u8; 32] {
        &self.0
    }
}

impl std::fmt::Display for Digest {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

impl std::fmt::Debug for Digest {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}

/// The digest of everything in a cell.
pub(crate) fn content(cell: &Cell) -> Digest {
    let mut stream = Stream::new(Device::content_hash);
    stream.text(&cell.name);
    stream.drawing(cell);
    stream.list(cell.ports.iter(), Stream::port);
    stream.count(cell.aliases.len());
    for alias in cell.aliases.iter() {
        stream.text(&alias.name);
        stream.count(alias.index);
    }
    stream.map(cell.info.iter().map(|(key, value)| (key.as_str(), value)));
    stream.list(cell.source.iter(), Stream::source);
    stream.finish()
}

/// The digest of everything that a file stores of a cell, except its name.
pub(crate) fn drawing(cell: &Cell) -> Digest {
    let mut stream = Stream::new(Device::drawing_hash);
    stream.drawing(cell);
    stream.finish()
}

struct Stream {
    hasher: blake3::Hasher,
    /// The digest of a placed cell.
    child: fn(&Device) -> Digest,
}

impl Stream {
    fn new(child: fn(&Device) -> Digest) -> Self {
        Self { hasher: blake3::Hasher::new(), child }
    }

    fn finish(self) -> Digest {
        Digest(*self.hasher.finalize().as_bytes())
    }

    fn drawing(&mut self, cell: &Cell) {
        self.count(cell.polygons.len());
        for polygon in cell.polygons.iter() {
            self.layer(polygon.layer.number, polygon.layer.datatype);
            self.points(polygon.points);
            self.properties_of(polygon.properties());
        }
        self.list(&cell.references, Self::reference);
        self.list(&cell.labels, Self::label);
    }

    fn reference(&mut self, reference: &Reference) {
        let child = (self.child)(reference.device());
        self.hasher.update(child.bytes());
        self.transform(reference.transform());
        match reference.array() {
            None => self.tag(0),
            Some(array) => {
                self.tag(1);
                self.count(array.columns as usize);
                self.count(array.rows as usize);
                self.points(&[array.column_step, array.row_step]);
            }
        }
        self.properties(&reference.properties);
    }

    fn label(&mut self, label: &Label) {
        self.text(&label.text);
        self.layer(label.layer.number, label.layer.datatype);
        self.tag(anchor_tag(label.anchor));
        self.transform(label.transform());
        self.properties(&label.properties);
        // Only labels that were read have a style; the digests of others do not depend on it.
        if label.style() != TextStyle::default() {
            self.tag(2);
            self.style(&label.style());
        }
    }

    fn style(&mut self, style: &TextStyle) {
        let TextStyle { font, path_type, width, anchor_unstated, magnification_stated } = *style;
        [font, anchor_unstated.into(), magnification_stated.into()].into_iter().for_each(|tag| self.tag(tag));
        self.list(path_type.iter(), |stream, number| stream.float(f64::from(*number)));
        self.list(width.iter(), |stream, width| stream.float(*width));
    }

    fn port(&mut self, port: &Port) {
        self.text(port.name());
        self.points(&[port.midpoint()]);
        self.float(port.width());
        self.float(port.orientation());
        self.map(port.info().iter().map(|(key, value)| (key.as_str(), value)));
    }

    fn source(&mut self, source: &Source) {
        self.text(source.generator);
        self.text(source.module);
        self.text(source.version);
        self.map(source.params.iter().map(|(key, value)| (*key, value)));
    }

    fn value(&mut self, value: &Value) {
        match value {
            Value::Null => self.tag(0),
            Value::Bool(v) => self.tag(1 + u8::from(*v)),
            Value::Int(v) => {
                self.tag(3);
                self.hasher.update(&v.to_le_bytes());
            }
            Value::Float(v) => {
                self.tag(4);
                self.float(*v);
            }
            Value::Text(text) => {
                self.tag(5);
                self.text(text);
            }
            Value::List(list) => {
                self.tag(6);
                self.list(list, Self::value);
            }
            Value::Map(map) => {
                self.tag(7);
                self.map(map.iter().map(|(key, value)| (key.as_str(), value)));
            }
            Value::Device(device) => {
                self.tag(8);
                // A device that is a parameter always enters with its whole content.
                self.hasher.update(device.content_hash().bytes());
            }
        }
    }

    fn map<'a>(&mut self, entries: impl ExactSizeIterator<Item = (&'a str, &'a Value)>) {
        self.count(entries.len());
        for (key, value) in entries {
            self.text(key);
            self.value(value);
        }
    }

    fn list<T>(&mut self, items: impl IntoIterator<Item = T>, write: impl Fn(&mut Self, T)) {
        // The end of a list needs a mark that no item can have.
        for item in items {
            self.tag(1);
            write(self, item);
        }
        self.tag(0);
    }

    fn properties(&mut self, properties: &Properties) {
        self.properties_of(properties.iter().map(|(attribute, text)| (*attribute, text.as_str())));
    }

    fn properties_of<'a>(&mut self, properties: impl Iterator<Item = (u16, &'a str)>) {
        self.list(properties, |stream, (attribute, text)| {
            stream.count(usize::from(attribute));
            stream.text(text);
        });
    }

    fn transform(&mut self, transform: &Transform) {
        self.tag(u8::from(transform.x_reflection));
        self.float(transform.magnification);
        self.float(transform.rotation);
        self.points(&[transform.origin]);
    }

    fn points(&mut self, points: &[Point]) {
        self.count(points.len());
        for p in points {
            self.float(p.x);
            self.float(p.y);
        }
    }

    fn layer(&mut self, number: u16, datatype: u16) {
        self.hasher.update(&number.to_le_bytes());
        self.hasher.update(&datatype.to_le_bytes());
    }

    fn text(&mut self, text: &str) {
        self.count(text.len());
        self.hasher.update(text.as_bytes());
    }

    fn float(&mut self, v: f64) {
        self.hasher.update(&float_key(v).to_le_bytes());
    }

    fn count(&mut self, count: usize) {
        self.hasher.update(&(count as u64).to_le_bytes());
    }

    fn tag(&mut self, tag: u8) {
        self.hasher.update(&[tag]);
    }
}

fn anchor_tag(anchor: Anchor) -> u8 {
    match anchor {
        Anchor::NorthWest => 0,
        Anchor::North => 1,
        Anchor::NorthEast => 2,
        Anchor::West => 3,
        Anchor::Center => 4,
        Anchor::East => 5,
        Anchor::SouthWest => 6,
        Anchor::South => 7,
        Anchor::SouthEast => 8,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::DeviceBuilder;

    fn cell(edit: impl FnOnce(&mut DeviceBuilder)) -> Device {
        let mut d = Device::builder("cell");
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
        d.add_port("a", ((0, 0), 1, 0)).unwrap();
        edit(&mut d);
        d.build().unwrap()
    }

    #[test]
    fn equal_cells_have_equal_hashes_and_zeros_have_no_sign() {
        let negative = cell(|d| {
            d.add(Label::new("x", (-0.0, 0), 1));
        });
        let positive = cell(|d| {
            d.add(Label::new("x", (0, 0), 1));
        });
        assert_eq!(negative.content_hash(), positive.content_hash());
        assert_eq!(negative, positive);
    }

    #[test]
    fn ports_and_info_are_content_but_not_drawing() {
        let plain = cell(|_| {});
        let port = cell(|d| {
            d.add_port("b", ((0, 0), 1, 0)).unwrap();
        });
        let info = cell(|d| {
            d.info("length", 3);
        });
        for other in [&port, &info] {
            assert_ne!(plain.content_hash(), other.content_hash());
            assert_eq!(plain.drawing_hash(), other.drawing_hash());
        }
    }

    #[test]
    fn every_element_is_part_of_the_drawing() {
        let plain = cell(|_| {});
        let others = [
            cell(|d| {
                d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
            }),
            cell(|d| {
                d.add_label("x", (0, 0), 1).unwrap();
            }),
            cell(|d| {
                let child = cell(|_| {});
                d.add(child);
            }),
            cell(|d| {
                let child = cell(|_| {});
                d.add(child.array(2, 1, (3, 0)));
            }),
        ];
        let mut hashes: Vec<Digest> = others.iter().chain([&plain]).map(Device::drawing_hash).collect();
        hashes.sort_unstable();
        hashes.dedup();
        assert_eq!(hashes.len(), 5);
    }
}
