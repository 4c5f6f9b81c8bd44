//! What a mask file does not say: generators, parameters, info and ports of its cells.

use phidl_core::geom::Transform;
use phidl_core::place::Bounded;
use phidl_core::scene::{Device, Reference};
use serde_json::map::Entry;
use serde_json::{Map, Value, json};

use super::describe::{corners, port};
use super::value::{map, params, point};
use crate::error::Result;
use crate::gds::GdsOptions;
use crate::model::{CellTable, DistinctCells, MergeCells};

/// Everything about the cells of a file that the file cannot hold: for each, under its name in the file, the device's
/// name, generator, parameters, info, box, ports, and what it places where.
///
/// The names are those that [`gds::write`](crate::gds::write()) gives with the same options. If these make cells one that
/// are drawn alike and differ in ports or info, the records of the others are in the list `twins` of the first.
///
/// # Errors
/// [`IoError::Option`](crate::IoError::Option) as for writing.
pub fn metadata(device: &Device, options: &GdsOptions) -> Result<Value> {
    options.check()?;
    let table = CellTable::of(device.into(), &options.naming());
    let contents = DistinctCells::of(std::slice::from_ref(device), MergeCells::EqualContent);
    let mut cells: Map<String, Value> = Map::new();
    for content in contents.as_slice() {
        let record = cell(content, &table);
        match cells.entry(table.name_of(content)) {
            Entry::Vacant(entry) => {
                entry.insert(record);
            }
            Entry::Occupied(mut entry) => match &mut entry.get_mut()["twins"] {
                Value::Array(twins) => twins.push(record),
                twins => *twins = json!([record]),
            },
        }
    }
    Ok(json!({ "top": table.name_of(device), "cells": cells }))
}

fn cell(cell: &Device, table: &CellTable) -> Value {
    let source = cell.source().map(|source| {
        json!({
            "generator": source.generator,
            "module": source.module,
            "version": source.version,
            "params": params(source),
        })
    });
    json!({
        "name": cell.name(),
        "source": source,
        "info": map(cell.info()),
        "bbox": cell.bbox().map(corners),
        "ports": cell.ports().map(|p| (p.name().to_owned(), port(p))).collect::<Map<_, _>>(),
        "instances": cell.references().iter().map(|r| instance(r, table)).collect::<Value>(),
    })
}

fn instance(reference: &Reference, table: &CellTable) -> Value {
    let Transform { x_reflection, magnification, rotation, origin } = *reference.transform();
    let mut placed = json!({
        "cell": table.name_of(reference.device()),
        "origin": point(origin),
        "rotation": rotation,
        "magnification": magnification,
        "x_reflection": x_reflection,
    });
    if let Some(array) = reference.array() {
        placed["array"] = json!({
            "columns": array.columns,
            "rows": array.rows,
            "column_step": point(array.column_step),
            "row_step": point(array.row_step),
        });
    }
    placed
}

#[cfg(test)]
mod tests {
    use phidl_core::place::Movable;

    use super::*;

    #[test]
    fn cells_are_found_under_their_names_in_the_file() {
        let mut d = Device::builder("a dot");
        d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
        d.add_port("e", ((1, 0), 0.5, 0)).unwrap();
        d.info("length", 0.1);
        let dot = d.build().unwrap();
        let mut d = Device::builder("top");
        d.add(dot.array(3, 2, (5, 6)).rotated(90).moved_by((1, 2)));
        let top = d.build().unwrap();

        let data = metadata(&top, &GdsOptions { top_name: Some("mask".into()), ..GdsOptions::default() }).unwrap();
        assert_eq!(data["top"], "mask");
        assert_eq!(data["cells"]["a dot"]["name"], "a dot");
        assert_eq!(data["cells"]["a dot"]["info"]["length"], 0.1);
        assert_eq!(data["cells"]["a dot"]["source"], Value::Null);
        let placed = &data["cells"]["mask"]["instances"][0];
        assert_eq!((&placed["cell"], &placed["rotation"]), (&json!("a dot"), &json!(90.0)));
        assert_eq!(placed["array"]["column_step"], json!([5.0, 0.0]));
    }

    /// Two cells of one drawing, with an info of their own each.
    fn twins() -> Device {
        let mut top = Device::builder("top");
        for (name, length) in [("a", 1.0), ("b", 2.0)] {
            let mut d = Device::builder(name);
            d.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
            d.add_port(name, ((1, 0), 0.5, 0)).unwrap();
            d.info("length", length);
            top.add(d.build().unwrap());
        }
        top.build().unwrap()
    }

    #[test]
    fn cells_that_are_drawn_alike_keep_their_records() {
        let data = metadata(&twins(), &GdsOptions::default()).unwrap();
        for (index, (name, length)) in [("a", 1.0), ("b", 2.0)].into_iter().enumerate() {
            assert_eq!(
                (&data["cells"][name]["name"], &data["cells"][name]["info"]["length"]),
                (&json!(name), &json!(length))
            );
            assert_eq!(data["cells"][name]["ports"][name]["width"], 0.5);
            assert_eq!(data["cells"]["top"]["instances"][index]["cell"], name);
        }
        let merged = GdsOptions { merge_cells: MergeCells::EqualDrawings, ..GdsOptions::default() };
        let data = metadata(&twins(), &merged).unwrap();
        assert_eq!(data["cells"]["a"]["info"]["length"], 1.0);
        assert_eq!(data["cells"]["a"]["twins"][0]["info"]["length"], 2.0);
    }
}
