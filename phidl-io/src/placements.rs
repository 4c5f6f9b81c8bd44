//! A flat table of placements: where each device is on the mask.
//!
//! ```text
//! cell,device,level,x,y,rotation,magnification,mirrored,parameters
//! ring_radius12,ring,1,100,-250,90,1,false,"{""radius"":12.0}"
//! ```
//!
//! Positions are those of the cells' origins in the coordinates of the top cell (µm), elements of arrays included. The
//! levels of the hierarchy are listed from the top as far as the rows fit; a level is listed whole or not at all.

use std::fmt::Write;

use indexmap::IndexMap;
use phidl_core::geom::Transform;
use phidl_core::scene::Device;

use crate::error::Result;
use crate::gds::GdsOptions;
use crate::json::parameters;
use crate::model::CellTable;

/// The most rows of a table.
const MOST_ROWS: u64 = 100_000;

/// The table of a device, as CSV text. Cells are named as [`gds::write`](crate::gds::write()) names them.
///
/// # Errors
/// [`IoError::Option`](crate::IoError::Option) as for writing.
pub(crate) fn csv(top: &Device, options: &GdsOptions) -> Result<String> {
    options.check()?;
    let table = CellTable::of(top.into(), &options.naming());
    let mut text = "cell,device,level,x,y,rotation,magnification,mirrored,parameters\n".to_owned();
    let levels = listed_levels(top);
    let mut open = Vec::from_iter((levels > 0).then(|| children(top, Transform::IDENTITY)));
    while let Some(siblings) = open.last_mut() {
        match siblings.next() {
            None => {
                open.pop();
            }
            Some((device, transform)) => {
                row(device, &transform, open.len(), &table, &mut text);
                if open.len() < levels {
                    open.push(children(device, transform));
                }
            }
        }
    }
    Ok(text)
}

/// The cells that a cell places, with their placements in the coordinates of the top cell.
fn children(device: &Device, at: Transform) -> Box<dyn Iterator<Item = (&Device, Transform)> + '_> {
    Box::new(
        device.references().iter().flat_map(move |reference| {
            reference.elements().map(move |element| (reference.device(), element.then(&at)))
        }),
    )
}

/// How many levels below the top cell fit the table, counted without a walk.
fn listed_levels(top: &Device) -> usize {
    let mut level: IndexMap<usize, (&Device, u64)> = IndexMap::from([(top.ptr_id(), (top, 1))]);
    let mut rows = 0_u64;
    for levels in 0.. {
        let mut next: IndexMap<usize, (&Device, u64)> = IndexMap::new();
        for (device, count) in level.values() {
            for reference in device.references() {
                let placed = count.saturating_mul(reference.count() as u64);
                rows = rows.saturating_add(placed);
                let child = next.entry(reference.device().ptr_id()).or_insert((reference.device(), 0));
                child.1 = child.1.saturating_add(placed);
            }
        }
        if next.is_empty() || rows > MOST_ROWS {
            return levels;
        }
        level = next;
    }
    0
}

fn row(device: &Device, at: &Transform, level: usize, table: &CellTable, text: &mut String) {
    let (cell, name) = (quoted(table.name_of(device)), quoted(device.name()));
    let parameters = device.source().map_or_else(String::new, |source| quoted(&parameters(source)));
    let Transform { x_reflection: mirrored, magnification, rotation, origin } = *at;
    let [x, y] = [origin.x, origin.y].map(|v| if v == 0.0 { 0.0 } else { v });
    // Writing into a String cannot fail.
    let _ = writeln!(text, "{cell},{name},{level},{x},{y},{rotation},{magnification},{mirrored},{parameters}");
}

/// A field of a CSV table: in quotes if it has separators, quotes or line ends.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use phidl_core::place::Movable;

    use super::*;

    #[test]
    fn every_element_of_every_array_is_a_row_until_the_table_is_full() {
        let mut d = Device::builder("dot, small");
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
        let dot = d.build().unwrap();
        let mut d = Device::builder("pair");
        d.add(dot.array(2, 1, (5, 5)));
        let pair = d.build().unwrap();
        let mut d = Device::builder("top");
        d.add(pair.place().rotated(90).moved_by((10, 0)));
        expect![[r#"
            cell,device,level,x,y,rotation,magnification,mirrored,parameters
            pair,pair,1,10,0,90,1,false,
            "dot, small","dot, small",2,10,0,90,1,false,
            "dot, small","dot, small",2,10,5,90,1,false,
        "#]]
        .assert_eq(&csv(&d.build().unwrap(), &GdsOptions::default()).unwrap());

        let mut d = Device::builder("full");
        d.add(pair.array(1000, 60, (10, 10)));
        assert_eq!(csv(&d.build().unwrap(), &GdsOptions::default()).unwrap().lines().count(), 1 + 60_000);
    }
}
