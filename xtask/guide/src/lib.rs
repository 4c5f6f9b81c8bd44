//! The code of README.md and of the chapters in `docs/guide`, compiled and run by the documentation tests.
//!
//! The crate depends on `phidl` and on nothing else of ours, so it also shows that a program needs no more.

#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/first-chip.md")]
struct FirstChip;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/waveguides.md")]
struct Waveguides;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/routing.md")]
struct Routing;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/rust-for-python.md")]
struct RustForPython;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/guide/coming-from-phidl.md")]
struct ComingFromPhidl;
