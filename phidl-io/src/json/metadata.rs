//! [`metadata`]: what every cell of a file is, who drew it, and what it places.

use phidl_core::geom::Transform;
use phidl_core::place::Bounded;
use phidl_core::scene::{Device, Reference};
use serde_json::{Map, Value as Json, json as object};

use super::describe::{corners, describe_port, pair};
use super::json;
use crate::error::Result;
use crate::gds::{self, GdsOptions};

/// Every cell of the file that these options give, by its name in the file: generator and parameters, info, ports, box,
/// and instances in order. The top cell is `"top"`.
///
/// ```text
/// {"top": name,
///  "cells": {name: {"device": name in the program,
///                   "generator": {"name", "module", "version", "params": {…}} or null,
///                   "info": {…}, "ports": {…}, "bbox": [[x0, y0], [x1, y1]] or null, "polygons": n,
///                   "instances": [{"cell", "alias", "origin", "rotation", "magnification", "x_reflection", "array"}]}}}
/// ```
///
/// # Errors
/// An option that breaks its rule.
pub fn metadata(top: &Device, options: &GdsOptions) -> Result<Json> {
    let names = gds::cell_names(top, options)?;
    let cells: Map<String, Json> =
        names.cells().map(|(device, name)| (name.to_owned(), cell(device, &|child| names.name_of(child)))).collect();
    Ok(object!({ "top": names.name_of(top), "cells": cells }))
}

fn cell<'a>(device: &Device, name_of: &impl Fn(&Device) -> &'a str) -> Json {
    let ports: Map<String, Json> =
        device.ports().map(|port| (port.name().to_owned(), describe_port(port))).collect();
    let info: Map<String, Json> = device.info().iter().map(|(key, value)| (key.clone(), json(value))).collect();
    let alias_of = |reference: &Reference| {
        device.aliases().find(|(_, named)| std::ptr::eq(*named, reference)).map(|(alias, _)| alias.to_owned())
    };
    let instances: Vec<Json> = device
        .references()
        .iter()
        .map(|reference| instance(reference, name_of(reference.device()), alias_of(reference)))
        .collect();
    object!({
        "device": device.name(),
        "generator": generator(device),
        "info": info,
        "ports": ports,
        "bbox": device.bbox().map(corners),
        "polygons": device.polygons().len(),
        "instances": instances,
    })
}

fn generator(device: &Device) -> Json {
    let Some(source) = device.source() else { return Json::Null };
    let params: Map<String, Json> =
        source.params.iter().map(|(name, value)| ((*name).to_owned(), json(value))).collect();
    object!({"name": source.generator, "module": source.module, "version": source.version, "params": params})
}

fn instance(reference: &Reference, cell: &str, alias: Option<String>) -> Json {
    let Transform { x_reflection, magnification, rotation, origin } = *reference.transform();
    let array = reference.array().map(|array| {
        object!({
            "columns": array.columns,
            "rows": array.rows,
            "column_step": pair(array.column_step),
            "row_step": pair(array.row_step),
        })
    });
    object!({
        "cell": cell,
        "alias": alias,
        "origin": pair(origin),
        "rotation": rotation,
        "magnification": magnification,
        "x_reflection": x_reflection,
        "array": array,
    })
}
