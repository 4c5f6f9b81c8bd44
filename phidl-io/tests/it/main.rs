//! Integration tests: files written, read, damaged and compared.

mod damage;
mod damaged_records;
mod files;
mod foreign;
mod fuzzed;
mod hierarchy;
mod lyp;
mod messages;
mod round_trip;
mod weld;
mod weld_chains;
