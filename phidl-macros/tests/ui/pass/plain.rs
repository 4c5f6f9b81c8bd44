use phidl_core::prelude::*;
use phidl_macros::device;

/// Draws nothing.
#[device]
pub fn plain(#[default(1)] size: f64, number: usize) -> Result<Device> {
    let _ = (size, number);
    Device::builder("plain").build()
}

fn main() {
    let called = plain(2, 3).unwrap();
    assert!(PlainParams::new(3).size(2).build().unwrap().same_cell(&called));
}
