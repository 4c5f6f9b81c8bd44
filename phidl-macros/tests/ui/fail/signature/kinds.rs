use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
const fn fixed() -> Result<Device> {
    Device::builder("x").build()
}

#[device]
async fn later() -> Result<Device> {
    Device::builder("x").build()
}

#[device]
unsafe fn dangerous() -> Result<Device> {
    Device::builder("x").build()
}

#[device]
extern "C" fn foreign() -> Result<Device> {
    Device::builder("x").build()
}

#[device]
fn generic<T: Into<f64>>(size: f64) -> Result<Device> {
    Device::builder("x").build()
}

#[device]
fn conditional(size: f64) -> Result<Device>
where
    f64: Copy,
{
    Device::builder("x").build()
}

fn main() {}
