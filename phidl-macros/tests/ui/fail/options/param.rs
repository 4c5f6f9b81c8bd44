use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn ranges(
    #[param(min = 0, above = 0)] both: f64,
    #[param(min = 2, max = 1)] none: f64,
    #[param(min = WIDTH)] constant: f64,
    #[param(min)] missing: f64,
    #[param(minimum = 0)] unknown: f64,
) -> Result<Device> {
    Device::builder("x").build()
}

#[device]
fn units(
    #[param(unit = "mu")] unknown: f64,
    #[param(unit = "um")] text: String,
    #[param(min = 0)] layers: Vec<Layers>,
) -> Result<Device> {
    Device::builder("x").build()
}

#[device]
fn names(
    #[param(name = "b")] a: f64,
    #[param(name = "b")] b: f64,
    #[param(named)] without_default: f64,
    #[serde(rename = "x")] foreign: f64,
) -> Result<Device> {
    Device::builder("x").build()
}

fn main() {}
