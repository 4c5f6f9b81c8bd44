use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn shape(size: f64, layer: Layers, count: usize, inset: Option<f64>) -> Result<Device> {
    let _ = (size, layer, count, inset);
    Device::builder("x").build()
}

fn main() {
    let _ = shape("1", 1, 2, None);
    let _ = shape(1, -1, 2, None);
    let _ = shape(1, 1, 2.5, None);
    let _ = shape(1, 1, 2, "x");
}
