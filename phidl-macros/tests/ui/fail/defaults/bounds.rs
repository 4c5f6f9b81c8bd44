use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn bounds(
    #[default(0)] #[param(above = 0)] low: f64,
    #[default(-1.5)] #[param(min = -1)] negative: f64,
    #[default(361)] #[param(max = 360)] high: f64,
) -> Result<Device> {
    Device::builder("x").build()
}

fn main() {}
