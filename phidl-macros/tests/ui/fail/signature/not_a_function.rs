use phidl_macros::device;

#[device]
struct Ring;

fn main() {}
