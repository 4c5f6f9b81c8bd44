//! Generated code is free of warnings, in every form that is accepted and under strict lints.
#![deny(warnings, missing_docs, unreachable_pub, unused_qualifications, unused, rust_2018_idioms)]
#![deny(missing_debug_implementations, single_use_lifetimes, trivial_casts, trivial_numeric_casts, unused_results)]
#![deny(clippy::all, clippy::pedantic, clippy::allow_attributes_without_reason, clippy::unwrap_used)]
#![forbid(unsafe_code)]

use std::collections::BTreeMap;

use phidl_core::prelude::*;
use phidl_macros::{Choice, device};

/// How it ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Choice)]
enum Ending {
    Straight,
    #[choice("fillet")]
    Round,
}

/// Public generators stand in a module that is as public as a library's.
pub mod library {
    use super::{Device, Layers, Point, Port, Result, Size, device};

    /// Draws nothing.
    ///
    /// # Errors
    /// Never.
    #[device]
    pub fn documented(
        /// How wide it is.
        #[default(1)]
        #[param(unit = "um", above = 0)]
        width: f64,
        #[default((4, 2))] size: Size,
        #[default((0, 0))] origin: Point,
        #[default(0)] layer: Layers,
        #[default(None)]
        #[param(named, name = "P")]
        port: Option<Port>,
    ) -> Result<Device> {
        let _ = (width, size, origin, layer, port);
        Device::builder("documented").build()
    }

    /// Draws nothing, and is not to be called.
    ///
    /// # Errors
    /// Never.
    #[device]
    #[deprecated(note = "draw something")]
    #[doc(alias = "ancient")]
    #[doc(hidden)]
    pub fn old(width: f64) -> Result<Device> {
        let _ = width;
        Device::builder("old").build()
    }
}

/// With a lint that the body breaks.
#[device]
#[expect(clippy::no_effect_underscore_binding, reason = "it is tested here")]
fn expectation(#[default(1)] width: f64) -> Result<Device> {
    let _unused = 1 + 1;
    Device::builder(format!("expectation_{width}")).build()
}

#[cfg(not(test))]
#[device]
fn configured_out() -> NoSuchResult {}

#[device]
#[cfg(test)]
#[allow(clippy::unnecessary_wraps, reason = "carried over")]
fn configured() -> Result<Device> {
    Device::builder("configured").build()
}

/// Registered, and never called here.
#[device(no_cache, example = NeverCalledParams::new("x", 1))]
fn never_called(
    text: String,
    number: usize,
    #[default([1, 2])] lines: Vec<f64>,
    #[default([])] points: Vec<Point>,
    #[default([("N", 1)])] counts: BTreeMap<String, usize>,
    #[default(Ending::Round)] ending: Ending,
    #[default(None)] inner: Option<Ending>,
    #[default(true)] a: bool,
    #[default(true)] b: bool,
    #[default(true)] c: bool,
    #[default(true)] d: bool,
    #[default(library::DocumentedParams::default())] partial: Partial,
    #[default(1.5)] mut length: f64,
    #[allow(unused_variables, reason = "carried over")]
    #[default('x')]
    letter: char,
) -> Result<Device> {
    length += f64::from(u8::from(a && b && c && d));
    let all = (text, number, lines, points, counts, ending, inner, partial, length);
    Device::builder(format!("{all:?}")).build()
}

#[test]
fn every_form_compiles_without_a_warning_and_can_be_drawn() {
    let cells = [library::documented(1, (1, 2), (0, 0), 1), expectation(2), configured()];
    assert!(cells.into_iter().all(|cell| cell.is_ok()));
    assert_ne!(Ending::Straight, Ending::Round);
}
