//! The bridge to gds21, whose object model other Rust layout tools use.
//!
//! [`to_library`] fills gds21's structs from the layout model, and [`from_library`] takes what gds21 writes through the
//! reader. gds21's own reader is not used: it panics at empty texts, and devices may have some.

use gds21::{
    GdsArrayRef, GdsBoundary, GdsDateTime, GdsDateTimes, GdsElement, GdsLibrary, GdsPoint, GdsPresentation,
    GdsProperty, GdsStrans, GdsStruct, GdsStructRef, GdsTextElem, GdsUnits, Unsupported,
};
use phidl_core::scene::Properties;

use super::element::text::presentation_of;
use super::export::welded;
use super::import::{Import, ReadOptions, read_bytes};
use super::options::{GdsOptions, units};
use crate::error::{IoError, Result};
use crate::model::{Cell, CellNames, CellTable, Content, Converter, Corner, Date, Placement, PolygonRef, Text};

/// The stream version that every reader takes.
const VERSION: i16 = 600;

/// A device, or several, with all that they place, as a library of gds21: cells, names and coordinates are those of
/// [`gds::write`](super::write()) with the same options.
///
/// # Errors
/// As for [`gds::write`](super::write()), files aside.
pub fn to_library<'a>(content: impl Into<Content<'a>>, options: &GdsOptions) -> Result<GdsLibrary> {
    let grid = options.check()?;
    let (tops, _) = welded(content.into(), &grid, options)?;
    let table = CellTable::of(Content::from(&tops), &options.naming());
    let mut converter = Converter::new(&table, options.rules(grid));
    let dates = dates(options.date);
    let mut structs = Vec::with_capacity(table.iter().len());
    for (device, name) in table.iter() {
        let mut cell = Cell::new(table.id_of(device));
        converter.convert(device, &mut cell)?;
        let elems = elements(&cell, table.names());
        structs.push(GdsStruct { name: name.to_owned(), dates: dates.clone(), elems });
    }
    let (in_user_units, in_meters) = units(&grid, options.user_unit);
    // All fields by name: the defaults of gds21 read the clock.
    Ok(GdsLibrary {
        name: options.library_name.clone(),
        version: VERSION,
        dates,
        units: GdsUnits(in_user_units, in_meters),
        structs,
        libdirsize: Unsupported,
        srfname: Unsupported,
        libsecur: Unsupported,
        reflibs: Unsupported,
        fonts: Unsupported,
        attrtable: Unsupported,
        generations: Unsupported,
        format_type: Unsupported,
    })
}

/// The devices of a library of gds21, as [`gds::read`](super::read()) makes them.
///
/// # Errors
/// [`IoError::Option`] if gds21 cannot write the library; otherwise as for [`gds::read`](super::read()), files aside.
pub fn from_library(library: &GdsLibrary, options: &ReadOptions) -> Result<Import> {
    let mut bytes = Vec::new();
    library.write(&mut bytes).map_err(|error| IoError::option("library", error, "be one that gds21 can write"))?;
    read_bytes(&bytes, options)
}

fn dates(date: Date) -> GdsDateTimes {
    let Date { year, month, day, hour, minute, second } = date;
    let [month, day, hour, minute, second] = [month, day, hour, minute, second].map(i16::from);
    let date = GdsDateTime { year, month, day, hour, minute, second };
    GdsDateTimes { modified: date.clone(), accessed: date }
}

fn elements(cell: &Cell, names: &CellNames) -> Vec<GdsElement> {
    let polygons = cell.polygons.iter().map(|polygon| boundary(&polygon).into());
    let texts = cell.texts.iter().map(|element| text(element).into());
    let references = cell.placements.iter().map(|placement| reference(placement, names));
    polygons.chain(texts).chain(references).collect()
}

fn boundary(polygon: &PolygonRef<'_>) -> GdsBoundary {
    GdsBoundary {
        layer: polygon.layer.number.cast_signed(),
        datatype: polygon.layer.datatype.cast_signed(),
        xy: polygon.corners.iter().chain(polygon.corners.first()).map(|corner| point(*corner)).collect(),
        properties: polygon.properties.map_or_else(Vec::new, properties),
        ..GdsBoundary::default()
    }
}

fn text(text: &Text) -> GdsTextElem {
    let [high, low] = presentation_of(text).unwrap_or_default().to_be_bytes();
    GdsTextElem {
        string: text.string.clone(),
        layer: text.layer.number.cast_signed(),
        texttype: text.layer.datatype.cast_signed(),
        xy: point(text.origin),
        presentation: text.anchor.map(|_| GdsPresentation(high, low)),
        path_type: text.path_type,
        width: text.width,
        strans: strans(text.x_reflection, text.magnification, text.rotation),
        properties: properties(&text.properties),
        ..GdsTextElem::default()
    }
}

fn reference(placement: &Placement, names: &CellNames) -> GdsElement {
    let Placement { origin, x_reflection, magnification, rotation, .. } = *placement;
    let name = names.name(placement.child).to_owned();
    let strans = strans(x_reflection, (magnification != 1.0).then_some(magnification), rotation);
    let properties = placement.properties.as_deref().map_or_else(Vec::new, properties);
    let Some(lattice) = placement.lattice.as_deref() else {
        return GdsStructRef { name, xy: point(origin), strans, properties, ..GdsStructRef::default() }.into();
    };
    let count = |count: u32| i16::try_from(count).expect("invariant: arrays are cut to the counts of a record");
    let end = |extent: [i64; 2]| {
        point([0, 1].map(|axis| {
            let end = i64::from(origin[axis]) + extent[axis];
            i32::try_from(end).expect("invariant: arrays are cut to the reach of a record")
        }))
    };
    GdsArrayRef {
        name,
        xy: [point(origin), end(lattice.column_extent), end(lattice.row_extent)],
        cols: count(lattice.columns),
        rows: count(lattice.rows),
        strans,
        properties,
        ..GdsArrayRef::default()
    }
    .into()
}

fn strans(reflected: bool, mag: Option<f64>, rotation: f64) -> Option<GdsStrans> {
    let angle = (rotation != 0.0).then_some(rotation);
    let stated = reflected || mag.is_some() || angle.is_some();
    stated.then(|| GdsStrans { reflected, mag, angle, ..GdsStrans::default() })
}

fn properties(properties: &Properties) -> Vec<GdsProperty> {
    let property =
        |(attribute, text): (&u16, &String)| GdsProperty { attr: attribute.cast_signed(), value: text.clone() };
    properties.iter().map(property).collect()
}

fn point(corner: Corner) -> GdsPoint {
    GdsPoint::new(corner[0], corner[1])
}

#[cfg(test)]
mod tests {
    use phidl_core::place::Movable;
    use phidl_core::scene::{Device, Label, Polygon};

    use super::*;
    use crate::gds;

    fn mask() -> Device {
        let mut d = Device::builder("dot");
        d.add(Polygon::new([(0, 0), (1, 0), (0, 1)], (40_000, 3)).with_property(7, "odd"));
        d.add_label("", (0, 0), 1).unwrap();
        let dot = d.build().unwrap();
        let mut d = Device::builder("top");
        d.add(Label::new("here", (1, 2), (5, 6)).rotated(45));
        d.add(dot.place().rotated(90).moved_by((3, 4)));
        d.add(dot.array(2, 3, (10, 20)).mirrored((0, 0), (1, 0)));
        d.build().unwrap()
    }

    #[test]
    fn a_device_comes_back_from_a_library() {
        let library = to_library(&mask(), &GdsOptions::default()).unwrap();
        assert_eq!(from_library(&library, &ReadOptions::default()).unwrap().device, mask());
    }

    #[test]
    fn the_library_is_the_file() {
        let mut bytes = Vec::new();
        to_library(&mask(), &GdsOptions::default()).unwrap().write(&mut bytes).unwrap();
        assert!(bytes == gds::to_bytes(&mask(), &GdsOptions::default()).unwrap());
    }
}
