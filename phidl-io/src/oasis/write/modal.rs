//! Modal variables of the writer: fields that are what the last record said are left out.

/// The modal variables that the writer uses. All coordinates are absolute.
#[derive(Debug, Default)]
pub(super) struct Modal {
    pub(super) placement: [i32; 2],
    pub(super) text: [i32; 2],
    pub(super) geometry: [i32; 2],
    pub(super) placement_cell: Option<u64>,
    pub(super) text_string: Option<u64>,
    pub(super) layer: Option<u16>,
    pub(super) datatype: Option<u16>,
    pub(super) textlayer: Option<u16>,
    pub(super) texttype: Option<u16>,
    pub(super) width: Option<u64>,
    pub(super) height: Option<u64>,
    pub(super) half_width: Option<u64>,
    /// The extension scheme of the last path with its lengths, as bytes.
    pub(super) extensions: Vec<u8>,
    /// Point lists and repetition, as bytes.
    pub(super) polygon: Vec<u8>,
    pub(super) path: Vec<u8>,
    pub(super) repetition: Vec<u8>,
    /// Name of the last property with its flag, and its values as bytes.
    pub(super) property: Option<(u64, bool)>,
    pub(super) values: Vec<u8>,
}

/// Sets a variable. Returns whether it has changed, and must be written.
pub(super) fn set<T: PartialEq>(variable: &mut Option<T>, value: T) -> bool {
    let changed = variable.as_ref() != Some(&value);
    *variable = Some(value);
    changed
}

/// Sets a variable that is kept as bytes. Returns whether it has changed, and must be written.
pub(super) fn set_bytes(variable: &mut Vec<u8>, bytes: &[u8]) -> bool {
    let changed = variable != bytes;
    if changed {
        variable.clear();
        variable.extend_from_slice(bytes);
    }
    changed
}
