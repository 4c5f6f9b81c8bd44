use phidl_core::prelude::*;
use phidl_macros::device;

#[derive(Debug, Clone, PartialEq)]
struct Secret;

#[device]
fn secret(secret: Secret) -> Result<Device> {
    let _ = secret;
    Device::builder("x").build()
}

fn main() {}
