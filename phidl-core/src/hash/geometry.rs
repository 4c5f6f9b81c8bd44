//! PHIDL's order-sensitive geometry hash (`Device.hash_geometry`), to the byte.

use std::collections::BTreeMap;

use sha1::{Digest as _, Sha1};

use crate::error::{Error, Result};
use crate::geom::Point;
use crate::layer::Layer;
use crate::scene::{Device, FLAT_LIMIT};

/// Shifts the boundaries between bins away from round numbers.
const OFFSET: f64 = 0.170_486_14;

/// SHA-1 over all polygons of the hierarchy; see [`Device::hash_geometry`].
pub(crate) fn geometry(device: &Device, precision: f64) -> Result<String> {
    if !(precision > 0.0 && precision.is_finite()) {
        let problem =
            format!("the precision of hash_geometry is {precision} µm, but it must be finite and greater than 0 µm");
        return Err(Error::invalid(device.name(), problem));
    }
    device.check_flat_size(FLAT_LIMIT)?;
    let mut whole = Sha1::new();
    for ((datatype, number), mut digests) in polygon_digests(device, precision) {
        whole.update(layer_digest(Layer::new(number, datatype)));
        digests.sort_unstable();
        for digest in &digests {
            whole.update(without_trailing_zeros(digest));
        }
    }
    Ok(whole.finalize().iter().map(|byte| format!("{byte:02x}")).collect())
}

/// The digests of all polygons by layer, ordered by datatype first.
fn polygon_digests(device: &Device, precision: f64) -> BTreeMap<(u16, u16), Vec<[u8; 20]>> {
    let mut digests: BTreeMap<(u16, u16), Vec<[u8; 20]>> = BTreeMap::new();
    for polygon in device.flat_polygons() {
        let Some(layer) = polygon.layer else { continue };
        let digest = polygon_digest(polygon.points(), precision);
        digests.entry((layer.datatype, layer.number)).or_default().push(digest);
    }
    digests
}

fn polygon_digest(points: impl Iterator<Item = Point>, precision: f64) -> [u8; 20] {
    let mut hash = Sha1::new();
    for p in points {
        for v in [p.x, p.y] {
            // Division, and truncation toward zero, as defined.
            #[expect(clippy::cast_possible_truncation, reason = "`as` truncates toward zero, which is what is defined")]
            let bin = (v / precision + OFFSET) as i64;
            hash.update(bin.to_le_bytes());
        }
    }
    hash.finalize().into()
}

fn layer_digest(layer: Layer) -> [u8; 20] {
    let mut hash = Sha1::new();
    hash.update(i64::from(layer.number).to_le_bytes());
    hash.update(i64::from(layer.datatype).to_le_bytes());
    hash.finalize().into()
}

/// PHIDL sorts digests in a NumPy array of byte strings, which drops trailing zeros.
fn without_trailing_zeros(digest: &[u8]) -> &[u8] {
    let end = digest.iter().rposition(|byte| *byte != 0).map_or(0, |last| last + 1);
    &digest[..end]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layer::Layers;

    /// PolygonStore with their layers.
    type Drawing<'a> = &'a [(&'a [(f64, f64)], Layers)];

    fn hash(polygons: Drawing<'_>, precision: f64) -> String {
        let mut d = Device::builder("hashed");
        for (points, layers) in polygons {
            d.add_polygon(points.to_vec(), layers).unwrap();
        }
        d.build().unwrap().hash_geometry(precision).unwrap()
    }

    /// Hashes that PHIDL 1.7.2 gives.
    #[test]
    fn hashes_are_those_of_the_reference() {
        let t: &[_] = &[(0., 0.), (1., 0.), (0., 1.)];
        let cases: &[(Drawing<'_>, &str)] = &[
            (&[(t, 0.into())], "a375d27406612477e92bf49e59db9d2a364cbe7b"),
            (&[(t, 1.into())], "386766e68f947c9edfd877496412720cdce8ca2a"),
            (&[(t, (0, 1).into())], "b3776c0d91fc3647afd250c6190c4bd46e7ea519"),
            (&[(t, 1.into()), (t, (0, 1).into())], "33f01f24f3cb3215530b98c43db941513a384468"),
            (&[(&[(0., 1.), (1., 0.), (0., 0.)], 0.into())], "d1797090bab6915f03b7ec796685ee44f8626fdc"),
            (&[(&[(1., 0.), (0., 1.), (0., 0.)], 0.into())], "13b4378452acbec39df78eba12b622ec17d112ff"),
            (&[(&[(-1., -1.), (1., -1.), (1., 1.), (-1., 1.)], 0.into())], "574e0f9144e0174458d427acdeb81bb044e7cc32"),
            (
                &[(&[(0.12345, 0.00006), (1.99999, -0.00003), (1., 1.)], 0.into())],
                "5891f58c1d3f32122c1389c5c374737c69434a00",
            ),
            (&[(&[(8., 6.), (6., 8.), (7., 9.), (9., 5.)], 0.into())], "c0629d2a7c557f72fad131ae8260df22c1df2d56"),
            (
                &[(&[(0., 0.), (1., 0.), (1., 1.)], 5.into()), (&[(0., 0.), (1., 0.), (1., 1.)], (1, 2).into())],
                "b08751752c757b4d50f560d0908d205b78f147a3",
            ),
        ];
        for (polygons, expected) in cases {
            assert_eq!(hash(polygons, 1e-4), *expected);
        }
    }

    #[test]
    fn digests_that_end_in_zeros_lose_them() {
        let thin = |x: f64| vec![(0., 0.), (x, 0.), (0., 1.)];
        let one = hash(&[(&thin(139.), 0.into())], 1e-4);
        assert_eq!(one, "c80ec50d81d3a7e029f4edd68c5b790b10769dac");
        let two = hash(&[(&thin(139.), 0.into()), (&thin(5.), 0.into())], 1e-4);
        assert_eq!(two, "ef813158c7c8408dc7c1feec7236ff39ccd7fe25");
        assert_eq!(hash(&[(&thin(62770.), 0.into())], 1e-4), "ee2cbb1c092464503ef8ea4e5340c943a31dc6d5");
    }

    #[test]
    fn a_coarser_precision_cuts_off_more() {
        let polygon: &[_] = &[(0.124, 1.748), (1., 0.), (0., 1.)];
        assert_eq!(hash(&[(polygon, 0.into())], 1e-2), "ffce6b85b36696590c78beebf7bc85060838a588");
    }

    #[test]
    fn a_cell_without_polygons_has_the_hash_of_nothing() {
        assert_eq!(hash(&[], 1e-4), "da39a3ee5e6b4b0d3255bfef95601890afd80709");
        assert!(Device::builder("a").build().unwrap().hash_geometry(0.0).is_err());
    }
}
