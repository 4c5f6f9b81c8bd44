use phidl_core::prelude::*;
use phidl_macros::device;

#[device(nme = "ring")]
fn unknown() -> Result<Device> {
    Device::builder("x").build()
}

#[device(no_cache, name = "a", no_cache, name = "b")]
fn repeated() -> Result<Device> {
    Device::builder("x").build()
}

#[device(name, no_cache = true, example)]
fn values() -> Result<Device> {
    Device::builder("x").build()
}

#[device(name = 3)]
fn kind() -> Result<Device> {
    Device::builder("x").build()
}

#[device(name = "")]
fn empty() -> Result<Device> {
    Device::builder("x").build()
}

#[device(crate = "phidl", cell_name = "W{width}_{pitch}_{}_}")]
fn names(width: f64) -> Result<Device> {
    Device::builder("x").build()
}

fn main() {}
