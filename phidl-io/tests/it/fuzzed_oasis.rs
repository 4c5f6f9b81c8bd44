//! The law that any bytes must obey when they are read as an OASIS file. The fuzz target of the repository (`fuzz/`) and the
//! tests call the same function.

use phidl_io::IoError;
use phidl_io::model::Layout;
use phidl_io::oasis::{DecodeOptions, EncodeOptions, decode, encode};

/// A layout that can be written and read again, or an error that says where: the byte.
pub(crate) fn an_oasis_file_is_a_layout_or_an_error(bytes: &[u8]) {
    let layout = match read(bytes) {
        Ok(layout) => layout,
        Err(error) => {
            let text = error.report();
            assert!(text.contains("byte"), "{text}");
            return;
        }
    };
    // Paths that the format does not have become polygons at the first time, and find their group at the second.
    let first = written(&read(&written(&layout)).expect("what was written can be read"));
    let second = written(&read(&first).expect("what was written can be read"));
    assert!(first == second, "a file that is read and written again differs");
}

/// Few copies and bytes, so that a case takes no time.
fn read(bytes: &[u8]) -> Result<Layout, IoError> {
    let options = DecodeOptions { max_bytes: 1 << 24, max_elements: 1 << 16, ..DecodeOptions::default() };
    decode(bytes, "these bytes", &options)
}

fn written(layout: &Layout) -> Vec<u8> {
    encode(layout, &EncodeOptions { compress: false, ..EncodeOptions::default() }).expect("the options are sound").0
}
