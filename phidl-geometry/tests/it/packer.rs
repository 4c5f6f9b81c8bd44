//! Packing: no overlap, the spacing, the largest bin, and at least the density of the reference.
//!
//! The densities stated here are those of PHIDL 1.7.2 with rectpack 0.2.2: the area of the bounding boxes of the packed
//! devices over the area of the bin's bounding box, for cases measured on PHIDL (sizes in µm).

use phidl_core::prelude::*;
use phidl_geometry as pg;
use proptest::prelude::*;

fn rectangles(sizes: impl IntoIterator<Item = (f64, f64)>) -> Vec<Device> {
    sizes.into_iter().map(|size| pg::rectangle(size, 0).unwrap()).collect()
}

/// Thirty rectangles that PHIDL packed.
fn thirty() -> Vec<Device> {
    rectangles((0..30).map(|i| (f64::from(1 + i % 7), f64::from(1 + 3 * i % 5))))
}

fn boxes(bin: &Device) -> Vec<Rect> {
    bin.references().iter().map(|cell| cell.bbox().unwrap()).collect()
}

fn density(bin: &Device) -> f64 {
    boxes(bin).iter().map(Rect::area).sum::<f64>() / bin.bbox().unwrap().area()
}

/// The distance between two boxes along the axis with the larger distance.
fn gap(a: Rect, b: Rect) -> f64 {
    let along = |a_min: f64, a_max: f64, b_min: f64, b_max: f64| (b_min - a_max).max(a_min - b_max);
    along(a.min.x, a.max.x, b.min.x, b.max.x).max(along(a.min.y, a.max.y, b.min.y, b.max.y))
}

fn smallest_gap(bin: &Device) -> f64 {
    let boxes = boxes(bin);
    let pairs = (0..boxes.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    pairs.map(|(i, j)| gap(boxes[i], boxes[j])).fold(f64::INFINITY, f64::min)
}

/// The Mersenne Twister with which the reference makes the sizes of its own test: first 0.22199317, 0.87073231.
struct Twister {
    state: Vec<u32>,
    next: usize,
}

impl Twister {
    const SIZE: usize = 624;

    fn new(seed: u32) -> Self {
        let mut state = vec![seed];
        for i in 1..624_u32 {
            let last = state[state.len() - 1];
            state.push(1_812_433_253_u32.wrapping_mul(last ^ (last >> 30)).wrapping_add(i));
        }
        Self { state, next: Self::SIZE }
    }

    fn twist(&mut self) {
        for i in 0..Self::SIZE {
            let joined = (self.state[i] & 0x8000_0000) | (self.state[(i + 1) % Self::SIZE] & 0x7fff_ffff);
            let odd = if joined & 1 == 1 { 0x9908_b0df } else { 0 };
            self.state[i] = self.state[(i + 397) % Self::SIZE] ^ (joined >> 1) ^ odd;
        }
        self.next = 0;
    }

    fn word(&mut self) -> u32 {
        if self.next == Self::SIZE {
            self.twist();
        }
        let mut y = self.state[self.next];
        self.next += 1;
        y ^= y >> 11;
        y ^= (y << 7) & 0x9d2c_5680;
        y ^= (y << 15) & 0xefc6_0000;
        y ^ (y >> 18)
    }

    fn number(&mut self) -> f64 {
        let (a, b) = (f64::from(self.word() >> 5), f64::from(self.word() >> 6));
        (a * 67_108_864.0 + b) / 9_007_199_254_740_992.0
    }
}

/// The hundred ellipses and rectangles of the reference's own test.
fn hundred() -> Vec<Device> {
    assert!((Twister::new(5).number() - 0.221_993_17).abs() < 1e-8);
    let mut random = Twister::new(5);
    let mut pair = |n: u32| {
        let size = (random.number() * f64::from(n) + 2.0, random.number() * f64::from(n) + 2.0);
        let _moved_by = (random.number(), random.number());
        size
    };
    let ellipses: Vec<Device> = (0..50).map(|n| pg::ellipse(pair(n), 2.5, 0).unwrap()).collect();
    let rectangles = rectangles((0..50).map(pair));
    ellipses.into_iter().chain(rectangles).collect()
}

#[test]
fn thirty_rectangles_are_packed_at_least_as_densely_as_by_the_reference() {
    let square = pg::PackerParams::new(thirty()).spacing(0.5).bins().unwrap();
    let tall = pg::PackerParams::new(thirty()).spacing(0.5).aspect_ratio((1, 2)).sort_by_area(false).bins().unwrap();
    for (bins, reference) in [(square, 340.0 / (23.5 * 23.0)), (tall, 340.0 / (17.5 * 31.0))] {
        assert_eq!((bins.len(), bins[0].references().len()), (1, 30));
        assert!(density(&bins[0]) >= reference - 1e-9, "{} < {reference}", density(&bins[0]));
        assert_eq!(bins[0].info()["density"].as_f64(), Some(density(&bins[0])));
    }
}

#[test]
fn limited_bins_hold_at_least_what_those_of_the_reference_hold() {
    let bins = pg::PackerParams::new(thirty()).spacing(0.5).max_size((12, 12)).bins().unwrap();
    let reference = [105.0, 102.0, 86.0, 47.0]; // areas of the boxes in its four bins
    assert!(bins.len() <= reference.len());
    let mut held = (0.0, 0.0);
    for (bin, theirs) in bins.iter().zip(reference) {
        held = (held.0 + boxes(bin).iter().map(Rect::area).sum::<f64>(), held.1 + theirs);
        assert!(held.0 >= held.1, "after {held:?}");
        assert!(bin.size().width <= 11.5 + 1e-9 && bin.size().height <= 11.5 + 1e-9);
    }
    assert!((held.0 - 340.0).abs() < 1e-9);
}

#[test]
fn the_own_test_of_the_reference_is_packed_at_least_as_densely() {
    let params = pg::PackerParams::new(hundred()).spacing(1.25).aspect_ratio((1, 2)).density(1.5);
    let bins = params.bins().unwrap();
    assert_eq!((bins.len(), bins[0].references().len()), (1, 100));
    // 283.606350 × 501.478576 µm for boxes of 74558.134850 µm².
    assert!((boxes(&bins[0]).iter().map(Rect::area).sum::<f64>() - 74_558.134_850).abs() < 1e-4);
    assert!(density(&bins[0]) >= 0.524_236, "{}", density(&bins[0]));
    assert!(smallest_gap(&bins[0]) >= 1.25 - 1e-9);
}

#[test]
fn small_cases_end_where_the_reference_ends_apart_from_its_unit_slip() {
    let one = pg::PackerParams::new(rectangles([(10.0, 10.0)])).bins().unwrap();
    assert_eq!(boxes(&one[0]), [Rect::new((5, 5), (15, 15))]); // 5.05 there
    let mixed = rectangles([(3.0, 3.0), (10.0, 10.0), (4.0, 20.0), (1.0, 1.0)]);
    let mixed = pg::PackerParams::new(mixed).spacing(1).bins().unwrap();
    assert!(density(&mixed[0]) >= 190.0 / 300.0 - 1e-9);
    let eight = pg::PackerParams::new(rectangles([(10.0, 10.0); 8])).spacing(1).max_size((25, 25)).bins().unwrap();
    assert_eq!(eight.iter().map(|bin| bin.references().len()).collect::<Vec<_>>(), [4, 4]);
    let low = pg::arguments::PartialSize { width: None, height: Some(15.0) };
    let five = pg::PackerParams::new(rectangles([(10.0, 10.0); 5])).spacing(0).max_size(low).bins().unwrap();
    assert_eq!((five.len(), five[0].bbox()), (1, Some(Rect::new((0, 0), (50, 10)))));
}

#[test]
fn a_box_as_large_as_the_bin_fits() {
    for limit in [10.0, 10.3, 10.004] {
        let bins =
            pg::PackerParams::new(rectangles([(10.0, 10.0)])).spacing(0).max_size((limit, limit)).bins().unwrap();
        assert_eq!(bins.len(), 1);
    }
    let odd = pg::PackerParams::new(rectangles([(10.004, 3.0)])).spacing(0).max_size((10.004, 5.0)).bins().unwrap();
    assert!((odd[0].xmax() - 10.004).abs() < 1e-9);
}

#[test]
fn what_cannot_be_packed_is_named() {
    let message = |params: pg::PackerParams| params.bins().unwrap_err().to_string();
    let large = pg::PackerParams::new(rectangles([(1.0, 1.0), (12.0, 3.0)])).spacing(1).max_size((12.5, 20));
    assert_eq!(
        message(large),
        "packer: D_list[1] is 12 × 3 µm large, but it must fit into max_size with half of spacing around it"
    );
    let empty = Device::builder("nothing").build().unwrap();
    assert!(message(pg::PackerParams::new([empty])).contains("\"nothing\", which is empty"));
    assert!(message(pg::PackerParams::new(thirty()).density(1)).contains("density is 1"));
    assert!(pg::PackerParams::new(Vec::<Device>::new()).bins().unwrap().is_empty());
    assert!(pg::PackerParams::new(thirty()).spacing(f64::NAN).bins().is_err());
}

#[test]
fn extreme_numbers_end_in_a_result_or_an_error() {
    let params = || pg::PackerParams::new(thirty()).spacing(0.5);
    for extreme in [1e-300_f64, 1e-9, 1e9, 1e300] {
        for params in [
            params().precision(extreme),
            params().density(extreme.max(1.01)),
            params().aspect_ratio((extreme, 1.0)),
            params().spacing(extreme),
        ] {
            if let Ok(bins) = params.bins() {
                assert_eq!(bins.iter().map(|bin| bin.references().len()).sum::<usize>(), 30);
            }
        }
    }
}

#[test]
fn the_registered_packer_keeps_the_spacing_between_its_bins_too() {
    let packed = pg::PackerParams::new(thirty()).spacing(0.5).max_size((12, 12)).build().unwrap();
    let bins = packed.info()["bins"].as_f64().unwrap();
    assert_eq!(packed.references().len() as f64, bins);
    let frames: Vec<Rect> = packed.aliases().map(|(_, bin)| bin.bbox().unwrap()).collect();
    assert!(frames.windows(2).all(|pair| pair[1].min.x - pair[0].max.x >= 0.5 - 1e-9));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn packed_cells_keep_their_distance_and_their_bin(
        sizes in prop::collection::vec((0.003..20.0, 0.003..20.0), 1..40),
        (spacing, ratio, density) in (0.0..3.0, 0.3..3.0, 1.01..2.0),
        limits in (prop::option::of(24.0..60.0), prop::option::of(24.0..60.0)),
        (sort_by_area, precision) in (any::<bool>(), prop_oneof![Just(0.01), 0.001..0.5]),
    ) {
        let max_size = pg::arguments::PartialSize { width: limits.0, height: limits.1 };
        let params = pg::PackerParams {
            spacing, aspect_ratio: Size::new(ratio, 1.0), max_size, sort_by_area, density, precision,
            ..pg::PackerParams::new(rectangles(sizes.clone()))
        };
        let bins = params.bins().unwrap();
        let mut packed: Vec<(f64, f64)> = Vec::new();
        for bin in &bins {
            prop_assert!(smallest_gap(bin) >= spacing - 1e-9, "{} < {spacing}", smallest_gap(bin));
            let bbox = bin.bbox().unwrap();
            prop_assert!(bbox.min.x >= spacing / 2.0 - 1e-9 && bbox.min.y >= spacing / 2.0 - 1e-9);
            prop_assert!(bbox.max.x + spacing / 2.0 <= limits.0.unwrap_or(f64::INFINITY) + 1e-6);
            prop_assert!(bbox.max.y + spacing / 2.0 <= limits.1.unwrap_or(f64::INFINITY) + 1e-6);
            packed.extend(bin.references().iter().map(|cell| {
                let size = cell.device().size();
                (size.width, size.height)
            }));
        }
        let order = |a: &(f64, f64), b: &(f64, f64)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1));
        let mut given = sizes;
        given.sort_by(order);
        packed.sort_by(order);
        prop_assert_eq!(packed, given);
    }
}

#[test]
fn more_cells_than_can_be_packed_in_time_are_refused_before_packing() {
    let cell = pg::rectangle((1, 1), 0).unwrap();
    let error = pg::PackerParams::new(vec![cell; 4001]).bins().unwrap_err().to_string();
    assert_eq!(error, "packer: number of cells in D_list is 4001, but it must be at most 4000");
}
