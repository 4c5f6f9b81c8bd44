//! Frames that dies are drawn into.

mod basic_die;

pub use basic_die::{BasicDieParams, DieSide, TextLocation, basic_die};
