use phidl_core::prelude::*;
use phidl_macros::device;

struct Factory;

impl Factory {
    #[device]
    fn method(&self, size: f64) -> Result<Device> {
        Device::builder("x").build()
    }
}

fn main() {}
