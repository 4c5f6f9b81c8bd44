//! Numbers: the one rounding rule, exact quarter turns, and how many points a curve gets.

pub mod angle;
pub mod count;
pub mod grid;
