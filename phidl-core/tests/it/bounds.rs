//! Hierarchies that are too large to expand, and too deep to recurse into.

use phidl_core::num::grid::Grid;
use phidl_core::prelude::*;

fn dot() -> Device {
    let mut d = Device::builder("dot");
    d.add_polygon([(0, 0), (1, 0), (1, 1), (0, 1)], 1).unwrap();
    d.add_port("p", ((0, 0), 1, 0)).unwrap();
    d.add_label("dot", (0, 0), 2).unwrap();
    d.build().unwrap()
}

/// Eight levels of arrays of 60,000 × 60,000: 10⁷⁶ of the innermost cell.
fn nested_arrays(innermost: Device) -> Device {
    (0..8).fold(innermost, |device, level| {
        let mut d = Device::builder(format!("level{level}"));
        d.add(device.array(60_000, 60_000, (2, 2)));
        d.build().unwrap()
    })
}

fn is_too_large<T>(result: Result<T>) -> bool {
    matches!(result, Err(Error::TooLarge { .. }))
}

#[test]
fn counts_that_no_integer_holds_are_errors_and_not_memory() {
    let top = nested_arrays(dot());
    assert_eq!(
        top.flat_counts().unwrap_err().to_string(),
        "level7: the hierarchy has more than 18446744073709551615 polygons, but the limit is 18446744073709551615"
    );
    assert!(is_too_large(top.flattened()) && is_too_large(top.flattened_within(u64::MAX)));
    assert!(is_too_large(top.check_flat_size(1 << 40)));
    assert!(is_too_large(top.ports_recursive(None)));
    assert_eq!(top.ports_recursive(Some(0)).unwrap().len(), 0);
    assert!(is_too_large(top.hash_geometry(1e-4)));
    let mut open = top.edit();
    assert!(is_too_large(open.flatten().map(drop)) && is_too_large(open.flatten_onto(3).map(drop)));
    let key = open.reference_keys().next().unwrap();
    assert!(is_too_large(open.absorb(key).map(drop)));
    assert_eq!(open.build().unwrap(), top.edit().build().unwrap(), "what was refused changed nothing");
}

#[test]
fn what_is_answered_without_expanding_is_answered_for_any_count() {
    let top = nested_arrays(dot());
    assert_eq!(top.layers(), [Layer::new(1, 0)]);
    assert!(!top.is_empty() && top.area() > 1e76);
    assert_eq!(top.bbox(), Some(Rect::new((0, 0), (8.0 * 119_998.0 + 1.0, 8.0 * 119_998.0 + 1.0))));
    assert_eq!(top.flat_polygons().take(3).count(), 3);
    assert_eq!(top.instances().take(20).count(), 20);
    assert!(top.to_string().contains("1 references") && top.content_hash() != top.drawing_hash());
    assert_eq!(top.cells().len(), 9);
}

#[test]
fn arrays_of_nothing_are_not_counted_one_by_one() {
    let mut labeled = Device::builder("labeled");
    labeled.add(nested_arrays(Device::builder("empty").build().unwrap()));
    labeled.add_label("x", (0, 0), 1).unwrap();
    labeled.add_polygon([(0, 0), (1, 0), (0, 1)], 1).unwrap();
    let labeled = labeled.build().unwrap();
    assert_eq!(labeled.flat_counts().unwrap(), (1, 3));
    let flat = labeled.flattened().unwrap();
    assert_eq!((flat.polygons().len(), flat.labels().len()), (1, 1));
    assert_eq!(labeled.flat_polygons().count(), 1);
    assert_eq!(labeled.ports_recursive(None).unwrap().len(), 0);
    assert!(labeled.hash_geometry(1e-4).is_ok());
}

#[test]
fn the_limit_is_the_callers() {
    let mut d = Device::builder("field");
    d.add(dot().array(10, 10, (2, 2)));
    let field = d.build().unwrap();
    let refused = field.flattened_within(399).unwrap_err();
    assert_eq!(refused.to_string(), "field: the hierarchy has 400 points, but the limit is 399");
    assert_eq!(field.flattened_within(400).unwrap().polygons().len(), 100);
}

/// A chain of cells, each of which places the one before, some of them turned.
fn chain(levels: u32) -> Device {
    (0..levels).fold(dot(), |device, level| {
        let mut d = Device::builder("link");
        d.add(device.place().moved_by((1, 0)).rotated(if level % 1000 == 7 { 30 } else { 0 }));
        d.info("below", Value::Device(device.clone())); // values hold cells as well
        d.build().unwrap()
    })
}

#[test]
fn chains_of_20000_cells_need_no_deep_stack() {
    let on_a_small_stack = || {
        let top = chain(20_000);
        assert_eq!(top.cells().len(), 20_001);
        assert!(top.bbox().is_some() && top.hull().len() == 4);
        let hashes = (top.content_hash(), top.drawing_hash());
        assert_eq!(top.flat_counts().unwrap(), (1, 4));
        assert_eq!(top.flattened().unwrap().polygons().len(), 1);
        assert_eq!(top.flat_polygons().count(), 1);
        assert_eq!(top.ports_recursive(None).unwrap().len(), 1);
        assert_eq!(top.layers().len(), 1);
        assert!((top.area() - 1.0).abs() < 1e-9);
        assert!(top.hash_geometry(1e-4).is_ok());
        assert!(top.check_extent(&Grid::new(1e-3).unwrap()).is_ok());
        let mapped = top.map_cells(|_| Ok(())).unwrap();
        assert_eq!(mapped.drawing_hash(), hashes.1);
        let mut open = top.edit();
        open.remap_layers([(1, 2)], LayerTarget::All);
        open.simplify(0.001).unwrap();
        open.flatten().unwrap();
        assert!(format!("{open:?}").len() < 100_000);
        assert_eq!(open.build().unwrap().layers(), [Layer::new(2, 0)]);
        drop((mapped, top));
    };
    std::thread::Builder::new().stack_size(2 << 20).spawn(on_a_small_stack).unwrap().join().unwrap();
}

/// A 4 × 2 rectangle that ends at (4, 2).
fn brick() -> Device {
    let mut d = Device::builder("brick");
    d.add_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], 1).unwrap();
    d.build().unwrap()
}

/// Whether a cell with one reference is in range of a grid of 1 µm that ends at ±1000 µm.
fn fits(reference: Reference) -> bool {
    let mut d = Device::builder("top");
    d.add(reference);
    d.build().unwrap().check_extent(&Grid::new(1.0).unwrap().reaching(1000)).is_ok()
}

#[test]
fn corners_are_out_of_range_by_placement_exactly_from_the_last_step_on() {
    assert!(fits(brick().place().moved_by((996, 998))) && !fits(brick().place().moved_by((997, 998))));
    assert!(!fits(brick().place().moved_by((996, 999))) && !fits(brick().place().moved_by((-1001, 0))));
    // Scaled: 4 × 250 is 1000.
    assert!(fits(brick().place().scaled(250)) && !fits(brick().place().scaled(250.2)));
    // Arrayed: the last of 100 bricks begins at 99 steps.
    assert!(
        fits(brick().array(100, 1, (10, 0)).moved_by((6, 0))) && !fits(brick().array(100, 1, (10, 0)).moved_by((7, 0)))
    );
    assert!(!fits(brick().array(1, 1000, (10, 2))) && fits(brick().array(1, 500, (10, 2))));
    // Turned by 45°: the far corner of a 4 × 2 brick reaches (4 + 2) / √2 upward, its box 4.2426.
    assert!(
        fits(brick().place().rotated(45).moved_by((0, 995))) && !fits(brick().place().rotated(45).moved_by((0, 996.3)))
    );
}

#[test]
fn corners_are_out_of_range_in_every_cell_that_places_them() {
    let mut middle = Device::builder("middle");
    middle.add(brick().place().moved_by((900, 0)));
    let middle = middle.build().unwrap();
    assert!(fits(middle.place().moved_by((96, 0))) && !fits(middle.place().moved_by((97, 0))));
    // Scaled down again by the top cell: the cell in between is out of range all the same.
    let mut wide = Device::builder("wide");
    wide.add(middle.place().scaled(10));
    let wide = wide.build().unwrap();
    let mut top = Device::builder("top");
    top.add(wide.place().scaled(0.01));
    let error = top.build().unwrap().check_extent(&Grid::new(1.0).unwrap().reaching(1000)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "wide: the reference to \"middle\" reaches the point (9000, 0): coordinate 9000 µm is outside the grid, which \
         reaches ±1000 µm in steps of 1 µm"
    );
}

#[test]
fn labels_are_out_of_range_by_placement_as_well() {
    let mut named = Device::builder("named");
    named.add_label("far", (600, 0), 1).unwrap();
    let named = named.build().unwrap();
    assert!(fits(named.place().moved_by((400, 0))) && !fits(named.place().moved_by((401, 0))));
    assert!(!fits(named.array(2, 1, (500, 0))) && fits(named.place().rotated(45)));
}
