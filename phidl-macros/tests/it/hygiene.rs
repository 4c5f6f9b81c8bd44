//! Names that the macro could collide with, and bodies that leave early.
#![allow(unused_qualifications, reason = "the path in `crate = …` may be longer than it needs to be here")]

use phidl_core::prelude::*;
use phidl_macros::device;

type Flag = bool;

#[device]
fn awkward(
    #[default(1)] self_: f64,
    #[default(2)] build: f64,
    #[default(3)] default: f64,
    #[default(4)] params: f64,
    #[default(5)] new: f64,
    #[default(6)] clone: f64,
    #[default(7)] record: f64,
    #[default(8)] from: f64,
    #[default(9)] value: f64,
    #[default(10)] entry: f64,
    #[default(11)] r#type: f64,
    #[default(12)] mut result: f64,
    #[default(false)] draw: Flag,
) -> Result<Device> {
    result += self_ + build + default + params + new + clone + record + from + value + entry + r#type;
    let d = Device::builder(format!("awkward_{result}"));
    if draw {
        return d.build();
    }
    let device = d.build()?;
    let build = device; // shadows a parameter
    Ok(build)
}

#[test]
fn parameters_may_have_any_name() {
    let defaults = AwkwardParams::default();
    assert_eq!(defaults.build().unwrap().name(), "awkward_78");
    assert_eq!(defaults.clone().r#type(12).build().unwrap().name(), "awkward_79");
    let names: Vec<_> = defaults.record().iter().map(|(name, _)| *name).collect();
    assert!(names.contains(&"type"), "{names:?}");
    assert_eq!(AwkwardParams { build: 3.0, ..defaults }.build().unwrap().name(), "awkward_79");
}

#[test]
fn generators_may_stand_in_functions_and_see_what_is_around_them() {
    const WIDTH: f64 = 3.0;
    fn helper() -> f64 {
        WIDTH
    }
    #[device]
    fn inner(#[default(helper())] width: f64) -> Result<Device> {
        Device::builder(format!("inner_{width}_{}", ONE)).build()
    }
    assert_eq!(InnerParams::default().build().unwrap().name(), "inner_3_1");
}

const ONE: i32 = 1;

/// Names of the prelude mean nothing to generated code.
mod shadowed {
    use phidl_core::scene::Device;
    use phidl_macros::device;

    #[allow(dead_code, reason = "only there to be in the way")]
    mod std {}
    #[allow(dead_code, reason = "only there to be in the way")]
    mod core {}
    #[allow(dead_code, reason = "only there to be in the way")]
    struct Option;
    #[allow(dead_code, reason = "only there to be in the way")]
    struct Vec;
    #[allow(dead_code, reason = "only there to be in the way")]
    trait Into {}
    #[allow(dead_code, reason = "only there to be in the way")]
    trait Default {}

    #[device]
    pub(super) fn lonely(#[default(1)] size: f64, #[default("a")] text: String) -> phidl_core::Result<Device> {
        Device::builder(format!("{text}{size}")).build()
    }
}

#[test]
fn generated_code_uses_no_name_of_the_users() {
    assert_eq!(shadowed::lonely(2, "b").unwrap().name(), "b2");
}

macro_rules! generators {
    ($($name:ident: $ty:ty = $default:expr;)*) => {$(
        #[device]
        fn $name(#[default($default)] v: $ty) -> Result<Device> {
            check.at_least("v", v, 1)?;
            Device::builder(format!("{}_{v}", stringify!($name))).build()
        }
    )*};
}

generators! {
    by_macro_one: f64 = 1;
    by_macro_two: usize = 2;
}

#[test]
fn generators_may_come_out_of_a_macro() {
    assert_eq!(by_macro_one(3).unwrap().name(), "by_macro_one_3");
    assert_eq!(by_macro_two(3).unwrap().name(), "by_macro_two_3");
    assert_eq!(by_macro_two(0).unwrap_err().to_string(), "by_macro_two: v is 0, but it must be at least 1");
}

/// The name in errors and the units are those of the registry, also in a function beside the body.
#[device(name = "R")]
fn with_rules(
    #[param(unit = "ohm", name = "R1")] r1: f64,
    #[default([])]
    #[param(unit = "um")]
    gaps: Vec<f64>,
) -> Result<Device> {
    fn no_narrow_gap(check: Check<'_>, gaps: &[f64]) -> Result<()> {
        gaps.iter().enumerate().try_for_each(|(i, gap)| check.at_least(&format!("gaps[{i}]"), *gap, 1))
    }
    check.less("R1", r1, 50)?;
    no_narrow_gap(check, &gaps)?;
    Device::builder("with_rules").build()
}

#[test]
fn the_body_finds_the_rules_of_its_generator() {
    let message = |params: WithRulesParams| params.build().unwrap_err().to_string();
    assert_eq!(message(WithRulesParams::new(50)), "R: R1 is 50 Ω, but it must be less than 50 Ω");
    assert_eq!(message(WithRulesParams::new(1).gaps([2, 0])), "R: gaps[1] is 0 µm, but it must be at least 1 µm");
}

/// A crate that passes phidl-core on under a name of its own, as `phidl` does.
mod facade {
    pub(super) use phidl_core::__private;
}

#[device(crate = facade)]
fn through_a_facade(#[default([1, 2])] list: Vec<f64>, #[default(None)] corner: Option<Corner>) -> Result<Device> {
    check.that("list", list.len(), list.len() < 3, "be short")?;
    Device::builder(format!("facade_{corner:?}")).build()
}

#[derive(Debug, Clone, Copy, PartialEq, phidl_macros::Choice)]
#[choice(crate = facade)]
enum Corner {
    Round,
}

#[test]
fn generated_code_reaches_the_runtime_through_another_crate() {
    assert_eq!(through_a_facade([1], Corner::Round).unwrap().name(), "facade_Some(Round)");
}

#[device(cell_name = "slot_W{width}_{L}")]
fn named_cells(width: f64, #[param(name = "L")] length: i64) -> Result<Device> {
    Device::builder(format!("slot_{length}")).build().inspect(|_| assert!(width > 0.0))
}

#[test]
fn a_template_names_the_cells_of_a_generator() {
    let device = named_cells(0.08, 3).unwrap();
    assert_eq!(device.source().unwrap().cell_name().as_deref(), Some("slot_W0p08_3"));
    assert_eq!(by_macro_one(3).unwrap().source().unwrap().cell_name(), None);
}
