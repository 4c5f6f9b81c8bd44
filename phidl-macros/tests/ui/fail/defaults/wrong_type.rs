use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn wrong(
    #[default("x")] number: f64,
    #[default(1.5)] count: usize,
    #[default(3)] optional: Option<String>,
    #[default(["a"])] list: Vec<f64>,
) -> Result<Device> {
    Device::builder("x").build()
}

fn main() {}
