//! The law that any bytes must obey when they are read as a file. The fuzz target of the repository (`fuzz/`) and the
//! tests call the same function.

use phidl_core::prelude::*;
use phidl_io::gds::{self, GdsOptions, ReadOptions};
use phidl_io::{IoError, Item};

/// More placements than this are not looked at one by one: a few bytes can place a cell a billion times.
const MOST_PLACEMENTS: usize = 1_000;

/// A device that can be walked, measured and written again, or an error that says where: the byte, or the cells.
pub(crate) fn reading_is_a_device_or_an_error(bytes: &[u8]) {
    let import = match gds::read_bytes(bytes, &ReadOptions::default()) {
        Ok(import) => import,
        Err(error) => {
            let text = error.report();
            assert!(!matches!(error, IoError::Malformed { .. }) || text.contains("byte"), "{text}");
            return;
        }
    };
    assert!(import.device.bbox().is_none_or(|b| b.min.is_finite() && b.max.is_finite()));
    if import.device.instances().take(MOST_PLACEMENTS).count() == MOST_PLACEMENTS {
        return;
    }
    assert!(import.device.flat_polygons().flat_map(|p| p.points().collect::<Vec<_>>()).all(Point::is_finite));
    let options = GdsOptions { grid: import.grid, allow_empty: true, ..GdsOptions::default() };
    match gds::to_bytes(&import.device, &options) {
        Ok(bytes) => {
            let again = gds::read_bytes(&bytes, &ReadOptions::default());
            let again = again.unwrap_or_else(|error| panic!("what was written cannot be read: {}", error.report()));
            let twice = gds::to_bytes(&again.device, &options).expect("what was read can be written");
            assert!(twice == bytes, "a file that is read and written again differs");
        }
        // The outline of a path may reach beyond 32 bits, and an array may be far off the grid.
        Err(IoError::OutOfRange { item, .. }) => assert!(matches!(*item, Item::Polygon { .. }), "{item}"),
        Err(IoError::Extent(_)) => {}
        Err(IoError::Refused { what, .. }) => assert_eq!(what, "array"),
        Err(error) => panic!("what was read cannot be written: {}", error.report()),
    }
    reencoding_a_layout_keeps_it(bytes);
}

/// A layout that was decoded is encoded without loss: the same bytes from the second time on.
fn reencoding_a_layout_keeps_it(bytes: &[u8]) {
    let layout = gds::decode_layout(bytes).expect("it was read before");
    if let Ok(first) = gds::encode_layout(&layout) {
        let again = gds::decode_layout(&first).expect("what was encoded can be decoded");
        assert!(gds::encode_layout(&again).expect("it was encoded before") == first);
    }
}
