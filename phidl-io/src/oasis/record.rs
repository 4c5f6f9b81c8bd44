//! The kinds of records, by the numbers of the standard.

pub(super) const MAGIC: &[u8; 13] = b"%SEMI-OASIS\r\n";

pub(super) const PAD: u64 = 0;
pub(super) const START: u64 = 1;
pub(super) const END: u64 = 2;
pub(super) const CELLNAME: u64 = 3;
pub(super) const CELLNAME_NUMBERED: u64 = 4;
pub(super) const TEXTSTRING: u64 = 5;
pub(super) const TEXTSTRING_NUMBERED: u64 = 6;
pub(super) const PROPNAME: u64 = 7;
pub(super) const PROPNAME_NUMBERED: u64 = 8;
pub(super) const PROPSTRING: u64 = 9;
pub(super) const PROPSTRING_NUMBERED: u64 = 10;
pub(super) const LAYERNAME: u64 = 11;
pub(super) const LAYERNAME_OF_TEXTS: u64 = 12;
pub(super) const CELL_BY_NUMBER: u64 = 13;
pub(super) const CELL: u64 = 14;
pub(super) const XYABSOLUTE: u64 = 15;
pub(super) const XYRELATIVE: u64 = 16;
pub(super) const PLACEMENT: u64 = 17;
pub(super) const PLACEMENT_AT_ANY_ANGLE: u64 = 18;
pub(super) const TEXT: u64 = 19;
pub(super) const RECTANGLE: u64 = 20;
pub(super) const POLYGON: u64 = 21;
pub(super) const PATH: u64 = 22;
pub(super) const TRAPEZOID: u64 = 23;
pub(super) const TRAPEZOID_OF_A: u64 = 24;
pub(super) const TRAPEZOID_OF_B: u64 = 25;
pub(super) const CTRAPEZOID: u64 = 26;
pub(super) const CIRCLE: u64 = 27;
pub(super) const PROPERTY: u64 = 28;
pub(super) const PROPERTY_REPEATED: u64 = 29;
pub(super) const XNAME: u64 = 30;
pub(super) const XNAME_NUMBERED: u64 = 31;
pub(super) const XELEMENT: u64 = 32;
pub(super) const XGEOMETRY: u64 = 33;
pub(super) const CBLOCK: u64 = 34;

/// The length of an END record.
pub(super) const END_LENGTH: usize = 256;

/// The six tables of names, in the order of START and END.
pub(super) const TABLES: [&str; 6] = ["CELLNAME", "TEXTSTRING", "PROPNAME", "PROPSTRING", "LAYERNAME", "XNAME"];

/// Names of properties that the standard defines.
pub(super) mod standard {
    pub(in crate::oasis) const GDS_PROPERTY: &str = "S_GDS_PROPERTY";
    pub(in crate::oasis) const TOP_CELL: &str = "S_TOP_CELL";
    pub(in crate::oasis) const BOUNDING_BOXES_AVAILABLE: &str = "S_BOUNDING_BOXES_AVAILABLE";
    pub(in crate::oasis) const BOUNDING_BOX: &str = "S_BOUNDING_BOX";
    pub(in crate::oasis) const CELL_OFFSET: &str = "S_CELL_OFFSET";
}
