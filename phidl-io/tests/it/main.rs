//! Integration tests: files written, read, damaged and compared.

mod damage;
mod damaged_records;
mod files;
mod foreign;
mod fuzzed;
mod fuzzed_oasis;
mod hierarchy;
mod layout;
mod lyp;
mod messages;
mod oasis;
mod oasis_damage;
mod round_trip;
mod weld;
mod weld_chains;
