//! Bounds and rules: what is refused, with which message, and that the body does not run.

use phidl_core::prelude::*;
use phidl_macros::device;

#[device]
fn hairpin(
    #[default(0.2)]
    #[param(unit = "um", above = 0)]
    width: f64,
    #[default(0.6)]
    #[param(unit = "um")]
    pitch: f64,
    #[default(90)]
    #[param(unit = "deg", min = 0, below = 360)]
    angle: f64,
    #[default((4, 2))]
    #[param(unit = "um", min = 0)]
    size: Size,
    #[default([1, 2])]
    #[param(unit = "um", above = 0)]
    lines: Vec<f64>,
    #[default(None)]
    #[param(max = 10)]
    turns: Option<f64>,
    #[default((0, 0))] origin: Point,
) -> Result<Device> {
    check.greater("pitch", pitch, ("width", width))?;
    let _ = (angle, size, lines, turns, origin);
    Device::builder("hairpin").build()
}

fn refused(params: HairpinParams) -> String {
    let error = params.build().unwrap_err();
    assert!(matches!(error, Error::Param(_)), "{error:?}");
    error.to_string()
}

#[test]
fn numbers_out_of_their_bounds_are_named_with_unit_and_rule() {
    let ok = HairpinParams::default;
    let cases = [
        (ok().width(0), "hairpin: width is 0 µm, but it must be greater than 0 µm"),
        (ok().width(-1), "hairpin: width is -1 µm, but it must be greater than 0 µm"),
        (ok().angle(360), "hairpin: angle is 360°, but it must be less than 360°"),
        (ok().size((1, -2)), "hairpin: size.height is -2 µm, but it must be at least 0 µm"),
        (ok().lines([1, 2, 0]), "hairpin: lines[2] is 0 µm, but it must be greater than 0 µm"),
        (ok().turns(11), "hairpin: turns is 11, but it must be at most 10"),
        (ok().pitch(f64::NAN), "hairpin: pitch is NaN µm, but it must be finite"),
        (ok().origin((0.0, f64::INFINITY)), "hairpin: origin.y is inf, but it must be finite"),
    ];
    for (params, message) in cases {
        assert_eq!(refused(params), message);
    }
    assert!(ok().angle(0).turns(10).size((0, 0)).lines([0.5]).build().is_ok());
}

#[test]
fn a_rule_of_the_body_takes_the_unit_from_the_parameter() {
    assert_eq!(
        refused(HairpinParams { width: 0.35, pitch: 0.2, ..Default::default() }),
        "hairpin: pitch is 0.2 µm, but it must be greater than width, 0.35 µm"
    );
}

#[device]
fn outer(#[default(0.2)] width: f64) -> Result<Device> {
    HairpinParams::default().width(width).build()
}

#[test]
fn an_error_of_another_generator_tells_who_asked() {
    let error = outer(0).unwrap_err();
    assert_eq!(error.report(), "in outer: hairpin: width is 0 µm, but it must be greater than 0 µm");
}

#[test]
fn a_port_whose_placement_was_refused_is_refused_as_a_parameter_too() {
    #[device]
    fn with_port(port: Port) -> Result<Device> {
        let mut d = Device::builder("with_port");
        d.add_port("in", port)?;
        d.build()
    }
    let port = Port::new((0, 0), 1, 0);
    with_port(&port).unwrap();
    let moved = port.moved_by((f64::NAN, 0.0));
    assert_eq!(
        with_port(moved).unwrap_err().to_string(),
        "with_port: port is a port, but it must be placed with sound values, also by \"move_by\"",
        "the cell in the cache was drawn with a sound port"
    );
}
