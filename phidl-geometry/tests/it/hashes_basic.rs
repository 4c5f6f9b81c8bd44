//! Geometry hashes of shapes, measured on PHIDL.

use std::collections::BTreeMap;

use phidl_core::param::Value;
use phidl_core::runtime::registry;
use phidl_geometry as _;
use serde::Deserialize;
use serde_json::{Value as Json, json};

fn hash(shape: &str, params: Json) -> String {
    let params = BTreeMap::<String, Value>::deserialize(params).unwrap();
    registry::find(shape).and_then(|entry| entry.build(&params)).and_then(|d| d.hash_geometry(1e-4)).unwrap()
}

fn assert_hashes(table: &[(&str, Json, &str)]) {
    for (shape, params, expected) in table {
        assert_eq!(hash(shape, params.clone()), *expected, "{shape} {params}");
    }
}

#[test]
fn wires_and_pads_have_the_hashes_of_the_specification() {
    assert_hashes(&[
        ("L", json!({}), "fc8e0a442ddc6f348876c14da19fcdaf0024705a"),
        ("L", json!({"width": 7, "size": [10, 20]}), "2d5392b3c0b80d42181b01b439de2c2c0f2afdde"),
        ("C", json!({}), "c021f4b8dc8bcdad6ccc48bd3eb00d2895f7ac98"),
        ("C", json!({"width": 7, "size": [10, 20]}), "aa9ed1464eb390ca55f0afca5531356515f4f2bf"),
        (
            "compass_multi",
            json!({"size": [40, 20], "ports": {"N": 3, "S": 4, "E": 1, "W": 8}}),
            "15d51ae69bdf8cf006b5da5b21d51de0783b0095",
        ),
        ("tee", json!({}), "e01743713cd79875b38f8b92a4ee6b1cd3001fc4"),
        (
            "tee",
            json!({"size": [40, 20], "stub_size": [10, 5], "taper_type": "straight"}),
            "617648b9c524e47f1ece4b8a1c119f91bf5c0550",
        ),
        (
            "polygon_ports",
            json!({"xpts": [-1, -1, 0, 0], "ypts": [0, 1, 1, 0]}),
            "7343db7425f5bf279fa28aea8fc59ca5643dfc61",
        ),
        ("polygon_ports", json!({"xpts": [0, 4, 1], "ypts": [0, 1, 3]}), "5633ccb71af37775efe6ee4cbf1e374a242e5c86"),
    ]);
}

#[test]
fn lithography_marks_and_dies_have_the_hashes_of_the_specification() {
    assert_hashes(&[
        ("litho_star", json!({}), "f34db6f9061cf992b52bd5ba70e61a9eef7b5011"),
        (
            "litho_star",
            json!({"num_lines": 20, "line_width": 0.4, "diameter": 20}),
            "098a95089642d737d6e726ba759567a590f39e04",
        ),
        ("litho_calipers", json!({}), "98635571c4ebce7d92147d1b22a3fdc1e8c2e422"),
        (
            "litho_calipers",
            json!({"notch_size": [1, 5], "num_notches": 7, "row_spacing": 3}),
            "2e2be046eb96eadd8c7239e836114856f0c786c4",
        ),
        ("litho_ruler", json!({}), "7d060045624794d370231de56fd02c05327b4e41"),
        ("litho_ruler", json!({"width": 0.25, "spacing": 1}), "e9b0bf65eed37841643ca577640aa29843e5e18c"),
        ("basic_die", json!({"die_name": ""}), "e5c9464d12727444c7cbe29b4f325c2b191f5909"),
        (
            "basic_die",
            json!({"die_name": "", "size": [10000, 5000], "draw_bbox": false}),
            "ae3db8012964b73c61cdfac9eacb311fc208b971",
        ),
        (
            "basic_die",
            json!({"die_name": "", "street_width": 50, "street_length": 500, "layer": 3, "bbox_layer": [7, 1]}),
            "6cde7345faadc220c08ac9866d239011667becf0",
        ),
    ]);
}

#[test]
fn electrical_tests_have_the_hashes_of_the_specification() {
    let small = json!([100, 100]);
    assert_hashes(&[
        ("test_via", json!({}), "e9a26b65ad7bb4db44f372ef6fcb0838e5141c9a"),
        ("test_via", json!({"num_vias": 54}), "ca0fe75537bd4be6bce28e436479826826a646bc"),
        (
            "test_via",
            json!({"num_vias": 12, "pad_size": small, "wire_width": 8}),
            "484e38524adc05eba62efe7aa5d1921a6ad96b74",
        ),
        (
            "test_via",
            json!({"num_vias": 10, "pad_size": small, "min_pad_spacing": 800}),
            "5c33fa17d6b9ab043b94d936dfd36d2c5f567d88",
        ),
        (
            "test_via",
            json!({"num_vias": 8, "pad_size": small, "via_spacing": 30}),
            "9c799eeb4394bdb444068efa628f00e8b04ef607",
        ),
        ("test_via", json!({"num_vias": 0}), "ae581abdb35333ad653fcd060ee8671df59201e3"),
        ("test_comb", json!({}), "509b6a45e350d47ff06c8d5ad4d13790d3f37e56"),
        (
            "test_comb",
            json!({"pad_size": [175, 175], "wire_width": 2, "wire_gap": 5}),
            "303e2f847fbac5d5a0a6e9c93a234a921cdc7029",
        ),
        ("test_comb", json!({"pad_size": [100, 200]}), "1831a6931459cc919207100420018bce859a4b54"),
        (
            "test_comb",
            json!({"pad_size": [40, 40], "wire_width": 1, "wire_gap": 1}),
            "ebb3003fd8d77ac0f9ac4a6a1add611a96ff653b",
        ),
        ("test_ic", json!({}), "a2e7448c2026ad204cf6952cbab96511255ffbba"),
        (
            "test_ic",
            json!({
                "wire_widths": [5, 10, 20], "wire_widths_wide": [20, 40, 60], "pad_size": small, "pad_gap": 150,
                "wire_layer": 0, "pad_layer": 1, "gnd_layer": 2
            }),
            "19304b13e54f25542fd74771c9f64868bffddd3b",
        ),
        ("test_res", json!({}), "464324776b21cb3f9f587932e7450117a47832e0"),
        ("test_res", json!({"pad_size": [20, 20], "num_squares": 100}), "ff4acb57bfc924f7eee46edab84b70287f8229de"),
        ("test_res", json!({"pad_size": [20, 20], "num_squares": 30}), "069828c908e3c0a38d291a27fc2b8d9adce16afc"),
    ]);
}
