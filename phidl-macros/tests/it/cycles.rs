//! Generators that need their own cell.

use std::sync::{Barrier, OnceLock};
use std::thread;

use phidl_core::prelude::*;
use phidl_macros::device;

fn chain_of(error: &Error) -> Vec<&str> {
    match error.root() {
        Error::CyclicDependency { chain } => chain.iter().map(String::as_str).collect(),
        other => panic!("expected a cycle, got {other}"),
    }
}

#[device]
fn snake(length: i64) -> Result<Device> {
    if length > 100 {
        return snake(length);
    }
    let mut d = Device::builder("snake");
    if length > 0 {
        d.add(snake(length - 1)?);
    }
    d.build()
}

#[test]
fn a_generator_may_call_itself_with_other_parameters_only() {
    assert_eq!(snake(3).unwrap().references().len(), 1);
    assert_eq!(chain_of(&snake(101).unwrap_err()), ["snake", "snake"]);
}

#[device]
fn tower(#[default(0)] levels: i64) -> Result<Device> {
    let mut d = Device::builder("tower");
    d.add(tower(levels + 1)?);
    d.build()
}

#[test]
fn bodies_inside_each_other_are_counted_before_the_stack_overflows() {
    let error = TowerParams::default().build().unwrap_err();
    let message = "tower: generators call each other more than 256 levels deep";
    assert_eq!(error.root().to_string(), message);
}

#[device(no_cache)]
fn fresh_snake(#[default(1)] length: i64) -> Result<Device> {
    fresh_snake(length)
}

#[test]
fn a_cycle_is_found_without_the_cache_too() {
    assert_eq!(chain_of(&fresh_snake(1).unwrap_err()), ["fresh_snake", "fresh_snake"]);
}

#[device]
fn hen(#[default(1)] n: i64) -> Result<Device> {
    egg(n)
}

#[device]
fn egg(#[default(1)] n: i64) -> Result<Device> {
    nest(n)
}

#[device]
fn nest(#[default(1)] n: i64) -> Result<Device> {
    hen(n)
}

#[test]
fn the_chain_names_every_generator_of_the_cycle() {
    let error = hen(1).unwrap_err();
    assert_eq!(chain_of(&error), ["hen", "egg", "nest", "hen"]);
    assert_eq!(error.root().to_string(), "a generator needs its own cell: hen → egg → nest → hen");
}

/// Meets the other body, so that both threads have begun before either asks.
fn meet() {
    static MEETING: OnceLock<Barrier> = OnceLock::new();
    MEETING.get_or_init(|| Barrier::new(2)).wait();
}

#[device]
fn yin() -> Result<Device> {
    meet();
    yang()
}

#[device]
fn yang() -> Result<Device> {
    meet();
    yin()
}

#[test]
fn two_threads_that_draw_the_same_cycle_both_report_it() {
    let (one, other) = thread::scope(|scope| {
        let (one, other) = (scope.spawn(yin), scope.spawn(yang));
        (one.join().unwrap(), other.join().unwrap())
    });
    for error in [one.unwrap_err(), other.unwrap_err()] {
        let chain = chain_of(&error).join(" ");
        assert!(["yin yang yin", "yang yin yang"].contains(&chain.as_str()), "{chain}");
    }
}
