//! What `phidl` alone gives: its modules, its prelude, and every generator of the library by name.

use phidl::prelude::*;
use phidl::{boolean, io, registry, route, shapes as pg};

#[test]
fn a_chip_needs_only_the_facade() -> Result<()> {
    let bus = pg::straight((0.5, 30), 1)?.place().rotated(90);
    let wire = route::RouteSmoothParams::new(bus.port("2")?, Port::new((60, 20), 0.5, 270)).layer(1).build()?;
    assert_eq!(wire.port("2")?.midpoint(), Point::new(60.0, 20.0));
    let wide = Path::straight(10)?.extrude(&CrossSection::new().add(Section::new(2).layer(1)))?;
    let cut = boolean::boolean(&wide, &bus, boolean::Operation::Not, 1, &boolean::Options::default())?;
    assert!(!cut.is_empty());
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("cut.gds");
    io::gds::write(&cut, &file, &io::gds::GdsOptions::default()).expect("a written file");
    assert!(file.exists());
    Ok(())
}

#[test]
fn generators_of_the_library_are_found_by_name() -> Result<()> {
    for name in ["ring", "route_manhattan", "boolean", "snspd"] {
        assert_eq!(registry::find(name)?.name, name);
    }
    Ok(())
}

/// Draws a strip.
#[device(cell_name = "strip_W{width}_L{length}")]
fn strip(#[default(1)] width: f64, #[default(2)] length: f64) -> Result<Device> {
    let mut d = Device::builder("strip");
    d.add_polygon([(0.0, 0.0), (length, 0.0), (length, width), (0.0, width)], 1)?;
    d.build()
}

#[test]
fn a_template_names_cells_in_files() -> Result<()> {
    let mut chip = Device::builder("chip");
    chip.add(strip(0.08, 10)?);
    chip.add(strip(0.5, 10)?);
    let bytes = io::gds::to_bytes(&chip.build()?, &io::gds::GdsOptions::default()).expect("a file");
    let read = io::gds::read_bytes(&bytes, &io::gds::ReadOptions::default()).expect("what was written").device;
    let names: Vec<&str> = read.references().iter().map(|reference| reference.device().name()).collect();
    assert_eq!(names, ["strip_W0p08_L10", "strip_W0p5_L10"]);
    Ok(())
}
