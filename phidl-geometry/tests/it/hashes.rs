//! Hashes of shapes, measured on PHIDL.

use phidl_core::prelude::*;
use phidl_geometry as pg;
use phidl_geometry::connect::PoleShape;

#[track_caller]
fn assert_hash(device: Result<Device>, expected: &str) {
    assert_eq!(device.unwrap().hash_geometry(1e-4).unwrap(), expected);
}

#[test]
fn rectangles_have_the_hashes_of_the_specification() {
    assert_hash(pg::rectangle((4, 2), 0), "729832d93c8f0c9100ac8fe665894920bc47654a");
    assert_hash(pg::rectangle((4.5, 2), (3, 1)), "75833e2796434e479f9243834b31be5e036910d8");
    assert_hash(pg::rectangle((1.5, 2.7), [1, 2]), "d55ccf7adda486567f2cfa2558b3f378c7cecd4d");
    assert_hash(pg::rectangle((49, 1), 0), "a32deb9118b24590897a62838c4594d50501051d");
    assert_hash(pg::bbox([(-1, -1), (3, 4)], 0), "e04a2dc0457f4ae300e9d1235fde335362c8b454");
    assert_hash(pg::bbox([(0.0, 0.0), (1.0, 2.5)], 0), "3e5f0fc61f072d5a8322aeb08814db13132ed796");
    assert_hash(pg::straight((4, 2), 0), "729832d93c8f0c9100ac8fe665894920bc47654a");
    assert_hash(pg::straight((3, 7), 0), "46e7ae8c91579c7dcf8fbd5c84f1e120763f1c3c");
    assert_hash(pg::cross(10, 3, 0), "18470cb24843265fe42a283f1cde91cbc8a2abe2");
    assert_hash(pg::cross(25, 1, 1), "1590e1c3ed327d5a85e8813fa22ae6caf47f49ef");
    assert_hash(pg::compass((4, 2), 0), "efbe875c3fa4f7499d95d3a98fdba149cd5945b5");
}

#[test]
fn curves_have_the_hashes_of_the_specification() {
    assert_hash(pg::ellipse((10, 5), 2.5, 0), "f46840e01a8b8d292a23d4c651a064d65c563575");
    assert_hash(pg::ellipse((3, 7.5), 11, 0), "8a3ee6ae229793cde3fb305e79267e225c6d8070");
    assert_hash(pg::circle(10, 2.5, 0), "15a748245d7bdfd4987f081e1494b41096e9c95a");
    assert_hash(pg::circle(3, 7, 0), "20da2c6c87092eb627f5689c753bd31b12121285");
    assert_hash(pg::ring(10, 0.5, 2.5, 0), "66b57b1544c9c48d9babc107dc93e7b0bf378499");
    assert_hash(pg::ring(5, 1.5, 7, 0), "fdda16b946040773410b31e56308e264ca60fda5");
    assert_hash(pg::arc(10, 0.5, 45, 0, 2.5, 0), "a273d16c6c7daf4f80fcdfdd82514be2484d6349");
    assert_hash(pg::arc(2, 0.5, -100, 30, 4, 0), "670171a6020c35969e9db35fc6d12320f20f4180");
    assert_hash(pg::arc(10, 0.5, 360, 0, 2.5, 0), "eb985ef07068e07144de34810bd2b6a96761cb15");
}

#[test]
fn flagpoles_and_tapers_have_the_hashes_of_the_specification() {
    use phidl_geometry::connect::PoleTaper::Straight;
    for (shape, hash) in [
        (PoleShape::P, "9f116be64415e067f3a90b8c3b498c919f622687"),
        (PoleShape::Q, "6c22ae13bd1720a0a9d6781079a3e0bad0b00d71"),
        (PoleShape::B, "8c1f08fd4db1b09a7a920d1d5c16c9951693ee52"),
        (PoleShape::D, "738207216afe1b11d90ae657161a109b0f9f9f15"),
    ] {
        assert_hash(pg::flagpole((4, 2), (2, 1), shape, Some(Straight), 0), hash);
    }
    assert_hash(pg::flagpole((50, 25), (4, 8), PoleShape::P, None, 0), "b308344e076da727c8b3a51afe5a29405d5252be");
    assert_hash(pg::taper(10, None, None, 0), "a12f006ecef39e0c290c24c935a007f8b6e8fdaf");
    assert_hash(pg::taper(10, 6, 4, 0), "963f5407c9bb4788f5acfe2a1c4fd635c9efa75d");
    let port = Port::new((3, 4), 7, 90);
    assert_hash(pg::TaperParams::default().width2(2).port(port).build(), "9135d8a2f413319cda100ca072fae730c230a911");
}
