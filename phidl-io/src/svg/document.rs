//! The picture: definitions of cells, then one group per layer.

use std::collections::BTreeMap;
use std::fmt::Write;

use phidl_core::geom::{Point, Rect, Transform, signed_area};
use phidl_core::layer::Layer;
use phidl_core::place::Bounded;
use phidl_core::scene::{Anchor, Device, Label, PolygonView, Reference};

use super::SvgOptions;
use super::array::{Thing, place, row};
use super::looks::looks;
use super::number::{escaped, length, placement, push_point};
use crate::model::{DistinctCells, MergeCells};

/// Labels are this part of the picture's longer side high.
const LABEL_PART: f64 = 1.0 / 50.0;

/// What lies over each other in the picture: the layers, then the labels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Plane {
    Layer(Layer),
    Labels,
}

/// Draws a device.
pub(super) fn draw(device: &Device, options: &SvgOptions) -> String {
    let nothing = Rect { min: Point::ORIGIN, max: Point::ORIGIN };
    let frame = device.bbox().unwrap_or(nothing);
    let cells = DistinctCells::of(std::slice::from_ref(device), MergeCells::EqualDrawings);
    let mut picture = Picture { planes: planes(&cells), cells: &cells, defs: String::new() };
    let groups = picture.groups(options);
    let size = frame.size();
    let (width, height) = (size.width * options.scale, size.height * options.scale);
    let letters = options.label_height.unwrap_or(size.width.max(size.height) * LABEL_PART);
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{w}\" height=\"{h}\" \
         viewBox=\"0 0 {w} {h}\" fill-rule=\"nonzero\" font-family=\"sans-serif\" font-size=\"{letters}\">\n\
         <title>{title}</title>\n<defs>\n{defs}</defs>\n\
         <g transform=\"scale({scale}) translate({x} {y}) scale(1 -1)\">\n{groups}</g>\n</svg>\n",
        w = length(width),
        h = length(height),
        letters = length(letters),
        title = escaped(device.name()),
        defs = picture.defs,
        scale = options.scale,
        x = length(-frame.min.x),
        y = length(frame.max.y),
    )
}

/// What a cell shows on one plane.
#[derive(Default)]
struct Shown<'a> {
    polygons: Vec<PolygonView<'a>>,
    /// Indices of the references whose cells show something on the plane.
    references: Vec<usize>,
}

/// For each cell, the planes on which it or a cell below it shows something.
fn planes(cells: &DistinctCells) -> Vec<BTreeMap<Plane, Shown<'_>>> {
    let mut planes: Vec<BTreeMap<Plane, Shown<'_>>> = Vec::new();
    for cell in cells.as_slice() {
        let mut own: BTreeMap<Plane, Shown<'_>> = BTreeMap::new();
        for polygon in cell.polygons() {
            own.entry(Plane::Layer(polygon.layer)).or_default().polygons.push(polygon);
        }
        if !cell.labels().is_empty() {
            own.entry(Plane::Labels).or_default();
        }
        for (index, reference) in cell.references().iter().enumerate() {
            for plane in planes[cells.index_of(reference.device())].keys() {
                own.entry(*plane).or_default().references.push(index);
            }
        }
        planes.push(own);
    }
    planes
}

struct Picture<'a> {
    cells: &'a DistinctCells,
    planes: Vec<BTreeMap<Plane, Shown<'a>>>,
    defs: String,
}

impl Picture<'_> {
    /// One group for each plane of the top cell; the cells below are defined before. Each element of each cell is visited
    /// once for each plane that it is on, however many cells and planes there are.
    fn groups(&mut self, options: &SvgOptions) -> String {
        let mut groups = String::new();
        let top = self.planes.len() - 1;
        let mut cells_on: BTreeMap<Plane, Vec<usize>> = BTreeMap::new();
        for (cell, planes) in self.planes[..top].iter().enumerate() {
            planes.keys().for_each(|plane| cells_on.entry(*plane).or_default().push(cell));
        }
        let planes: Vec<Plane> = self.planes[top].keys().copied().collect();
        for (number, plane) in planes.into_iter().enumerate() {
            for cell in cells_on.remove(&plane).unwrap_or_default() {
                let content = self.content(cell, plane, number);
                push_line(&mut self.defs, &format!("<g id=\"{}\">{content}</g>", id(cell, number)));
            }
            let content = self.content(top, plane, number);
            push_line(&mut groups, &format!("<g {}>{content}</g>", group_looks(plane, options)));
        }
        groups
    }

    /// What a cell shows on a plane: its own outlines or labels, then what it places.
    fn content(&mut self, cell: usize, plane: Plane, number: usize) -> String {
        let device = &self.cells.as_slice()[cell];
        let Some(shown) = self.planes[cell].get(&plane) else { return String::new() };
        let mut content = match plane {
            Plane::Layer(_) => path(shown.polygons.iter().copied()),
            Plane::Labels => device.labels().iter().map(text).collect(),
        };
        for index in &shown.references {
            let reference = &device.references()[*index];
            let child = self.cells.index_of(reference.device());
            let name = format!("{}r{index}", id(cell, number));
            content.push_str(&placed(reference, id(child, number), &name, &mut self.defs));
        }
        content
    }
}

/// The name of the definition of a cell on a plane.
fn id(cell: usize, plane: usize) -> String {
    format!("c{cell}p{plane}")
}

/// A reference to a definition; of an array, all elements.
fn placed(reference: &Reference, id: String, name: &str, defs: &mut String) -> String {
    let transform = *reference.transform();
    let Some(array) = reference.array() else {
        return place(&Thing { id, transform }, Point::ORIGIN);
    };
    // Steps are turned and mirrored with the array, but not magnified: only the element is, inside.
    let element = Thing { id, transform: Transform::scaling(transform.magnification) };
    let column = row(&element, array.row_step, array.rows, &format!("{name}r"), defs);
    push_line(defs, &format!("<g id=\"{name}\">{column}</g>"));
    let column = Thing { id: name.to_owned(), transform: Transform::IDENTITY };
    let columns = row(&column, array.column_step, array.columns, &format!("{name}c"), defs);
    format!("<g{}>{columns}</g>", placement(&Transform { magnification: 1.0, ..transform }))
}

/// All outlines as one path.
fn path<'a>(polygons: impl Iterator<Item = PolygonView<'a>>) -> String {
    let mut data = String::new();
    for polygon in polygons {
        let reversed = signed_area(polygon.points) < 0.0;
        let count = polygon.points.len();
        for i in 0..count {
            data.push_str(match i {
                0 => "M",
                1 => "L",
                _ => " ",
            });
            push_point(&mut data, polygon.points[if reversed { count - 1 - i } else { i }]);
        }
        data.push('Z');
    }
    if data.is_empty() { data } else { format!("<path d=\"{data}\"/>") }
}

/// A label. The picture is upside down where y is up, so its letters are turned over once more.
fn text(label: &Label) -> String {
    let transform = Transform { x_reflection: !label.transform().x_reflection, ..*label.transform() };
    let (across, up) = anchors(label.anchor);
    format!(
        "<text{} text-anchor=\"{across}\" dominant-baseline=\"{up}\">{}</text>",
        placement(&transform),
        lines(&label.text, up)
    )
}

/// The text of a label, each of several lines in an element of its own: SVG takes a line end for a space.
fn lines(text: &str, up: &str) -> String {
    /// From one line to the next, in heights of letters.
    const PITCH: f64 = 1.2;
    let below = text.matches('\n').count() as f64;
    if below == 0.0 {
        return escaped(text);
    }
    let raised = match up {
        "text-before-edge" => 0.0,
        "central" => below / 2.0,
        _ => below,
    };
    let line = |(i, line): (usize, &str)| {
        let step = if i == 0 { -raised * PITCH } else { PITCH };
        format!("<tspan x=\"0\" dy=\"{}em\">{}</tspan>", length(step), escaped(line))
    };
    text.split('\n').enumerate().map(line).collect()
}

fn anchors(anchor: Anchor) -> (&'static str, &'static str) {
    let across = match anchor {
        Anchor::NorthWest | Anchor::West | Anchor::SouthWest => "start",
        Anchor::North | Anchor::Center | Anchor::South => "middle",
        Anchor::NorthEast | Anchor::East | Anchor::SouthEast => "end",
    };
    let up = match anchor {
        Anchor::NorthWest | Anchor::North | Anchor::NorthEast => "text-before-edge",
        Anchor::West | Anchor::Center | Anchor::East => "central",
        Anchor::SouthWest | Anchor::South | Anchor::SouthEast => "text-after-edge",
    };
    (across, up)
}

/// Name, color and opacity of a plane's group.
fn group_looks(plane: Plane, options: &SvgOptions) -> String {
    let Plane::Layer(layer) = plane else { return "id=\"labels\"".to_owned() };
    let (color, alpha) = looks(layer, &options.layers);
    let Layer { number, datatype } = layer;
    format!("id=\"layer{number:03}_datatype{datatype:03}\" fill=\"{color}\" opacity=\"{alpha}\"")
}

fn push_line(text: &mut String, line: &str) {
    // Writing into a String cannot fail.
    let _ = writeln!(text, "{line}");
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use phidl_core::layer::{LayerSet, NamedLayer};
    use phidl_core::place::Movable;

    use super::*;

    /// Clockwise, with a keyhole: the outer square, then the inner one the other way round.
    fn frame() -> Device {
        let mut d = Device::builder("frame");
        let outer = [(0, 0), (0, 4), (4, 4), (4, 0), (0, 0)];
        let inner = [(1, 1), (3, 1), (3, 3), (1, 3), (1, 1)];
        d.add_polygon(outer.into_iter().chain(inner).collect::<Vec<_>>(), 3).unwrap();
        d.build().unwrap()
    }

    #[test]
    fn a_small_chip_is_drawn_like_this() {
        let mut d = Device::builder("chip <1>");
        d.add_polygon([(0, 0), (20, 0), (20, 10), (0, 10)], (1, 2)).unwrap();
        d.add(frame().place().rotated(90).moved_by((5, 1)));
        d.add(frame().array(3, 1, (5, 5)).moved_by((6, 1)));
        d.add_label("a & b", (2, 3), 10).unwrap();
        let mut layers = LayerSet::new();
        layers.add(NamedLayer::new("au", 3).color("gold".parse().unwrap())).unwrap();
        let options = SvgOptions { layers, scale: 2.0, label_height: Some(1.0) };
        expect![[r##"
            <?xml version="1.0" encoding="UTF-8"?>
            <svg xmlns="http://www.w3.org/2000/svg" version="1.1" width="40" height="20" viewBox="0 0 40 20" fill-rule="nonzero" font-family="sans-serif" font-size="1">
            <title>chip &lt;1&gt;</title>
            <defs>
            <g id="c0p1"><path d="M1 1L1 3 3 3 3 1 1 1 0 0 4 0 4 4 0 4 0 0Z"/></g>
            <g id="c1p1r1"><use href="#c0p1"/></g>
            <g id="c1p1r1cx2"><use href="#c1p1r1"/><use href="#c1p1r1" transform="translate(5 0)"/></g>
            </defs>
            <g transform="scale(2) translate(0 10) scale(1 -1)">
            <g id="layer001_datatype002" fill="#2b0fff" opacity="0.6"><path d="M0 0L20 0 20 10 0 10Z"/></g>
            <g id="layer003_datatype000" fill="#ffd700" opacity="0.6"><use href="#c0p1" transform="translate(5 1) rotate(90)"/><g transform="translate(6 1)"><use href="#c1p1r1"/><use href="#c1p1r1cx2" transform="translate(5 0)"/></g></g>
            <g id="labels"><text transform="translate(2 3) scale(1 -1)" text-anchor="middle" dominant-baseline="central">a &amp; b</text></g>
            </g>
            </svg>
        "##]]
        .assert_eq(&draw(&d.build().unwrap(), &options));
    }

    #[test]
    fn lines_of_a_label_stand_one_below_the_other_around_its_anchor() {
        let (first, second) = ("<tspan x=\"0\" dy=\"", "<tspan x=\"0\" dy=\"1.2em\">b &lt;</tspan>");
        for (up, raised) in [("text-before-edge", "0"), ("central", "-0.6"), ("text-after-edge", "-1.2")] {
            assert_eq!(lines("a\nb <", up), format!("{first}{raised}em\">a</tspan>{second}"));
        }
        assert_eq!(lines("a & b", "central"), "a &amp; b");
    }

    #[test]
    fn an_empty_device_is_a_picture_of_no_size() {
        let picture = draw(&Device::builder("nothing").build().unwrap(), &SvgOptions::default());
        assert!(picture.contains("width=\"0\" height=\"0\" viewBox=\"0 0 0 0\""), "{picture}");
    }

    #[test]
    fn huge_arrays_are_small_pictures() {
        let mut d = Device::builder("field");
        d.add(frame().array(100_000, 100_000, (5, 5)));
        d.add(frame().array(u32::MAX, 1, (5, 5)));
        assert!(draw(&d.build().unwrap(), &SvgOptions::default()).len() < 20_000);
    }
}
