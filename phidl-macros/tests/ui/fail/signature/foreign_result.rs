use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn foreign() -> std::result::Result<Device, String> {
    Device::builder("x").build().map_err(|error| error.to_string())
}

fn main() {}
