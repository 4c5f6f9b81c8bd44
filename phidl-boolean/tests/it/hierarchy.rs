//! Results that keep hierarchy are, flattened, the flat results; and they do keep it.

use phidl_boolean::{
    BooleanError, Hierarchy, Join, OffsetOptions, OpenPorts, Options, boolean,
    grid::{self, GridPoint},
    offset, outline, union, union_by_layer, xor_diff,
};
use phidl_core::prelude::*;
use proptest::prelude::{Just, Strategy, prop, prop_assert_eq, prop_oneof, proptest};
use proptest::test_runner::{Config as ProptestConfig, TestCaseError, TestCaseResult};

/// The grid of all tests here: coordinates are written in steps.
const STEP: f64 = 1e-3;

fn options() -> Options<'static> {
    Options { precision: STEP, max_points: Some(12), ..Options::default() }
}

fn kept(options: Options<'static>) -> Options<'static> {
    Options { hierarchy: Hierarchy::Keep, ..options }
}

fn um(steps: (f64, f64)) -> Point {
    Point::new(steps.0 * STEP, steps.1 * STEP)
}

/// Coordinates at grid points, at half steps, at quarter steps, and anywhere.
fn coordinate(reach: i32) -> impl Strategy<Value = f64> {
    let whole = -reach..=reach;
    prop_oneof![
        4 => whole.clone().prop_map(f64::from),
        1 => whole.clone().prop_map(|v| f64::from(v) + 0.5),
        1 => whole.prop_map(|v| f64::from(v) + 0.25),
        1 => -f64::from(reach)..f64::from(reach),
    ]
}

fn position(reach: i32) -> impl Strategy<Value = (f64, f64)> {
    (coordinate(reach), coordinate(reach))
}

/// A cell with a few outlines of up to 40 steps, on layers 1 and 2.
fn leaf() -> impl Strategy<Value = Device> {
    let outline = (prop::collection::vec(position(20), 3..7), 1..=2_u16);
    prop::collection::vec(outline, 1..4).prop_map(|outlines| {
        let mut d = Device::builder("leaf");
        for (points, layer) in outlines {
            d.add_polygon(points.into_iter().map(um).collect::<Vec<_>>(), layer).unwrap();
        }
        d.add_port("p", ((0.0, 0.0), 8.0 * STEP, 90.0)).unwrap();
        d.build().unwrap()
    })
}

/// How a cell is placed: where, how it is turned, and how often.
#[derive(Debug, Clone)]
struct Placing {
    cell: usize,
    at: (f64, f64),
    rotation: f64,
    mirrored: bool,
    magnification: f64,
    array: (u32, u32, (f64, f64)),
}

fn placing() -> impl Strategy<Value = Placing> {
    let rotation = prop_oneof![6 => Just(0.0), 2 => Just(90.0), 1 => Just(180.0), 1 => Just(30.0)];
    let magnification = prop_oneof![8 => Just(1.0), 1 => Just(2.0)];
    let pitch = prop_oneof![3 => Just((64.0, 80.0)), 1 => Just((20.0, 90.0)), 1 => Just((64.5, 70.25))];
    let array = prop_oneof![3 => Just((1, 1)), 1 => (1..4_u32, 1..4_u32)];
    let at =
        prop_oneof![(-8..8_i32, -8..8_i32).prop_map(|(x, y)| (f64::from(100 * x), f64::from(100 * y))), position(400)];
    (0..3_usize, at, rotation, prop::bool::weighted(0.2), magnification, (array, pitch)).prop_map(
        |(cell, at, rotation, mirrored, magnification, ((columns, rows), pitch))| Placing {
            cell,
            at,
            rotation,
            mirrored,
            magnification,
            array: (columns, rows, pitch),
        },
    )
}

fn placed(cell: &Device, placing: &Placing) -> Reference {
    let (columns, rows, pitch) = placing.array;
    let transform = Transform {
        x_reflection: placing.mirrored,
        magnification: placing.magnification,
        rotation: placing.rotation,
        origin: um(placing.at),
    };
    let (column_step, row_step) = (um((pitch.0, 0.0)), um((0.0, pitch.1)));
    cell.place().with_transform(transform).with_array(Array { columns, rows, column_step, row_step })
}

fn cell_of(name: &str, cells: &[Device], placings: &[Placing]) -> Device {
    let mut d = Device::builder(name);
    for placing in placings {
        d.add(placed(&cells[placing.cell % cells.len()], placing));
    }
    d.build().unwrap()
}

/// Leaves in blocks in a top cell, and sometimes an outline over it all.
fn layout() -> impl Strategy<Value = Device> {
    let placings = |most| prop::collection::vec(placing(), 0..most);
    let outline = prop::option::weighted(0.3, prop::collection::vec(position(900), 3..6));
    let parts = (prop::collection::vec(leaf(), 2..4), placings(4), placings(10), placings(6), outline);
    parts.prop_map(|(leaves, in_block, leaves_in_top, blocks_in_top, outline)| {
        let block = cell_of("block", &leaves, &in_block);
        let mut d = cell_of("top", &leaves, &leaves_in_top).edit();
        for placing in blocks_in_top {
            d.add(placed(&block, &placing));
        }
        if let Some(points) = outline {
            d.add_polygon(points.into_iter().map(um).collect::<Vec<_>>(), 1).unwrap();
        }
        d.build().unwrap()
    })
}

/// All polygons of a result where they are on the grid, with their layers, in an order of their own.
fn polygons(result: &Device) -> Vec<(Option<Layer>, Vec<GridPoint>)> {
    let steps = grid::with_step(STEP).unwrap();
    let on_grid = |p: Point| GridPoint::new(steps.steps(p.x).unwrap(), steps.steps(p.y).unwrap());
    let drawn = result.flat_polygons().map(|p| (p.layer, p.points().map(on_grid).collect()));
    let mut drawn: Vec<(Option<Layer>, Vec<GridPoint>)> = drawn.collect();
    drawn.sort_unstable();
    drawn
}

fn same(kept: Result<Device, BooleanError>, flat: Result<Device, BooleanError>) -> TestCaseResult {
    let (kept, flat) = (kept.unwrap(), flat.unwrap());
    prop_assert_eq!(polygons(&kept), polygons(&flat));
    prop_assert_eq!(kept.ports().count(), flat.ports().count());
    Ok::<(), TestCaseError>(())
}

fn any_growth() -> impl Strategy<Value = OffsetOptions> {
    let join = prop_oneof![
        Just(Join::default()),
        Just(Join::Bevel),
        Just(Join::Extended { extension: 3.0 }),
        Just(Join::Round { points_per_turn: 16.0 })
    ];
    (join, prop::bool::weighted(0.8)).prop_map(|(join, merge_first)| OffsetOptions { join, merge_first })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn set_operations_that_keep_hierarchy_draw_the_polygons_of_the_flat_ones(a in layout(), b in layout()) {
        for operation in ["or", "and", "A-B", "B-A", "xor"] {
            same(boolean(&a, &b, operation, 3, &kept(options())), boolean(&a, &b, operation, 3, &options()))?;
        }
        same(union(&a, 3, &kept(options())), union(&a, 3, &options()))?;
    }

    #[test]
    fn a_layout_less_a_layer_of_its_own_is_the_same_either_way(a in layout()) {
        let mut hole = a.edit();
        hole.keep_layers(2, LayerTarget::All);
        let hole = hole.build().unwrap();
        same(boolean(&a, &hole, "not", 3, &kept(options())), boolean(&a, &hole, "not", 3, &options()))?;
        same(xor_diff(&a, &hole, &kept(options())), xor_diff(&a, &hole, &options()))?;
        same(union_by_layer(&a, &kept(options())), union_by_layer(&a, &options()))?;
    }

    #[test]
    fn offsets_that_keep_hierarchy_draw_the_polygons_of_the_flat_ones(
        a in layout(), growth in any_growth(), distance in prop::sample::select(vec![-25.0, -3.0, -0.4, 0.0, 0.7, 4.0, 30.0]),
    ) {
        let distance = distance * STEP;
        same(offset(&a, distance, &growth, 3, &kept(options())), offset(&a, distance, &growth, 3, &options()))?;
    }

    #[test]
    fn frames_that_keep_hierarchy_draw_the_polygons_of_the_flat_ones(
        a in layout(), growth in any_growth(), distance in prop::sample::select(vec![-3.0, 4.0, 30.0]),
    ) {
        let distance = distance * STEP;
        for open in [OpenPorts::Closed, OpenPorts::WithMargin(0.0), OpenPorts::WithMargin(5.0 * STEP)] {
            let kept = outline(&a, distance, &growth, open, 3, &kept(options()));
            same(kept, outline(&a, distance, &growth, open, 3, &options()))?;
        }
    }
}

/// A ring of 16 corners with a square in it, on layers 1 and 2.
fn ring() -> Device {
    let mut d = Device::builder("ring");
    let corner = |i: i32| Point::polar(10.0, 22.5 * f64::from(i));
    d.add_polygon((0..16).map(corner).collect::<Vec<_>>(), 1).unwrap();
    d.add_polygon(Rect::new((-3, -3), (3, 3)), 2).unwrap();
    d.build().unwrap()
}

fn on(device: &Device, layer: u16) -> Device {
    let mut d = device.edit();
    d.keep_layers(layer, LayerTarget::All);
    d.build().unwrap()
}

/// Polygons and references of a cell itself.
fn drawn_and_placed(device: &Device) -> (usize, usize) {
    (device.polygons().count(), device.references().len())
}

#[test]
fn a_million_rings_less_their_squares_are_one_ring_in_an_array() {
    let mut d = Device::builder("top");
    d.add(ring().array(1000, 1000, (25, 25)));
    let top = d.build().unwrap();
    let cut = boolean(&on(&top, 1), &on(&top, 2), "not", 1, &kept(Options::default())).unwrap();
    assert_eq!(drawn_and_placed(&cut), (0, 1));
    let cell = cut.references()[0].device();
    assert_eq!(drawn_and_placed(cell), (1, 0));
    assert_eq!((cut.references()[0].count(), cell.name()), (1_000_000, "boolean_ring"));
}

#[test]
fn what_a_bar_crosses_is_drawn_flat_and_the_rest_stays_in_arrays() {
    let mut d = Device::builder("top");
    d.add(ring().array(20, 20, (25, 25)));
    let top = d.build().unwrap();
    let bar = Rect::new((-100.0, 99.0), (1000.0, 101.0));
    let cut = boolean(&top, &bar, "not", 1, &kept(Options::default())).unwrap();
    // The bar divides each of the twenty rings of one row; nine more rows are over, four below and six... above.
    assert_eq!(cut.polygons().count(), 40);
    assert_eq!(cut.references().iter().map(Reference::count).sum::<usize>(), 380);
    assert_eq!(cut.references().len(), 2);
}

#[test]
fn a_frame_around_everything_does_not_interact_with_its_inside() {
    let frame =
        boolean(&Rect::new((-50, -50), (550, 550)), &Rect::new((-40, -40), (540, 540)), "not", 1, &Options::default());
    let mut d = Device::builder("chip");
    d.add(frame.unwrap());
    d.add(ring().array(20, 20, (25, 25)));
    let chip = d.build().unwrap();
    let grown = offset(&chip, 1, &OffsetOptions::default(), 1, &kept(Options::default())).unwrap();
    assert_eq!(drawn_and_placed(&grown), (1, 1));
    // Grown by more than half of the gap between the rings, they are one.
    let grown = offset(&chip, 3, &OffsetOptions::default(), 1, &kept(Options::default())).unwrap();
    assert_eq!(grown.references().len(), 0);
}

#[test]
fn each_turn_and_each_part_of_a_step_is_a_cell_of_its_own() {
    let mut d = Device::builder("top");
    for i in 0..40 {
        let turned = ring().place().rotated(f64::from(i % 4) * 30.0);
        let off = if i < 20 { 0.0 } else { 0.3e-4 };
        d.add(turned.moved_by((f64::from(i) * 30.0 + off, f64::from(i * i))));
    }
    let merged = union(&d.build().unwrap(), 1, &kept(Options::default())).unwrap();
    assert_eq!(merged.polygons().count(), 0);
    assert_eq!(merged.cells().len(), 1 + 8);
}

#[test]
fn bad_options_are_refused_and_empty_operands_give_an_empty_result() {
    let bad = Options { max_points: Some(2), ..Options::default() };
    let error = union(&ring().array(5, 5, (30, 30)), 1, &kept(bad)).unwrap_err();
    assert_eq!(error.to_string(), "union: max_points is 2, but it must be at least 3");
    let error = offset(&(), f64::NAN, &OffsetOptions::default(), 1, &kept(Options::default())).unwrap_err();
    assert!(error.to_string().starts_with("offset: distance is NaN"), "{error}");
    assert!(boolean(&(), &(), "or", 1, &kept(Options::default())).unwrap().is_empty());
    let far = ring().array(3, 3, (1e8, 1.0));
    assert!(union(&far, 1, &kept(Options::default())).unwrap_err().to_string().contains("in cell ring"));
}
