//! The law that any bytes must obey when they are read as a file. The fuzz target of the repository (`fuzz/`) and the
//! tests call the same function.

use phidl_core::prelude::*;
use phidl_io::IoError;
use phidl_io::gds::{self, GdsOptions, ReadOptions};

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
    let options = GdsOptions { grid: import.grid, ..GdsOptions::default() };
    if let Ok(again) = gds::to_bytes(&import.device, &options) {
        let again = gds::read_bytes(&again, &ReadOptions::default());
        assert!(again.is_ok(), "what was written cannot be read: {}", again.unwrap_err().report());
    }
}
