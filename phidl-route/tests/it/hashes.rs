//! Hashes of routes, measured on PHIDL.

use phidl_core::prelude::*;
use phidl_path::{CrossSection, Section};
use phidl_route::PathType::{C, J, L, Manhattan, Straight, U, V, Z};
use phidl_route::{
    RouteSharpParams, RouteSmoothParams, RouteXyParams, SmoothOptions, route_quad, route_sharp, route_xy,
};

#[track_caller]
fn assert_hash(device: Result<Device>, expected: &str) {
    assert_eq!(device.unwrap().hash_geometry(1e-4).unwrap(), expected);
}

fn port(x: f64, y: f64, width: f64, orientation: f64) -> Port {
    Port::new((x, y), width, orientation)
}

/// A smooth route between two ports, with the reference's defaults.
fn smooth(a: (f64, f64, f64, f64), b: (f64, f64, f64, f64)) -> RouteSmoothParams {
    RouteSmoothParams::new(port(a.0, a.1, a.2, a.3), port(b.0, b.1, b.2, b.3))
}

fn corner() -> RouteSmoothParams {
    smooth((40., 0., 5., 180.), (0., -40., 5., 270.))
}

#[test]
fn quads_have_the_hashes_of_the_specification() {
    let (a, b) = (port(0., 0., 2., 0.), port(10., 5., 4., 180.));
    assert_hash(route_quad(&a, &b, None, None, 0), "edb5ef6107ef532744cff31a17b785b05a04aab7");
    assert_hash(route_quad(&a, &b, 1, 3, (2, 1)), "82ec40de6a029d2a2e00ff1b971caa1460c21d3a");
    let tilted = route_quad(port(30., 30., 20., 270.), port(0., 0., 20., 60.), None, None, 0).unwrap();
    assert_eq!((tilted.port("1").unwrap().orientation(), tilted.port("2").unwrap().orientation()), (90., 240.));
    assert_hash(Ok(tilted), "c42b130a3822aaefd368464d9e6558c750928b52");
}

#[test]
fn smooth_routes_have_the_hashes_of_the_specification() {
    assert_hash(corner().build(), "f7865e2b7f865a214b7847fdaa704d729842fde6");
    let arcs = corner().radius(1.7).width(2.5).smooth_options(SmoothOptions::arc()).layer(3);
    assert_hash(arcs.build(), "e47d0573b1c1adba357d7ea8f523f84425e474e4");
    let straight = smooth((-50., 0., 4., 90.), (-50., 50., 4., 270.)).path_type(Straight);
    assert_hash(straight.build(), "051c27aed3cbf01700aadd83cf2dc7304d0236cf");
    let l = smooth((30., 0., 4., 180.), (0., 50., 4., 270.)).path_type(L);
    assert_hash(l.build(), "f3b8ee6096184a6cae2f6dab7cda038c7f80ba4b");
    let u1 = smooth((50., 50., 2., 270.), (80., 50., 4., 270.)).path_type(U).radius(10).length1(50);
    assert_hash(u1.build(), "abfd2a4c8d3d1d388675dc613efacf369bbd7e4a");
    let u2 = smooth((50., 80., 4., 10.), (80., 130., 4., 190.)).path_type(U).length1(20);
    assert_hash(u2.build(), "21f43cfcbede169789b4808771286e368bb363ca");
    let j1 = smooth((100., 25., 4., 270.), (130., 50., 4., 180.)).path_type(J).length1(25).length2(10);
    assert_hash(j1.build(), "1b17edad12788318cc113a8e1e76893ae301e6ca");
    let j2 = smooth((115., 105., 5., 270.), (131., 130., 5., 180.)).path_type(J).length1(25).length2(30);
    assert_hash(j2.build(), "6872cc085a7f8829a8962cfe6b3ed53e253ac075");
}

#[test]
fn loops_and_slanted_routes_have_the_hashes_of_the_specification() {
    let c = |params: RouteSmoothParams, l1: i32, left: i32, l2: i32| {
        params.path_type(C).length1(l1).left1(left).length2(l2).build()
    };
    assert_hash(
        c(smooth((180., 35., 4., 90.), (178., 15., 4., 270.)), 15, 30, 15),
        "d9f1f76304ce01a775fe92b3ef662f26373fc2a6",
    );
    assert_hash(
        c(smooth((150., 105., 4., 90.), (180., 105., 4., 270.)), 25, -15, 25),
        "b894692aa396ccda7f28fdcb3727d0e814e97935",
    );
    let c3 = smooth((150., 170., 4., 0.), (175., 170., 4., 0.)).radius(4);
    assert_hash(c(c3, 10, 10, 10), "098cfe5cac505408cd4c78a1a239595d801904f2");
    let v = smooth((200., 50., 5., 284.), (230., 50., 5., 256.)).path_type(V);
    assert_hash(v.build(), "b8a5cb77ad0e35e367530168f3aa9c72b3538117");
    let z = smooth((280., 0., 4., 190.), (250., 50., 3., -10.)).path_type(Z).length1(30).length2(40);
    assert_hash(z.build(), "1332b33414a4362b9e83d11649b8ecaffe8604b0");
}

#[test]
fn widths_of_all_forms_have_the_hashes_of_the_specification() {
    let wide = || corner().radius(10);
    assert_hash(wide().width(2).build(), "ac1a98b28ad2da21801d16357c37cfc063774eec");
    assert_hash(wide().width((7, 1.5)).layer(1).build(), "e20f8208bec8f0d905cdf776706078158c34ec4f");
    let strip = |width: f64, offset: i32, layer: u16| Section::new(width).offset(offset).layer(layer);
    let guide = CrossSection::new().add(strip(1.0, 0, 4)).add(strip(2.5, 3, 5)).add(strip(2.5, -3, 5));
    assert_hash(wide().width(guide).build(), "51677103047d326c484f1209caa2a676eee29f40");
    let coarse = smooth((40., 0., 3., 180.), (0., -40., 3., 270.)).radius(10);
    let coarse = coarse.smooth_options(SmoothOptions::Arc { num_pts: 16.0 });
    assert_hash(coarse.build(), "f503b7ab43d73d50f1245a56313e9e44e1104908");
}

#[test]
fn bends_that_take_up_a_leg_leave_no_repeated_point() {
    // PHIDL's hash, 4fe2c0ec…, is that of an outline with two bends whose ends repeat each other but for
    // noise. Its box reaches to −62.500013: the noise is taken for a direction. See `path.extrude` in the table of differences.
    let j = corner().radius(10).path_type(J).length1(60).length2(20).build().unwrap();
    assert_eq!(j.polygons().next().unwrap().points.len(), 2158 - 2);
    let [min, max] = j.bbox().map(|b| [b.min, b.max]).unwrap();
    assert!(min.distance((-22.5, -62.5).into()) < 1e-9 && max.distance((40.0, 2.5).into()) < 1e-9, "{min} {max}");
    // With bends of half the size nothing repeats; drawn by the reference.
    let j = corner().path_type(J).length1(60).length2(20);
    assert_hash(j.build(), "3ee9b18251ab88d195c755b27c5429df586c2d75");
}

#[test]
fn sharp_routes_have_the_hashes_of_the_specification() {
    let (a, b) = (port(0., 0., 2., 0.), port(30., 20., 4., 270.));
    assert_hash(route_sharp(&a, &b, None, Manhattan, 0), "942eb0feabd544ac1a76ecc3102fca565ee8fba3");
    assert_hash(route_sharp(&a, &b, 3, Manhattan, 2), "a638af9c627aab6a66cee044682cffade7749fba");
    let below = port(30., -20., 4., 270.);
    assert_hash(route_sharp(&a, below, None, Manhattan, 0), "523386f731fb72d5d1fc00d47911c46df75f4705");
    let (a, b) = (port(0., 0., 5., 180.), port(40., -5., 5., 0.));
    assert_hash(route_sharp(&a, &b, None, Manhattan, 0), "7af5c53ed7ed049c7c91bad124c9821224cc4679");
    let c = RouteSharpParams::new(&a, &b).path_type(C).length1(10).length2(10).left1(-10);
    assert_hash(c.build(), "585db9d58fa1f8915bc9528b44162bae4b149872");
}

#[test]
fn a_tapered_sharp_route_has_the_points_of_the_specification() {
    let d = route_sharp(port(0., 0., 2., 0.), port(30., 20., 4., 270.), (3, 1), Manhattan, 0).unwrap();
    let expected = [(0., -1.5), (30.9, -0.9), (30.5, 20.), (29.5, 20.), (29.1, 0.9), (0., 1.5)].map(Point::from);
    let outline = d.polygons().next().unwrap().points;
    assert!(outline.len() == 6 && outline.iter().zip(expected).all(|(p, q)| p.distance(q) < 1e-9), "{outline:?}");
}

#[test]
fn stairs_have_the_hashes_of_the_specification() {
    let (a, b) = (port(0., 0., 2., 0.), port(30., 20., 4., 270.));
    assert_hash(route_xy(&a, &b, "xy", None, 0), "942eb0feabd544ac1a76ecc3102fca565ee8fba3");
    let d = RouteXyParams::new(&a, &b).build().unwrap();
    assert_eq!(d.port("2").unwrap().orientation(), 0.0);
    assert_hash(Ok(d), "202bbbf9c3dd9b8ac2aaaf72e0e8adbe3bb1e350");
    let (a, b) = (port(0., 0., 2., 90.), port(6., 5., 2., 270.));
    assert_hash(route_xy(&a, &b, "yyyxy", 0.1, 2), "2f95f4b922d8b1096df8f8b8fdfd62fafe63308f");
}
