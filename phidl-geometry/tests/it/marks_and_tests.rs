//! Laws of lithography marks, dies and electrical test structures, over the whole range of their parameters.

use std::collections::BTreeMap;

use phidl_core::param::ParamType;
use phidl_core::prelude::*;
use phidl_core::runtime::registry;
use phidl_geometry as pg;
use proptest::prelude::*;
use testkit::golden::merged_area;

use crate::outline::boxes;

/// Whether the rectangles hang together: each is reached from the first over shared edges or overlaps.
fn hang_together(rects: &[Rect]) -> bool {
    let mut reached = vec![false; rects.len()];
    let mut open = vec![0];
    while let Some(i) = open.pop() {
        reached[i] = true;
        let around = rects[i].grown(1e-9);
        open.extend((0..rects.len()).filter(|j| !reached[*j] && around.touches(&rects[*j])));
    }
    reached.into_iter().all(|reached| reached)
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * b.abs().max(1.0)
}

proptest! {
    #[test]
    fn steps_are_as_long_as_their_widths_and_spacings(
        widths in prop::collection::vec(0.05..20.0, 1..9),
        spacing in 0.1..20.0,
        height in 1.0..200.0,
    ) {
        let d = pg::litho_steps(widths.clone(), spacing, height, 1).unwrap();
        let total: f64 = widths.iter().sum::<f64>();
        // The label stands left of everything else.
        let rects: Vec<Rect> = boxes(&d, 1).into_iter().filter(|r| r.min.x >= 0.0).collect();
        let right = rects.iter().map(|r| r.max.x).fold(0.0, f64::max);
        prop_assert!(close(right, total + spacing * (widths.len() + 1) as f64));
        // Lines of one row and bars of the other fill a strip of half the height, once each, but for the first spacing.
        let area: f64 = rects.iter().map(Rect::area).sum();
        prop_assert!(close(area, height / 2.0 * (total + spacing * (widths.len() + 1) as f64)), "{area}");
    }

    #[test]
    fn stars_are_round_and_their_lines_equal(count in 1usize..40, width in 0.1..5.0_f64, diameter in 10.0..300.0_f64) {
        let d = pg::litho_star(count, width, diameter, 1).unwrap();
        prop_assert!(close(d.area(), count as f64 * width * diameter));
        let reach = (width / 2.0).hypot(diameter / 2.0);
        prop_assert!(d.flat_polygons().all(|line| line.points().all(|p| close(p.norm(), reach))));
    }

    #[test]
    fn calipers_have_equal_rows_of_notches(
        (width, height) in (0.2..9.0, 0.2..9.0),
        spacing in 0.0..9.0,
        notches in 0usize..12,
        offset in -0.5..0.5,
        row_spacing in 0.0..5.0,
    ) {
        let d = pg::litho_calipers((width, height), spacing, notches, offset, row_spacing, 1, 2).unwrap();
        let (upper, lower) = (boxes(&d, 1), boxes(&d, 2));
        prop_assert_eq!((upper.len(), lower.len()), (2 * notches + 2, 2 * notches + 2));
        let middle = notches as f64 * (width + spacing);
        // Both rows are symmetric about the middle notch.
        for row in [&upper, &lower] {
            let sum: f64 = row.iter().map(|r| r.min.x - middle).sum();
            prop_assert!(sum.abs() < 1e-9 * (1.0 + middle) * row.len() as f64);
        }
        let (top, bottom) = (d.ymax(), d.ymin());
        prop_assert!(close(top, 2.0 * height) && close(bottom, -2.0 * height - row_spacing));
    }

    #[test]
    fn ruler_marks_stand_on_the_axis_at_one_pitch(
        (height, width, spacing) in (0.1..9.0, 0.1..2.0, 0.1..9.0),
        scale in prop::collection::vec(0.5..4.0, 1..6),
        marks in 0usize..30,
    ) {
        let rects = boxes(&pg::litho_ruler(height, width, spacing, scale.clone(), marks, 1).unwrap(), 1);
        prop_assert_eq!(rects.len(), marks);
        for (i, mark) in rects.iter().enumerate() {
            prop_assert!(close(mark.min.x, spacing * i as f64) && mark.min.y == 0.0);
            prop_assert!(close(mark.max.x - mark.min.x, width));
            prop_assert!(close(mark.max.y, height * scale[i % scale.len()]));
        }
    }

    #[test]
    fn corner_marks_stay_in_the_die_and_mirror_onto_each_other(
        (x, y) in (100.0..20000.0_f64, 100.0..20000.0_f64),
        (width, length) in (1.0..20.0, 20.0..50.0),
    ) {
        let die = pg::BasicDieParams::default().size((x, y)).street_width(width).street_length(length).die_name("");
        let die = die.build().unwrap();
        let edge = Rect::new((-x / 2.0, -y / 2.0), (x / 2.0, y / 2.0));
        prop_assert_eq!(die.bbox(), Some(edge));
        prop_assert_eq!(boxes(&die, 99), [edge]);
        prop_assert!(close(die.area_by_layer()[&0.into()], 4.0 * width * (2.0 * length - width)));
        for line in [(0, 1), (1, 0)] {
            let mirrored = die.place().mirrored((0, 0), line);
            prop_assert_eq!(mirrored.bbox(), Some(edge));
        }
    }

    #[test]
    fn resistors_have_the_squares_that_they_tell_and_join_their_pads(
        (x, y) in (11.0..100.0_f64, 11.0..100.0_f64),
        squares in 3.0..3000.0_f64,
        width in 0.2..8.0_f64,
    ) {
        let Ok(d) = pg::test_res((x, y), squares, width, 0, 1, 2) else { return Ok(()) };
        let recorded = d.info()["num_squares"].as_f64().unwrap();
        let wire: Vec<Vec<Point>> =
            d.flat_polygons().filter(|p| p.layer == Some(0.into())).map(|p| p.points().collect()).collect();
        // No block of the wire covers another one, so its area counts its squares.
        prop_assert!((merged_area(&wire) / (width * width) - recorded).abs() < 1e-3 * recorded, "{recorded}");
        let all: Vec<Rect> = boxes(&d, 0).into_iter().chain(boxes(&d, 1)).collect();
        prop_assert!(hang_together(&all));
        prop_assert!(boxes(&d, 0).iter().all(|r| r.min.y > -1e-9 && r.max.y < y + 1e-9));
        let grounds_inside = boxes(&d, 2).iter().zip(boxes(&d, 1)).all(|(g, p)| p.grown(1e-9).contains(g.min) && p.grown(1e-9).contains(g.max));
        prop_assert!(grounds_inside);
        let rows = (y / (2.0 * width)).floor();
        prop_assert!(squares < 2.0 * rows + 2.0 || (recorded - squares).abs() < 1e-9 * squares);
    }

    #[test]
    fn via_chains_join_the_pads_through_every_via(vias in 0usize..80, wire in 1.0..20.0, via in 0.2..0.99, height in 200.0..500.0) {
        // The proportions that links turn exactly over their vias in.
        let spacing = 4.0 * wire;
        let d = pg::test_via(vias, wire, wire * via, spacing, (300, height), 0, 0, 1, 2, 3).unwrap();
        let (first, second, holes) = (boxes(&d, 1), boxes(&d, 2), boxes(&d, 3));
        let drawn = vias / 2 * 2;
        prop_assert_eq!((second.len(), holes.len()), (drawn / 2, drawn));
        prop_assert_eq!(d.info()["num_vias"].as_f64(), Some(drawn as f64));
        let inside = |wires: &[Rect], hole: &Rect| {
            wires.iter().any(|wire| wire.grown(1e-6).contains(hole.min) && wire.grown(1e-6).contains(hole.max))
        };
        prop_assert!(holes.iter().all(|hole| inside(&first, hole) && inside(&second, hole)));
        let all: Vec<Rect> = first.into_iter().chain(second).collect();
        prop_assert!(hang_together(&all));
        prop_assert!(d.ymin() > -1e-6 && d.ymax() < height + 1e-6);
    }

    #[test]
    fn combs_hang_on_the_top_pad_and_never_touch_the_meander_that_they_reach_into(
        (x, y) in (60.0..300.0_f64, 0.3..2.0_f64).prop_map(|(x, part)| (x, x * part)),
        width in 0.2..1.5_f64,
        gap in 0.2..3.0_f64,
    ) {
        let d = pg::test_comb((x, y), width, gap, 0, 1, 2, 3, 4).unwrap();
        let fingers_end = |r: &Rect| close(r.max.y, 0.8 * y) && close(r.max.x - r.min.x, width);
        let (fingers, rest): (Vec<Rect>, Vec<Rect>) = boxes(&d, 0).into_iter().partition(fingers_end);
        let (top_pad, wire): (Vec<Rect>, Vec<Rect>) = rest.into_iter().partition(|r| close(r.max.y, 1.8 * y));
        prop_assert_eq!(top_pad.len(), 1);
        for finger in &fingers {
            prop_assert!(top_pad[0].grown(1e-9).touches(finger), "{:?}", finger);
            prop_assert!(!wire.iter().any(|r| r.touches(&finger.grown(gap - 1e-6))), "{:?}", finger);
        }
        prop_assert!(hang_together(&wire), "the left pad is joined to the right one");
        prop_assert!(hang_together(&boxes(&d, 1)));
    }

    #[test]
    fn wires_with_a_narrow_place_join_the_pads_and_are_never_wider_than_their_leads(
        widths in prop::collection::vec((0.2..3.0_f64, 1.05..6.0_f64), 1..4),
        pad in 50.0..300.0_f64,
    ) {
        let narrow: Vec<f64> = widths.iter().map(|(narrow, _)| *narrow).collect();
        let wide: Vec<f64> = widths.iter().map(|(narrow, ratio)| narrow * ratio).collect();
        // A narrow place is shorter than 12 wide widths here.
        let gap = 12.0 * wide.iter().copied().fold(0.0, f64::max);
        let d = pg::test_ic(narrow.clone(), wide.clone(), (pad, pad), gap, 1, 2, 3).unwrap();
        let n = widths.len() as f64;
        prop_assert!(d.bbox().unwrap().max.distance((1.2 * pad * n, 2.0 * pad + gap).into()) < 1e-6);
        prop_assert!(hang_together(&boxes(&d, 1)));
        let metal: Vec<Vec<Point>> =
            d.flat_polygons().filter(|p| p.layer == Some(1.into())).map(|p| p.points().collect()).collect();
        let wires = merged_area(&metal) - 1.2 * n * pad * pad - n * pad * pad;
        prop_assert!(wires > gap * narrow.iter().sum::<f64>() && wires < gap * wide.iter().sum::<f64>());
    }
}

/// Numbers that people give by mistake.
const WILD: [f64; 9] = [0.0, -1.0, 1e-300, 1e300, f64::INFINITY, f64::NAN, 1e9, 0.5, 3.0];

#[test]
fn no_number_makes_a_shape_panic() {
    let shapes = [
        "C",
        "L",
        "basic_die",
        "compass_multi",
        "connector",
        "litho_calipers",
        "litho_ruler",
        "litho_star",
        "litho_steps",
        "polygon_ports",
        "tee",
        "test_comb",
        "test_ic",
        "test_res",
        "test_via",
    ];
    for shape in shapes {
        let entry = registry::find(shape).unwrap();
        let example = entry.example().unwrap();
        for (name, value) in example.iter() {
            for wild in WILD {
                let spoiled = match value {
                    Value::List(list) => Value::List(list.iter().map(|_| Value::from(wild)).collect()),
                    Value::Int(_) | Value::Float(_) => Value::from(wild),
                    _ => continue,
                };
                let mut params = example.by_name();
                params.insert((*name).to_owned(), spoiled);
                // Drawn or refused; not a panic, and nothing that is not finite.
                if let Ok(device) = entry.build(&params) {
                    assert!(
                        device.bbox().is_none_or(|b| b.min.is_finite() && b.max.is_finite()),
                        "{shape} {name} {wild}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_layer_that_is_left_out_leaves_the_others_as_they_are() {
    for name in ["test_comb", "test_ic", "test_res", "test_via"] {
        let entry = registry::find(name).unwrap();
        let layers: Vec<&str> = entry.params().iter().filter(|p| p.kind == ParamType::Layers).map(|p| p.name).collect();
        let numbered = layers.iter().zip(10..).map(|(layer, number)| ((*layer).to_owned(), Value::Int(number)));
        let all: BTreeMap<String, Value> = numbered.collect();
        let whole = entry.build(&all).unwrap();
        for (left_out, number) in layers.iter().zip(10_u16..) {
            let mut params = all.clone();
            params.insert((*left_out).to_owned(), Value::Null);
            let rest = entry.build(&params).unwrap();
            let others: Vec<Layer> = whole.layers().iter().copied().filter(|key| *key != number.into()).collect();
            assert_eq!(rest.layers(), others, "{name} without {left_out}");
            assert_eq!(outlines(&rest, &others), outlines(&whole, &others), "{name} without {left_out}");
        }
    }
}

fn outlines(d: &Device, layers: &[Layer]) -> Vec<(Option<Layer>, Vec<Point>)> {
    let kept = d.flat_polygons().filter(|polygon| polygon.layer.is_some_and(|layer| layers.contains(&layer)));
    kept.map(|polygon| (polygon.layer, polygon.points().collect())).collect()
}
