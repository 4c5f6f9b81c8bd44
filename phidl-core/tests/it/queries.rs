//! What an open cell and a reference answer, beside the finished cell; and ports edited in place.

use phidl_core::prelude::*;

fn dot() -> Device {
    let mut d = Device::builder("dot");
    d.add_polygon([(0, 0), (2, 0), (2, 2), (0, 2)], [1, 2]).unwrap();
    d.info("kind", "dot");
    d.build().unwrap()
}

#[test]
fn an_open_cell_answers_what_the_finished_one_does() -> Result<()> {
    let mut d = Device::builder("cell");
    d.add(dot().array(3, 2, (5, 5)).scaled(2).rotated(30));
    d.add_polygon([(0, 0), (1, 0), (0, 1)], 7)?;
    let done = d.to_device()?;
    assert_eq!((d.area(), d.layers(), d.area_by_layer()), (done.area(), done.layers(), done.area_by_layer()));
    assert_eq!(d.hash_geometry(1e-4)?, done.hash_geometry(1e-4)?);
    let by_layer = d.polygons_by_layer()?;
    assert_eq!(by_layer, done.polygons_by_layer()?);
    assert_eq!((by_layer.len(), by_layer[&Layer::new(1, 0)].len(), by_layer[&Layer::new(7, 0)].len()), (3, 6, 1));
    Ok(())
}

#[test]
fn a_reference_answers_what_a_cell_with_it_does() -> Result<()> {
    let reference = dot().array(3, 2, (5, 5)).scaled(2).mirrored((0, 0), (1, 3));
    let cell = reference.to_device()?;
    assert!((reference.area() - cell.area()).abs() < 1e-9 && (reference.area() - 2.0 * 4.0 * 4.0 * 6.0).abs() < 1e-9);
    assert_eq!((reference.layers(), reference.info()), (cell.layers(), dot().info()));
    let outlines = |polygon: phidl_core::scene::FlatPolygon<'_>| polygon.points().collect::<Vec<_>>();
    assert!(reference.flat_polygons().map(outlines).eq(cell.flat_polygons().map(outlines)));
    assert_eq!(reference.hash_geometry(1e-4)?, cell.hash_geometry(1e-4)?);
    assert_eq!(
        dot().place().moved_by((1, 2)).rotated(90).to_string(),
        "Reference (device \"dot\", origin (-2, 1), rotation 90°, magnification 1, x_reflection false)"
    );
    Ok(())
}

#[test]
fn a_port_is_edited_in_place_and_keeps_its_name_and_order() -> Result<()> {
    let mut d = Device::builder("cell");
    d.add_port("a", ((0, 0), 1, 0))?.add_port("b", ((1, 0), 1, 0))?;
    d.port_mut("a")?.set_width(3).set_orientation(-90).movex(5);
    let names: Vec<&str> = d.ports().map(Port::name).collect();
    assert_eq!(names, ["a", "b"]);
    let a = d.port("a")?;
    assert_eq!((a.width(), a.orientation(), a.midpoint()), (3.0, 270.0, Point::new(5.0, 0.0)));
    d.port_mut("b")?.set_width(-1);
    assert_eq!(
        d.build().unwrap_err().to_string(),
        "cell: the width of the port \"b\" is -1 µm, but it must be at least 0 µm"
    );
    Ok(())
}

#[test]
fn polygons_are_scaled_in_two_directions_about_a_point() {
    let mut polygon = Polygon::new([(1, 1), (3, 1), (3, 2), (1, 2)], 1);
    polygon.scale_xy(2, -1, (1, 1));
    assert_eq!(polygon.bbox(), Some(Rect::new((1, 0), (5, 1))));
    let mut d = Device::builder("cell");
    polygon.scale_xy(0, 1, (0, 0));
    d.add(polygon);
    assert!(d.build().unwrap_err().to_string().contains("the factor of scale_xy for the polygon is 0"));
}
