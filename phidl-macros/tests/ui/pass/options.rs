use phidl_core::prelude::*;
use phidl_macros::device;

#[device(name = "Outside", no_cache, example = OptionsParams::new("x"),)]
fn options(
    #[param(name = "T")] text: String,
    #[default(None)] #[param(unit = "um", min = -1, max = 1.5, named)] shift: Option<f64>,
) -> phidl_core::Result<phidl_core::scene::Device> {
    let _ = (text, shift);
    Device::builder("options").build()
}

fn main() {
    options("y").unwrap();
}
