//! The elements of a cell, one file for each kind; each has the reader and the writer of its records.

pub(super) mod boundary;
pub(super) mod box_element;
pub(super) mod fields;
pub(super) mod node;
pub(super) mod path;
pub(super) mod reference;
pub(super) mod text;
