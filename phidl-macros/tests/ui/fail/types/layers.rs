use phidl_core::prelude::*;

fn main() {
    let _ = Layers::from(-1);
    let _ = Layers::from(1.5);
    let _ = Layers::from("metal");
}
