//! Shapes stay whole: rounding to a grid neither parts what touches nor joins what is separate.
//!
//! Every shape is drawn with lengths off the grid, placed at odd positions in all multiples of 90°, and rounded to 1 nm and
//! 5 nm in both manners that exist: point by point after flattening, and cell by cell by the GDSII writer. The number of
//! merged islands on each layer, counted by a second engine, must be that of the drawing.

use std::collections::BTreeMap;

use clipper2_rust::{FillRule, Path64, Paths64, Point64, area, union_subjects_64};
use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_core::runtime::GeneratorInfo;
use phidl_geometry as pg;
use phidl_io::gds::{self, GdsOptions, ReadOptions};

/// Grids to round to (µm).
const GRIDS: [f64; 2] = [0.001, 0.005];
/// Grid of the drawing before rounding (µm): fine, but coarser than floating-point noise.
const FINE: f64 = 1e-6;
/// Factors on all lengths of an example, which move its corners off the grid.
const FACTORS: [f64; 3] = [1.0, 0.91373, 1.08419];
/// Positions and turns of the placed cell.
const PLACEMENTS: [((f64, f64), f64); 4] =
    [((0.0, 0.0), 0.0), ((12.3456, -7.8915), 90.0), ((-103.4004, 55.5555), 180.0), ((0.0625, 1000.4999), 270.0)];

/// Number of grid steps, halves away from zero, without floating-point noise.
#[expect(clippy::cast_possible_truncation, reason = "drawings are smaller than a meter")]
fn steps(length: f64, grid: f64) -> i64 {
    let noise = f64::from(1 << 20);
    ((length / grid * noise).round() / noise).round() as i64
}

/// Number of connected areas on each layer after rounding every corner.
fn islands(device: &Device, grid: f64) -> BTreeMap<Layer, usize> {
    let mut layers: BTreeMap<Layer, Paths64> = BTreeMap::new();
    for polygon in device.flat_polygons() {
        let mut path: Path64 = polygon.points().map(|p| Point64::new(steps(p.x, grid), steps(p.y, grid))).collect();
        if area(&path) < 0.0 {
            path.reverse();
        }
        layers.entry(polygon.layer.expect("a drawn polygon")).or_default().push(path);
    }
    let count = |paths: &Paths64| union_subjects_64(paths, FillRule::NonZero).iter().filter(|p| area(p) > 0.0).count();
    layers.into_iter().map(|(layer, paths)| (layer, count(&paths))).collect()
}

/// A cell alone in a top cell, at a position and an angle.
fn placed(device: &Device, (position, angle): ((f64, f64), f64)) -> Device {
    let mut top = Device::builder("top");
    top.add(device.place().rotated(angle).moved_by(position));
    top.build().unwrap()
}

fn written_and_read(device: &Device, grid: f64) -> Device {
    let bytes = gds::to_bytes(device, &GdsOptions { grid, allow_empty: true, ..GdsOptions::default() }).unwrap();
    gds::read_bytes(&bytes, &ReadOptions::default()).unwrap().device
}

/// The island counts of a shape are those of the drawing, however it is placed and rounded.
fn stays_whole(name: &str, device: &Device) -> Result<(), String> {
    let drawn = islands(device, FINE);
    for grid in GRIDS {
        for placement in PLACEMENTS {
            let top = placed(device, placement);
            for (manner, device) in [("flat", &top), ("in a file", &written_and_read(&top, grid))] {
                let islands = islands(device, grid);
                if islands != drawn {
                    return Err(format!("{name}, {manner}, at {placement:?} on {grid} µm: {islands:?}, not {drawn:?}"));
                }
            }
        }
    }
    Ok(())
}

/// The example of a shape with all its lengths multiplied.
fn scaled_example(entry: &'static GeneratorInfo, factor: f64) -> Option<Device> {
    let mut params = entry.example().unwrap().by_name();
    for param in entry.params().into_iter().filter(|param| param.unit == Some("um")) {
        if let Some(value) = params.get_mut(param.name) {
            *value = scaled(value, factor);
        }
    }
    entry.build(&params).ok()
}

fn scaled(value: &Value, factor: f64) -> Value {
    match value {
        Value::Float(v) => (v * factor).into(),
        #[expect(clippy::cast_precision_loss, reason = "lengths of examples are small")]
        Value::Int(v) => (*v as f64 * factor).into(),
        Value::List(list) => list.iter().map(|value| scaled(value, factor)).collect::<Vec<_>>().into(),
        other => other.clone(),
    }
}

#[test]
fn no_grid_parts_or_joins_what_a_shape_draws() {
    let mut failures = Vec::new();
    for entry in registry::all().filter(|entry| entry.module.starts_with("phidl_geometry")) {
        for factor in FACTORS {
            // Not every relation of lengths survives a factor where a length is a constant of the shape.
            let Some(device) = scaled_example(entry, factor) else { continue };
            failures.extend(stays_whole(&format!("{} × {factor}", entry.name), &device).err());
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// A period of 0.63 µm puts the corners of the teeth at half nanometers.
#[test]
fn a_grating_with_corners_at_half_steps_is_whole() {
    for fill_factor in [0.5, 0.37, 1.0] {
        let d = pg::GratingParams::default().period(0.63).fill_factor(fill_factor).build().unwrap();
        let islands = islands(&d, FINE)[&0.into()];
        assert_eq!(islands, if fill_factor == 1.0 { 1 } else { 20 }, "the last tooth and the taper are one");
        stays_whole("grating", &d).unwrap();
    }
}

/// A mesh of frames, and a full layer, are one island: neighboring cells share their corners.
#[test]
fn a_fill_without_gaps_is_one_island() {
    let pad = pg::rectangle((10, 10), 9).unwrap();
    let fill = pg::FillRectangleParams::new(pad).fill_size((0.63, 1.1137)).margin(0.5).bbox([(-5, -5), (15, 15)]);
    for (density, inverted) in [(1.0, false), (0.4, true)] {
        let fill = fill.clone().fill_layers(1).fill_densities(density).fill_inverted(inverted).build().unwrap();
        assert_eq!(islands(&fill, FINE)[&1.into()], 1);
        stays_whole("fill_rectangle", &fill).unwrap();
    }
}
