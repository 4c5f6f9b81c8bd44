//! Grids and sweeps against the results measured on PHIDL.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

use pg::arrange::{EdgeX, EdgeY, GridCells, GridShape, Sweep};
use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_geometry as pg;
use phidl_macros::device;
use proptest::prelude::*;

/// Five rectangles that PHIDL arranged.
fn five() -> Vec<Device> {
    [(1, 2), (3, 1), (2, 5), (4, 4), (1, 1)].map(|size| pg::rectangle(size, 0).unwrap()).to_vec()
}

fn boxes(grid: &Device) -> Vec<Option<Rect>> {
    grid.references().iter().map(Bounded::bbox).collect()
}

/// Lower left and upper right.
type Corners = ((f64, f64), (f64, f64));

fn rects(corners: &[Corners]) -> Vec<Option<Rect>> {
    corners.iter().map(|(min, max)| Some(Rect::new(*min, *max))).collect()
}

fn hash(device: &Device) -> String {
    device.hash_geometry(1e-4).unwrap()
}

static DRAWN: AtomicUsize = AtomicUsize::new(0);

/// The rectangle that PHIDL swept.
#[device]
fn scaled(
    #[default(1)]
    #[param(unit = "um", above = 0)]
    width: f64,
    #[default(2)]
    #[param(unit = "um", above = 0)]
    length: f64,
    #[default(0)] layer: Layers,
    #[default(1)] scale: f64,
) -> Result<Device> {
    DRAWN.fetch_add(1, Ordering::SeqCst);
    let mut d = Device::builder("scaled");
    d.add(pg::rectangle((width * scale, length * scale), layer)?);
    d.build()
}

#[test]
fn cells_stand_where_the_specification_has_them() {
    assert_eq!(
        boxes(&pg::GridParams::new(five()).build().unwrap()),
        rects(&[
            ((0., 1.5), (1., 3.5)),
            ((6., 2.), (9., 3.)),
            ((14., 0.), (16., 5.)),
            ((21., 0.5), (25., 4.5)),
            ((30., 2.), (31., 3.)),
        ])
    );
    let mut expected = rects(&[
        ((0.5, 8.), (1.5, 10.)),
        ((3.5, 8.5), (6.5, 9.5)),
        ((0., 2.), (2., 7.)),
        ((3., 2.5), (7., 6.5)),
        ((0.5, 0.), (1.5, 1.)),
    ]);
    expected.push(None);
    assert_eq!(boxes(&pg::GridParams::new(five()).shape((2, 3)).spacing(1).build().unwrap()), expected);
    let pitched = pg::GridParams::new(five()).shape((2, -1)).spacing(10).separation(false).build().unwrap();
    let mut expected = rects(&[
        ((0.5, 19.), (1.5, 21.)),
        ((9.5, 19.5), (12.5, 20.5)),
        ((0., 6.), (2., 11.)),
        ((9., 6.5), (13., 10.5)),
        ((0.5, 0.), (1.5, 1.)),
    ]);
    expected.push(None);
    assert_eq!(boxes(&pitched), expected);
}

#[test]
fn grids_have_the_hashes_of_the_reference() {
    let five = || pg::GridParams::new(five());
    let edges = |params: pg::GridParams| params.edge_x(EdgeX::XMin).edge_y(EdgeY::YMin);
    let cases = [
        (five(), "ecac2c214a3b80ec7e38f17e5e5a9d50ed71dda2"),
        (five().shape((2, 3)).spacing(1), "48a87ae1b2a69c71fc62bf5da8c4365a070851ff"),
        (five().shape((-1, 2)).spacing(1), "beec84f97bd96343d74483b327391075be1d007d"),
        (
            five().shape((2, -1)).spacing(1).align_x(EdgeX::XMin).align_y(EdgeY::YMax),
            "5879c6c9647f69a9288941deda4ffb4458cbe5ac",
        ),
        (five().shape((2, -1)).spacing(10).separation(false), "a73dac4c51a47f0508185b6a3fe32050c2da695e"),
        (edges(five().shape((2, -1)).spacing(10).separation(false)), "44efd9a18085803469300bcdff10e1b03e546b7f"),
    ];
    for (params, expected) in cases {
        assert_eq!(hash(&params.build().unwrap()), expected, "{params:?}");
    }
}

#[test]
fn the_own_test_of_the_reference_has_its_hash() {
    let pairs = [1, 6, 9].into_iter().flat_map(|a| [1, 2, 4, 8].map(|b| (a, b)));
    let tapers: GridCells = pairs.map(|(a, b)| pg::taper(10, a, b, 0).unwrap()).collect();
    let grid = pg::GridParams::new(tapers).spacing((5, 1)).shape((3, 4)).build().unwrap();
    assert_eq!(hash(&grid), "9228ee40016e508f5589effd50056df633357de2");
}

#[test]
fn free_places_take_no_part_wherever_the_cells_are() {
    let mut far = Device::builder("far");
    far.add_polygon(Rect::new((100, 100), (101, 101)), 0).unwrap();
    let far = far.build().unwrap();
    let grid = pg::GridParams::new([&far, &far, &far]).shape((2, 2)).spacing(1).build().unwrap();
    let mut expected =
        rects(&[((100., 102.), (101., 103.)), ((102., 102.), (103., 103.)), ((100., 100.), (101., 101.))]);
    expected.push(None);
    assert_eq!(boxes(&grid), expected);
    // A column without cells takes no gap, but it takes a pitch.
    let gapped = pg::GridParams::new([[None, Some(&far), None, Some(&far)]]).spacing(5);
    assert_eq!(boxes(&gapped.build().unwrap())[3], Some(Rect::new((106, 100), (107, 101))));
    let pitched = gapped.separation(false).build().unwrap();
    assert_eq!(boxes(&pitched)[1], Some(Rect::new((100, 100), (101, 101))));
    assert_eq!(boxes(&pitched)[3], Some(Rect::new((110, 100), (111, 101))));
}

#[test]
fn lists_and_shapes_that_make_no_grid_are_refused() {
    let refused = |params: pg::GridParams| params.build().unwrap_err().to_string();
    for shape in [(-1, -1), (0, 3), (2, 2), (-2, 3), (i32::MAX, i32::MAX)] {
        assert!(refused(pg::GridParams::new(five()).shape(shape)).starts_with("grid: shape is ("), "{shape:?}");
    }
    assert!(refused(pg::GridParams::new(Vec::<Device>::new())).contains("device_list is empty"));
    assert!(refused(pg::GridParams::new(Vec::<Vec<Device>>::new())).contains("device_list is empty"));
    let ragged = refused(pg::GridParams::new(vec![five(), five()[..2].to_vec()]));
    assert_eq!(ragged, "grid: number of cells in device_list[1] is 2, but it must be 5, as in device_list[0]");
    assert!(refused(pg::GridParams::new(five()).spacing(f64::NAN)).contains("finite"));
    let json = r#"{"device_list": [{"device": "circle"}, null, "rectangle"], "spacing": 3, "align_y": "ymax"}"#;
    let grid = registry::find("grid").unwrap().build(&serde_json::from_str(json).unwrap()).unwrap();
    assert_eq!(boxes(&grid)[2], Some(Rect::new((13, 8), (17, 10))));
}

#[test]
fn sweeps_have_the_hashes_of_the_reference() {
    let whole = pg::GridsweepParams::new(ScaledParams::default()).build().unwrap();
    assert_eq!(hash(&whole), "3aba0ce0cf4d581ba2c2df3ce9f1b54b71134d26");
    let circles = pg::GridsweepParams::new(pg::CircleParams::default())
        .param_x([("radius", [10, 20, 30, 40, 50])])
        .param_y([("layer", [0, 5, 9])])
        .spacing((30, 10))
        .edge_y(EdgeY::YMax)
        .label_layer(None)
        .build()
        .unwrap();
    assert_eq!(hash(&circles), "d7f526d8ab7c0909add0746fd3a91ab8a8c60f45");
    assert!(circles.labels().is_empty());
}

/// The example of PHIDL.
fn example() -> pg::GridsweepParams {
    pg::GridsweepParams::new(ScaledParams::default())
        .param_x([("width", [4, 5])])
        .param_y(Sweep::over("length", [7, 9]).and("layer", [1, 2]))
        .param_defaults([("scale", 2)])
        .spacing(1)
}

#[test]
fn the_example_of_the_specification_has_its_rows_labels_and_hash() {
    let sweep = example().build().unwrap();
    assert_eq!(hash(&sweep), "e051e237cdcab48ae0acdacabec30a470236c23d");
    assert_eq!(sweep.bbox(), Some(Rect::new((0, 0), (19, 67))));
    let labels = sweep.labels();
    assert_eq!(labels.len(), 9);
    assert_eq!(labels[0].text, "length=7\nlayer=1\nwidth=4");
    assert_eq!(labels[0].position(), sweep.references()[0].center());
    assert_eq!((labels[8].text.as_str(), labels[8].position()), ("{'scale': 2}", Point::ORIGIN));
    assert!(labels.iter().all(|label| label.layer == Layer::new(255, 0)));
}

#[test]
fn labels_tell_what_is_drawn_and_are_left_out_where_nothing_is_swept() {
    let fixed = example().param_override([("width", 9)]).build().unwrap();
    assert_eq!(fixed.labels()[0].text, "length=7\nlayer=1\nwidth=9");
    assert_eq!(fixed.references()[0].size().width, 18.0);
    let alike = pg::GridsweepParams::new(ScaledParams::default()).param_x(2).param_y(None).build().unwrap();
    assert_eq!(alike.references().len(), 2);
    assert_eq!(alike.labels().iter().map(|label| label.text.as_str()).collect::<Vec<_>>(), ["{}"]);
}

#[test]
fn nothing_is_drawn_before_the_parameters_of_all_cells_are_checked() {
    let drawn = DRAWN.load(Ordering::SeqCst);
    // Values that no other test draws; the last one is out of bounds.
    let bad = example().param_x([("width", [4.321, 5.321, -1.0])]).build().unwrap_err();
    assert_eq!(bad.report(), "in gridsweep: scaled: width is -1 µm, but it must be greater than 0 µm");
    let unknown = example().param_x([("widht", [4.321])]).build().unwrap_err();
    assert!(unknown.report().contains("there is no parameter \"widht\""), "{}", unknown.report());
    let twice = example().param_x([("layer", [4])]).build().unwrap_err();
    assert!(twice.to_string().contains("param_x is"), "{twice}");
    assert!(example().param_x(0).build().is_err());
    let all: Vec<_> = registry::all().map(|entry| entry.name).collect();
    assert!(all.contains(&"gridsweep"));
    let cached = ScaledParams::default().width(4.321).length(7).layer(1).scale(2);
    cached.build().unwrap();
    assert!(DRAWN.load(Ordering::SeqCst) > drawn, "it was not drawn by a sweep");
}

#[test]
fn a_sweep_from_json_names_its_generator() {
    let json = r#"{"function": {"device": "circle", "params": {"layer": 3}}, "param_x": {"radius": [1, 2]},
                   "param_y": null, "spacing": 4, "label_layer": [7, 1]}"#;
    let params: BTreeMap<String, Value> = serde_json::from_str(json).unwrap();
    let sweep = registry::find("gridsweep").unwrap().build(&params).unwrap();
    assert_eq!((sweep.references().len(), sweep.layers()), (2, vec![Layer::new(3, 0)]));
    assert_eq!(sweep.labels()[0].layer, Layer::new(7, 1));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn separated_rows_and_columns_never_come_closer_than_the_spacing(
        sizes in prop::collection::vec((0.1..30.0, 0.1..30.0, -50.0..50.0, -50.0..50.0), 1..20),
        columns in 1_i64..6,
        (sx, sy) in (0.0..10.0, 0.0..10.0),
    ) {
        let cells: Vec<Device> = sizes.iter().map(|(w, h, x, y)| {
            let mut d = Device::builder("cell");
            d.add_polygon(Rect::new((*x, *y), (x + w, y + h)), 0).unwrap();
            d.build().unwrap()
        }).collect();
        let shape = GridShape { columns, rows: -1 };
        let grid = pg::GridParams::new(cells).shape(shape).spacing((sx, sy)).build().unwrap();
        let boxes: Vec<(usize, Rect)> = boxes(&grid).into_iter().enumerate().filter_map(|(i, b)| Some((i, b?))).collect();
        let columns = usize::try_from(columns).unwrap();
        for (i, a) in &boxes {
            for (j, b) in &boxes {
                if i % columns < j % columns {
                    prop_assert!(b.min.x - a.max.x >= sx - 1e-9);
                }
                if i / columns < j / columns {
                    prop_assert!(a.min.y - b.max.y >= sy - 1e-9);
                }
                if i / columns == j / columns {
                    prop_assert!((a.center().y - b.center().y).abs() < 1e-9);
                }
            }
        }
    }
}

#[test]
fn grids_and_sweeps_of_too_many_cells_are_refused_before_they_are_drawn() {
    let cell = pg::circle(1, 10, 0).unwrap();
    let error = pg::GridParams::new([&cell]).shape((1001, 1000)).build().unwrap_err().to_string();
    assert_eq!(error, "grid: shape is (1001, 1000), but it must have from 1 to 1000000 positions");
    let sweep =
        pg::GridsweepParams::new(pg::CircleParams::default()).param_x(Sweep::from(1001)).param_y(Sweep::from(100));
    let error = sweep.build().unwrap_err().to_string();
    assert_eq!(error, "gridsweep: number of cells is 100100, but it must be at most 100000");
}
