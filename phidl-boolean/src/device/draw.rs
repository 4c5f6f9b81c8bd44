//! Runs an operation on two operands and draws the result, flat or with its hierarchy.

use phidl_core::layer::{Layer, Layers};
use phidl_core::scene::{Device, DeviceBuilder};

use super::{
    hierarchy,
    operand::Operand,
    operation::DeviceOperation,
    options::{Hierarchy, Options},
};
use crate::error::BooleanError;

/// A device with the result of an operation on all shapes of two operands.
pub(super) fn drawn(
    name: &str,
    operation: DeviceOperation,
    operands: &[Operand; 2],
    layers: &Layers,
    options: &Options,
) -> Result<Device, BooleanError> {
    let mut cell = Device::builder(name);
    draw(&mut cell, operation, operands, layers, options)?;
    Ok(cell.build()?)
}

/// A device with the result of an operation on each layer of two operands.
pub(super) fn drawn_by_layer(
    name: &str,
    operation: DeviceOperation,
    [a, b]: &[Operand; 2],
    options: &Options,
) -> Result<Device, BooleanError> {
    let mut layers: Vec<Layer> = [a.layers(), b.layers()].concat();
    layers.sort_unstable();
    layers.dedup();
    let mut cell = Device::builder(name);
    for layer in layers {
        match options.hierarchy {
            Hierarchy::Flatten => {
                let grid = options.grid()?;
                a.check_size(&options.run)?;
                b.check_size(&options.run)?;
                let contours = [a.contours_on(&grid, layer)?, b.contours_on(&grid, layer)?];
                operation.region(&contours, &grid, &options.run)?.draw(&mut cell, &layer.into(), options)?;
            }
            Hierarchy::Keep => {
                let on_layer = [a.on_layer(layer)?, b.on_layer(layer)?];
                hierarchy::draw(&mut cell, operation, &on_layer, &layer.into(), options)?;
            }
        }
    }
    Ok(cell.build()?)
}

/// Draws the result of an operation on all shapes of two operands into an open cell.
pub(super) fn draw(
    cell: &mut DeviceBuilder,
    operation: DeviceOperation,
    operands: &[Operand; 2],
    layers: &Layers,
    options: &Options,
) -> Result<(), BooleanError> {
    match options.hierarchy {
        Hierarchy::Flatten => {
            let grid = options.grid()?;
            let [a, b] = operands;
            a.check_size(&options.run)?;
            b.check_size(&options.run)?;
            let contours = [a.contours(&grid)?, b.contours(&grid)?];
            operation.region(&contours, &grid, &options.run)?.draw(cell, layers, options)
        }
        Hierarchy::Keep => hierarchy::draw(cell, operation, operands, layers, options),
    }
}
