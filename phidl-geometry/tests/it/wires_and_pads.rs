//! Laws of letters, tees, pads and polygons with ports, over the whole range of their parameters.

use pg::connect::PoleTaper;
use phidl_core::prelude::*;
use phidl_geometry as pg;
use proptest::prelude::*;

use crate::outline::{is_on_an_edge, is_simple};

fn outline(device: &Device) -> Vec<Point> {
    device.polygons().next().map(|polygon| polygon.points.to_vec()).unwrap_or_default()
}

fn near(a: Rect, b: Rect) -> bool {
    a.min.distance(b.min) < 1e-9 && a.max.distance(b.max) < 1e-9
}

proptest! {
    #[test]
    fn letters_are_simple_and_end_at_their_ports(width in 0.01..20.0_f64, x in 0.5..8.0_f64, y in 1.01..8.0_f64) {
        let (size, h) = ((width * x, width * y), width / 2.0);
        let l = pg::l(width, size, 0).unwrap();
        let c = pg::c(width, size, 0).unwrap();
        prop_assert!(near(l.bbox().unwrap(), Rect::new((-h, -h), size)));
        prop_assert!(near(c.bbox().unwrap(), Rect::new((-h, -h), (size.0, size.1 + h))));
        for letter in [l, c] {
            prop_assert!(is_simple(&outline(&letter)), "{:?}", outline(&letter));
            prop_assert!(letter.ports().all(|port| is_on_an_edge(&letter, port)));
        }
    }

    #[test]
    fn tees_are_simple_and_end_at_their_ports(
        (bar, stub) in (0.1..50.0_f64, 0.02..0.98_f64).prop_map(|(bar, part)| (bar, bar * part)),
        (height, length) in (0.1..50.0_f64, 0.1..50.0_f64),
        taper in prop_oneof![Just(None), Just(Some(PoleTaper::Straight)), Just(Some(PoleTaper::Fillet))],
    ) {
        let tee = pg::tee((bar, height), (stub, length), taper, 0).unwrap();
        prop_assert!(near(tee.bbox().unwrap(), Rect::new((-bar / 2.0, -length), (bar / 2.0, height))));
        prop_assert!(tee.polygons().all(|polygon| is_simple(polygon.points)));
        prop_assert!(tee.ports().all(|port| is_on_an_edge(&tee, port)));
        // A taper only ever adds to the sharp one, and less than the triangles.
        let (sharp, triangles) = (bar * height + stub * length, (bar - stub) * length / 2.0);
        prop_assert!(tee.area() >= sharp * (1.0 - 1e-12) && tee.area() <= (sharp + triangles) * (1.0 + 1e-12));
    }

    #[test]
    fn ports_of_a_side_lie_end_to_end_and_fill_it(x in 0.1..100.0_f64, y in 0.1..100.0_f64, counts in prop::array::uniform4(1usize..9)) {
        let sides = [("N", x), ("S", x), ("E", y), ("W", y)];
        let ports = sides.iter().zip(counts).map(|((side, _), count)| (*side, count));
        let pad = pg::compass_multi((x, y), ports, 0).unwrap();
        prop_assert!(pad.ports().all(|port| is_on_an_edge(&pad, port)));
        for ((side, length), count) in sides.into_iter().zip(counts) {
            let ends: Vec<(Point, Point)> =
                (1..=count).map(|i| pad.port(&format!("{side}{i}")).unwrap().endpoints()).collect();
            // To the right and upwards; looking out, that is from left to right on N and W only.
            let along = |end: &(Point, Point)| if side == "N" || side == "W" { *end } else { (end.1, end.0) };
            prop_assert!(ends.windows(2).all(|pair| along(&pair[0]).1.distance(along(&pair[1]).0) < 1e-9));
            let whole = along(&ends[0]).0.distance(along(&ends[count - 1]).1);
            prop_assert!((whole - length).abs() < 1e-9);
        }
    }

    #[test]
    fn ports_of_a_polygon_are_its_edges_and_look_out_of_it(
        radii in prop::collection::vec(1.0..9.0, 3..9),
        start in 0.0..360.0_f64,
        clockwise in any::<bool>(),
    ) {
        let step = 360.0 / radii.len() as f64;
        let mut star: Vec<Point> =
            radii.iter().enumerate().map(|(i, radius)| Point::polar(*radius, start + step * i as f64)).collect();
        if clockwise {
            star.reverse();
        }
        let d = pg::polygon_ports(star.iter().map(|p| p.x), star.iter().map(|p| p.y), 0).unwrap();
        prop_assert_eq!(d.ports().len(), star.len());
        for (i, port) in d.ports().enumerate() {
            let (from, to) = (star[i], star[(i + 1) % star.len()]);
            prop_assert!(port.midpoint().distance((from + to) / 2.0) < 1e-9);
            prop_assert!((port.width() - from.distance(to)).abs() < 1e-9);
            prop_assert!(port.normal().dot(to - from).abs() < 1e-9 * port.width());
            // Seen from the center of a star, every edge looks away.
            prop_assert!(port.normal().dot(port.midpoint()) > 0.0);
        }
    }

    #[test]
    fn connectors_look_both_ways_from_one_place(x in -1e3..1e3, y in -1e3..1e3, width in 0.0..50.0, turn in -720.0..720.0) {
        let d = pg::connector((x, y), width, turn).unwrap();
        let (one, two) = (d.port("1").unwrap(), d.port("2").unwrap());
        prop_assert_eq!((one.midpoint(), one.width()), (two.midpoint(), two.width()));
        prop_assert!((one.normal() + two.normal()).norm() < 1e-12);
    }
}
