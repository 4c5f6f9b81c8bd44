//! [`extract`] and [`copy_layer`]: what is drawn on some layers, in one flat cell.

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::arguments::LayerList;
use crate::test_structure::TestIcParams;

/// Collects what is drawn on some layers, the whole hierarchy down, in one cell without references.
///
/// The polygons are grouped by layer, in the order in which the layers first occur. Labels, ports, info and properties
/// stay behind. The part of one placement is drawn where it stands by `extract(placement.to_device()?, layers)`.
///
/// # Ports
/// None.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let mut d = Device::builder("stack");
/// d.add(pg::ring(10, 1, 2.5, [1, 2])?);
/// d.add(pg::rectangle((4, 2), 3)?);
/// assert_eq!(pg::extract(d.build()?, [1, 3])?.layers(), [Layer::new(1, 0), Layer::new(3, 0)]);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `extract`.
#[device(picture = "docs/extract.svg", example = ExtractParams::new(TestIcParams::default().build()?))]
pub fn extract(
    /// What is looked through.
    #[param(name = "D")]
    device: Device,
    /// The layers that are kept.
    #[default([0, 1])]
    layers: LayerList,
) -> Result<Device> {
    let mut d = Device::builder("extract");
    check_size(check, &device)?;
    let mut order: Vec<Layer> = Vec::new();
    for layer in device.flat_polygons().on(&layers.0).filter_map(|polygon| polygon.layer) {
        if !order.contains(&layer) {
            order.push(layer);
        }
    }
    for layer in order {
        collect(&device, layer, layer, &mut d)?;
    }
    d.build()
}

/// Draws what is on one layer on another one, the whole hierarchy down, in one cell without references.
///
/// The result holds the copy alone: place it together with the original where both are wanted. Labels, ports, info and
/// properties stay behind.
///
/// # Ports
/// None.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let ring = pg::ring(10, 1, 2.5, 1)?;
/// let mut d = Device::builder("both");
/// d.add(&ring);
/// d.add(pg::copy_layer(&ring, 1, (2, 5))?);
/// assert_eq!(d.build()?.layers().len(), 2);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `copy_layer`.
#[device(picture = "docs/copy_layer.svg", example = CopyLayerParams::new(TestIcParams::default().build()?).new_layer(3))]
pub fn copy_layer(
    /// What is copied from.
    #[param(name = "D")]
    device: Device,
    /// The layer that is copied.
    #[default(1)]
    layer: Layer,
    /// The layer of the copy.
    #[default(2)]
    new_layer: Layer,
) -> Result<Device> {
    let mut d = Device::builder("extract");
    collect(&device, layer, new_layer, &mut d)?;
    d.build()
}

/// Refuses hierarchies that are too large to be drawn flat.
fn check_size(check: Check<'_>, device: &Device) -> Result<()> {
    const MOST_POINTS: usize = 1_000_000_000;
    check.at_most("number of points of D, drawn flat", device.flat_counts()?.1, MOST_POINTS)
}

fn collect(device: &Device, from: Layer, to: Layer, into: &mut DeviceBuilder) -> Result<()> {
    for polygon in device.flat_polygons().on(from) {
        into.add_polygon(polygon.points().collect::<Vec<_>>(), to)?;
    }
    Ok(())
}
