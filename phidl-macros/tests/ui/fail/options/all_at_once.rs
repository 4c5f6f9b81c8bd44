use phidl_core::prelude::*;
use phidl_macros::device;

#[device(nme = "ring")]
async fn many(
    #[default(1)] #[default(2)] size: f64,
    #[param(unit = "parsec", above = 0, above = 1)] length: f64,
    text: &str,
) {
}

fn main() {
    many; // the function itself is still known
}
