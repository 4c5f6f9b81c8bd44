use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn borrowed(text: &str, list: Option<&'static [f64]>) -> Result<Device> {
    Device::builder("x").build()
}

#[device]
fn opaque(size: impl Into<f64>) -> Result<Device> {
    Device::builder("x").build()
}

#[device]
fn patterns((x, y): (f64, f64), _: f64) -> Result<Device> {
    Device::builder("x").build()
}

#[device]
fn reserved(check: f64) -> Result<Device> {
    Device::builder("x").build()
}

fn main() {}
