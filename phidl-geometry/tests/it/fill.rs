//! Filling: every cell against every polygon, with distances computed another way.

use phidl_core::prelude::*;
use phidl_core::registry;
use phidl_geometry as pg;
use proptest::prelude::*;

/// The square that PHIDL filled, in a box of 50 × 50.
fn square() -> pg::FillRectangleParams {
    let mut d = Device::builder("square");
    d.add(pg::rectangle((10, 10), 0).unwrap().place().moved_by((20, 20)));
    pg::FillRectangleParams::new(d.build().unwrap())
        .fill_size((5, 5))
        .margin(0)
        .fill_layers(0)
        .fill_densities(1)
        .bbox([(0, 0), (50, 50)])
}

fn cells(fill: &Device) -> Vec<Rect> {
    fill.flat_polygons().map(|polygon| polygon.bbox().unwrap()).collect()
}

/// Distance of a point from an edge.
fn from_edge(p: Point, a: Point, b: Point) -> f64 {
    let along = b - a;
    let t = if along.norm() > 0.0 { ((p - a).dot(along) / along.dot(along)).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a + along * t)
}

fn edges(outline: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    (0..outline.len()).map(|i| (outline[i], outline[(i + 1) % outline.len()]))
}

fn inside(p: Point, outline: &[Point]) -> bool {
    let crossed =
        |(a, b): &(Point, Point)| (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y);
    edges(outline).filter(crossed).count() % 2 == 1
}

fn cross_each_other((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let side = |p: Point, q: Point, r: Point| (q - p).cross(r - p);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// Distance of two outlines; 0 where they overlap.
fn distance(a: &[Point], b: &[Point]) -> f64 {
    let overlap = a.iter().any(|p| inside(*p, b))
        || b.iter().any(|p| inside(*p, a))
        || edges(a).any(|e| edges(b).any(|f| cross_each_other(e, f)));
    if overlap {
        return 0.0;
    }
    let corners = |a: &[Point], b: &[Point]| {
        a.iter().flat_map(|p| edges(b).map(move |(c, d)| from_edge(*p, c, d))).fold(f64::INFINITY, f64::min)
    };
    corners(a, b).min(corners(b, a))
}

/// Whether a cell of the raster is among those that were drawn.
fn is_drawn(drawn: &[Rect], cell: Rect) -> bool {
    drawn.iter().any(|rect| rect.center().distance(cell.center()) < 1e-6)
}

/// All cells of a raster from the origin on.
fn raster(size: Size, columns: u32, rows: u32) -> impl Iterator<Item = Rect> {
    (0..columns).flat_map(move |i| {
        (0..rows).map(move |j| {
            let corner = Point::new(f64::from(i) * size.width, f64::from(j) * size.height);
            Rect::new(corner, corner + Point::new(size.width, size.height))
        })
    })
}

#[test]
fn a_square_takes_its_cells_and_those_nearer_than_the_margin() {
    // Of 100 cells: 4 under the square; the 12 around them touch it; the next ring is exactly 5 away.
    for (margin, free) in [(0.0, 96), (2.5, 84), (5.0, 84), (5.1, 68), (7.08, 64)] {
        let fill = square().margin(margin).build().unwrap();
        assert_eq!(cells(&fill).len(), free, "margin {margin}");
    }
    // Different margins: 3 columns to either side, rows only where they touch.
    assert_eq!(cells(&square().margin((12, 1)).build().unwrap()).len(), 100 - 4 * 8);
    assert_eq!(cells(&square().margin((0, 6)).build().unwrap()).len(), 100 - 2 * 6);
}

#[test]
fn cells_are_drawn_as_the_specification_has_them() {
    let cell = |fill: &Device| fill.references()[0].device().clone();
    let two = square().fill_layers([Layer::new(7, 0), Layer::new(8, 2)]).fill_densities([0.25, 0.81]).build().unwrap();
    assert_eq!((two.name(), cell(&two).name()), ("fill_pattern", "fillcell"));
    let boxes: Vec<(Layer, Rect)> = cell(&two).flat_polygons().map(|p| (p.layer.unwrap(), p.bbox().unwrap())).collect();
    let expected = [(7, 0, 1.25), (8, 2, 2.25)].map(|(l, d, r)| (Layer::new(l, d), Rect::new((-r, -r), (r, r))));
    assert_eq!(boxes, expected);
}

/// Cells that touch are polygons with shared corners, so that no rounding parts them.
#[test]
fn cells_that_touch_are_drawn_with_shared_corners() {
    let frames = square().fill_densities(0.25).fill_inverted(true).build().unwrap();
    assert!(frames.references().is_empty());
    let outline = frames.polygons().next().unwrap();
    let (middle, first) = (Rect::around(outline.points.to_vec()).unwrap().center(), outline.points[0]);
    assert_eq!(outline.points.len(), 11);
    assert_eq!((first - middle, outline.points[3] - middle), ((2.5, 2.5).into(), (-1.25, -1.25).into()));
    assert!((outline.area() - 25.0 * 0.75).abs() < 1e-12);
    let full = square().avoid_layers(77).build().unwrap();
    assert_eq!((full.references().len(), full.polygons().len()), (0, 100));
}

#[test]
fn a_cell_of_your_own_fills_a_region() {
    let mut region = Device::builder("region");
    // Two halves of one region: cells over their common edge lie inside.
    region.add(pg::rectangle((17, 30), 0).unwrap().place().moved_by((0, 5)));
    region.add(pg::rectangle((13, 30), 0).unwrap().place().moved_by((17, 5)));
    let vent = pg::circle(1, 30, 4).unwrap();
    let none: [Layer; 0] = [];
    let params = square().fill_layers(none).fill_densities([0.0; 0]).avoid_layers(0).cell(&vent);
    let fill = params.clone().inside(region.build().unwrap()).build().unwrap();
    // 6 × 6 cells of 5 µm, without the four cells of the square in the middle of the box.
    assert_eq!(fill.flat_polygons().on(4).count(), 6 * 6 - 4);
    assert!(fill.flat_polygons().all(|vent| vent.bbox().unwrap().center().x < 30.0));
    let error = params.cell(pg::circle(3, 30, 4).unwrap()).build().unwrap_err().to_string();
    assert_eq!(
        error,
        "fill_rectangle: cell is 6 × 6 µm large, but it must draw something and fit into fill_size, 5 × 5 µm"
    );
}

#[test]
fn free_area_is_filled_with_few_arrays() {
    let square = || square().fill_densities(0.25);
    let fill = square().margin(5).build().unwrap();
    let below_left_right_above = 4;
    assert_eq!(fill.references().len(), below_left_right_above);
    let all = square().avoid_layers(77).build().unwrap();
    assert_eq!((all.references().len(), all.flat_counts().unwrap().0), (1, 100));
}

#[test]
fn only_avoided_layers_count_and_included_ones_open_what_they_cover() {
    let mut d = Device::builder("d");
    d.add(pg::rectangle((20, 20), 1).unwrap());
    d.add(pg::rectangle((6, 6), 50).unwrap().place().moved_by((7, 7)));
    let fill = pg::FillRectangleParams::new(d.build().unwrap())
        .fill_size((2, 2))
        .fill_layers(9)
        .fill_densities(1)
        .bbox([(-10, -10), (30, 30)]);
    let count = |params: &pg::FillRectangleParams| cells(&params.build().unwrap()).len();
    // 400 cells; the square takes 100; the opening from 7 to 13 holds 2 × 2 whole ones from 8 to 12.
    let open = fill.clone().margin(0).include_layers(50);
    assert_eq!(count(&open), 304);
    assert_eq!(count(&open.clone().margin(1)), 400 - 12 * 12 + 4);
    assert_eq!(count(&open.margin(1.01)), 400 - 12 * 12);
    assert_eq!(count(&fill.clone().margin(0)), 300);
    assert_eq!(count(&fill.clone().margin(0).avoid_layers([50, 60])), 400 - 16);
    assert_eq!(count(&fill.margin(0).avoid_layers([50]).include_layers([50])), 400);
}

#[test]
fn only_whole_cells_inside_the_box_are_used() {
    let params = square().avoid_layers(77);
    let size = |bbox: [(f64, f64); 2], cell: (f64, f64)| {
        let fill = params.clone().bbox(bbox).fill_size(cell).build().unwrap();
        fill.bbox().map(|bbox| (bbox.min, bbox.size()))
    };
    assert_eq!(size([(0.0, 0.0), (10.2, 10.2)], (3.0, 0.5)), Some((Point::ORIGIN, Size::new(9.0, 10.0))));
    assert_eq!(size([(5.0, 5.0), (1.0, 1.0)], (2.0, 2.0)), Some((Point::new(1.0, 1.0), Size::new(4.0, 4.0))));
    assert_eq!(size([(0.0, 0.0), (1.0, 1.0)], (2.0, 2.0)), None);
}

#[test]
fn what_cannot_be_filled_is_refused() {
    let message = |params: pg::FillRectangleParams| params.build().unwrap_err().to_string();
    assert_eq!(
        message(square().fill_densities([0.5, 0.5])),
        "fill_rectangle: number of fill_densities is 2, but it must be 1, one for each fill layer"
    );
    assert!(
        message(square().fill_inverted([true, false]))
            .contains("number of fill_inverted is 2, but it must be 1, one for each fill layer")
    );
    assert!(message(square().fill_inverted(true)).contains("be less than 1, since the layer is inverted"));
    assert!(message(square().fill_densities(1.5)).contains("fill_densities[0] is 1.5, but it must be at most 1"));
    assert!(message(square().margin((1, -1))).contains("margin[1] is -1 µm"));
    assert!(message(square().fill_size((0, 5))).contains("fill_size.width is 0 µm"));
    assert!(message(square().bbox([(0, 0), (1_000_000, 1_000_000)])).contains("cells in the box"));
    let empty = Device::builder("nothing").build().unwrap();
    assert!(message(pg::FillRectangleParams::new(empty)).contains("bbox is not given"));
    let params = r#"{"D": {"device": "rectangle"}, "avoid_layers": "some"}"#;
    assert!(registry::find("fill_rectangle").unwrap().build(&serde_json::from_str(params).unwrap()).is_err());
}

#[test]
fn the_parameters_of_the_reference_come_from_json() {
    let json = r#"{"D": {"device": "arc", "params": {"radius": 10, "width": 2, "theta": 135}}, "fill_size": [1.5, 1.5],
        "avoid_layers": [0], "include_layers": null, "margin": 2, "fill_layers": [4, 3],
        "fill_densities": [0.1, 0.5], "fill_inverted": null, "bbox": [[-15, -5], [20, 18]]}"#;
    let fill = registry::find("fill_rectangle").unwrap().build(&serde_json::from_str(json).unwrap()).unwrap();
    // 23 × 15 cells; the reference uses 251 of them, some of which are nearer than 2 µm.
    assert_eq!(fill.layers(), [Layer::new(3, 0), Layer::new(4, 0)]);
    let arc = pg::arc(10, 2, 135, 0, 2.5, 0).unwrap();
    let outline = arc.polygons().next().unwrap().points.to_vec();
    let drawn: Vec<Rect> = fill.flat_polygons().on(3).map(|p| p.bbox().unwrap()).collect();
    let mut free = 0;
    for cell in raster(Size::new(1.5, 1.5), 23, 15).map(|cell| cell.shifted((-15, -5).into())) {
        let keeps = distance(&cell.corners(), &outline) >= 2.0;
        assert_eq!(is_drawn(&drawn, cell), keeps, "{cell}");
        free += usize::from(keeps);
    }
    assert_eq!(drawn.len(), free);
}

/// An outline within the raster of the property tests, or one that reaches out of it.
fn outline() -> impl Strategy<Value = Vec<Point>> {
    let point = (-10.0..50.0, -10.0..50.0).prop_map(Point::from);
    let grid = (-2..10_i32, -2..10_i32).prop_map(|(x, y)| Point::from((5 * x, 5 * y)));
    prop_oneof![prop::collection::vec(point, 3..7), prop::collection::vec(grid, 3..5)]
}

fn drawing(outlines: &[(Vec<Point>, u16)]) -> Device {
    let mut d = Device::builder("drawing");
    for (outline, layer) in outlines {
        d.add_polygon(outline, *layer).unwrap();
    }
    d.build().unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn a_cell_is_used_exactly_if_it_keeps_the_margin(
        outlines in prop::collection::vec(outline(), 1..4),
        (width, height) in (2.0..7.0, 2.0..7.0),
        (mx, my) in (0.01..15.0, 0.01..15.0),
    ) {
        let scene: Vec<_> = outlines.iter().cloned().map(|outline| (outline, 1)).collect();
        let fill = pg::FillRectangleParams::new(drawing(&scene))
            .fill_size((width, height)).margin((mx, my)).fill_layers(2).fill_densities(1).bbox([(0, 0), (40, 40)]);
        let drawn = cells(&fill.build().unwrap());
        // With its axes scaled to 1, the ellipse of the margins is a circle.
        let scaled = |points: &[Point]| points.iter().map(|p| Point::new(p.x / mx, p.y / my)).collect::<Vec<_>>();
        let within = |cell: &Rect| cell.max.x <= 40.0 && cell.max.y <= 40.0;
        for cell in raster(Size::new(width, height), 20, 20).filter(within) {
            let near = outlines.iter().map(|o| distance(&scaled(&cell.corners()), &scaled(o))).fold(f64::INFINITY, f64::min);
            if (near - 1.0).abs() > 1e-7 {
                prop_assert_eq!(is_drawn(&drawn, cell), near > 1.0, "{}: {}", cell, near);
            }
        }
    }

    #[test]
    fn without_a_margin_a_cell_is_used_exactly_if_nothing_lies_in_it(
        outlines in prop::collection::vec(outline(), 1..4),
    ) {
        let scene: Vec<_> = outlines.iter().cloned().map(|outline| (outline, 1)).collect();
        let fill = pg::FillRectangleParams::new(drawing(&scene))
            .fill_size((5, 5)).margin(0).fill_layers(2).fill_densities(1).bbox([(0, 0), (40, 40)]);
        let drawn = cells(&fill.build().unwrap());
        for cell in raster(Size::new(5.0, 5.0), 8, 8) {
            // Slightly smaller and larger cells: touching does not count either way.
            let overlaps = |by: f64| outlines.iter().any(|o| distance(&cell.grown(by).corners(), o) == 0.0);
            if overlaps(-1e-6) {
                prop_assert!(!is_drawn(&drawn, cell), "{}", cell);
            } else if !overlaps(1e-6) {
                prop_assert!(is_drawn(&drawn, cell), "{}", cell);
            }
        }
    }

    #[test]
    fn no_cell_is_nearer_than_the_margin_to_what_included_polygons_leave(
        outlines in prop::collection::vec((outline(), 1..3_u16), 1..5),
        margin in prop_oneof![Just(0.0), 0.1..6.0],
    ) {
        let fill = pg::FillRectangleParams::new(drawing(&outlines))
            .fill_size((4, 3)).margin(margin).fill_layers(9).fill_densities(1).bbox([(0, 0), (40, 40)]);
        let drawn = cells(&fill.clone().include_layers(2).build().unwrap());
        let covers = |p: Point, layer: u16| outlines.iter().any(|(outline, on)| *on == layer && inside(p, outline));
        let lattice = (0..120).flat_map(|i| (0..120).map(move |j| Point::new(0.5 * f64::from(i) - 9.9, 0.5 * f64::from(j) - 9.9)));
        // A line without area may pass for either; a small triangle around the point does not.
        let around = [(0.0, 2e-5), (2e-5, -1e-5), (-2e-5, -1e-5)].map(Point::from);
        let left = |p: &Point| around.iter().all(|by| covers(*p + *by, 1) && !covers(*p + *by, 2));
        for p in lattice.filter(left) {
            for cell in &drawn {
                let away = Point::new((cell.min.x - p.x).max(p.x - cell.max.x).max(0.0), (cell.min.y - p.y).max(p.y - cell.max.y).max(0.0));
                prop_assert!(away.norm() >= margin - 1e-9 && (margin > 0.0 || away.norm() > 0.0), "{} near {}", cell, p);
            }
        }
        let closed = cells(&fill.avoid_layers(1).build().unwrap());
        prop_assert!(closed.iter().all(|cell| is_drawn(&drawn, *cell)), "opening takes no cell away");
    }

    #[test]
    fn what_is_covered_by_its_own_copy_is_not_avoided(
        outlines in prop::collection::vec(outline(), 1..3),
        degrees in 0.0..360.0,
    ) {
        let turned = |outline: &Vec<Point>| {
            let mut polygon = Polygon::new(outline, 1);
            polygon.rotate(degrees);
            polygon.points
        };
        let scene: Vec<_> = outlines.iter().flat_map(|o| [(turned(o), 1), (turned(o), 2)]).collect();
        let fill = pg::FillRectangleParams::new(drawing(&scene))
            .fill_size((5, 5)).margin(3).include_layers(2).fill_layers(9).fill_densities(1).bbox([(0, 0), (40, 40)]);
        prop_assert_eq!(cells(&fill.build().unwrap()).len(), 64);
    }

    /// Boxes on a coarse lattice, so that edges often coincide; the region is known square by square.
    #[test]
    fn included_boxes_open_exactly_what_they_cover(
        boxes in prop::collection::vec((0..8_i32, 0..8_i32, 1..6_i32, 1..6_i32, any::<bool>()), 1..7),
        margin in prop_oneof![Just(0.0), 0.1..9.0],
        turned in any::<bool>(),
    ) {
        let scene: Vec<(Vec<Point>, u16)> = boxes.iter().map(|(x, y, w, h, open)| {
            let rect = Rect::new((5 * x, 5 * y), (5 * (x + w), 5 * (y + h)));
            let mut corners = rect.corners().to_vec();
            if turned { corners.reverse(); }
            (corners, if *open { 2 } else { 1 })
        }).collect();
        let fill = pg::FillRectangleParams::new(drawing(&scene))
            .fill_size((4, 3)).margin(margin).include_layers(2).fill_layers(9).fill_densities(1).bbox([(0, 0), (40, 40)]);
        let drawn = cells(&fill.build().unwrap());
        let covered = |x: i32, y: i32, wanted: bool| {
            boxes.iter().any(|(bx, by, w, h, open)| *open == wanted && (*bx..bx + w).contains(&x) && (*by..by + h).contains(&y))
        };
        let squares: Vec<Rect> = (0..14).flat_map(|x| (0..14).map(move |y| (x, y)))
            .filter(|(x, y)| covered(*x, *y, false) && !covered(*x, *y, true))
            .map(|(x, y)| Rect::new((5 * x, 5 * y), (5 * (x + 1), 5 * (y + 1))))
            .collect();
        for cell in raster(Size::new(4.0, 3.0), 10, 13) {
            let gap = |a: Rect, b: Rect| {
                let x = (b.min.x - a.max.x).max(a.min.x - b.max.x);
                let y = (b.min.y - a.max.y).max(a.min.y - b.max.y);
                if x <= 0.0 && y <= 0.0 { x.max(y) } else { x.max(0.0).hypot(y.max(0.0)) }
            };
            let near = squares.iter().map(|square| gap(cell, *square)).fold(f64::INFINITY, f64::min);
            if (near - margin).abs() > 1e-7 {
                prop_assert_eq!(is_drawn(&drawn, cell), near > margin, "{}: {}", cell, near);
            } else {
                prop_assert!(is_drawn(&drawn, cell), "{} keeps its margin exactly", cell);
            }
        }
    }
}
