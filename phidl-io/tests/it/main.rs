//! Integration tests: files written, read, damaged and compared.

mod damage;
mod files;
mod foreign;
mod fuzzed;
mod hierarchy;
mod lyp;
mod round_trip;
mod weld;
mod weld_chains;
