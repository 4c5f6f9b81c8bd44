//! OASIS (SEMI P39), read and written.

mod checksum;
mod cursor;
mod encode;
mod label;
mod point_list;
mod read;
mod record;
mod repetition;
mod trapezoid;
mod write;

pub use read::{Checksum, DecodeOptions, decode};
pub use write::{EncodeOptions, OasisReport, Shapes, Validation, encode};
