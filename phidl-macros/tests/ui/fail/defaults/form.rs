use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn form(
    #[default] bare: f64,
    #[default = 1.0] equals: f64,
    #[default()] empty: f64,
    #[default(1, 2)] two: f64,
    #[default(1)]
    #[default(2)]
    twice: f64,
) -> Result<Device> {
    Device::builder("x").build()
}

fn main() {}
