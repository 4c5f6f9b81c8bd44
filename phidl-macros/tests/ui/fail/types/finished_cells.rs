use phidl_core::prelude::*;

fn main() -> Result<()> {
    let mut finished = Device::builder("finished").build()?;
    finished.add_polygon([(0, 0), (1, 0), (0, 1)], 1)?; // only a builder can be drawn in
    finished.movex(5.0); // only a placement can be moved

    let open = Device::builder("open");
    let mut d = Device::builder("top");
    d.add(open); // only a finished cell can be placed
    d.build()?;
    d.add_polygon([(0, 0), (1, 0), (0, 1)], 1)?; // it is finished
    Ok(())
}
