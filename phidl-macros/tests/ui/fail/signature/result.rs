use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn nothing() {}

#[device]
fn bare() -> Device {
    Device::builder("x").build().unwrap()
}

#[device]
fn other() -> Result<f64> {
    Ok(1.0)
}

fn main() {}
