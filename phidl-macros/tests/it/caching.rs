//! Bodies are counted: "it was cached" is seen, not assumed.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Barrier;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use phidl_core::cache;
use phidl_core::prelude::*;
use phidl_macros::device;

/// A counter of body runs, one for each test, since tests run side by side.
macro_rules! count {
    ($counter:ident) => {
        static $counter: AtomicUsize = AtomicUsize::new(0);
    };
}

fn runs(counter: &AtomicUsize) -> usize {
    counter.load(Ordering::SeqCst)
}

fn square(counter: &AtomicUsize, size: f64) -> Result<Device> {
    counter.fetch_add(1, Ordering::SeqCst);
    let mut d = Device::builder("square");
    d.add_polygon([(0.0, 0.0), (size, 0.0), (size, size)], 1)?;
    d.build()
}

count!(ONCE);

#[device]
fn once(#[default(1)] size: f64) -> Result<Device> {
    square(&ONCE, size)
}

#[test]
fn a_parameter_set_is_drawn_once_however_it_is_written() {
    let first = once(2).unwrap();
    for again in [once(2.0), once(2_u8), OnceParams { size: 2.0 }.build(), OnceParams::default().size(2).build()]
        .map(Result::unwrap)
    {
        assert!(again.same_cell(&first));
    }
    assert_eq!(runs(&ONCE), 1);
    once(3).unwrap();
    assert_eq!(runs(&ONCE), 2);
}

count!(ZERO);

#[device]
fn zero(shift: f64) -> Result<Device> {
    square(&ZERO, 1.0 + shift)
}

#[test]
fn both_zeros_are_one_parameter_and_neighboring_floats_are_two() {
    assert!(zero(0.0).unwrap().same_cell(&zero(-0.0).unwrap()));
    assert_eq!(runs(&ZERO), 1);
    zero(0.3).unwrap();
    zero(0.1 + 0.2).unwrap();
    assert_eq!(runs(&ZERO), 3);
}

count!(CROWD);

#[device]
fn crowd(size: f64) -> Result<Device> {
    thread::sleep(std::time::Duration::from_millis(30)); // long enough for all to ask
    square(&CROWD, size)
}

#[test]
fn eight_threads_that_ask_at_once_get_one_cell() {
    let barrier = Barrier::new(8);
    let ask = || {
        barrier.wait();
        crowd(7).unwrap()
    };
    let cells = thread::scope(|scope| {
        let asking: Vec<_> = (0..8).map(|_| scope.spawn(ask)).collect();
        asking.into_iter().map(|thread| thread.join().unwrap()).collect::<Vec<_>>()
    });
    assert!(cells.iter().all(|cell| cell.same_cell(&cells[0])), "the first one is kept for all");
    let drawn = runs(&CROWD);
    assert!(crowd(7).unwrap().same_cell(&cells[0]));
    assert_eq!(runs(&CROWD), drawn, "from now on it is in the cache");
}

count!(BY_DEVICE);

#[device]
fn framed(content: Device) -> Result<Device> {
    BY_DEVICE.fetch_add(1, Ordering::SeqCst);
    let mut d = Device::builder("framed");
    d.add(content);
    d.build()
}

#[test]
fn devices_are_compared_by_all_they_hold() {
    let cell = |note: i32| {
        let mut d = Device::builder("content");
        d.info("note", note);
        d.build().unwrap()
    };
    assert!(framed(cell(1)).unwrap().same_cell(&framed(cell(1)).unwrap()), "equal content");
    assert_eq!(runs(&BY_DEVICE), 1);
    framed(cell(2)).unwrap();
    assert_eq!(runs(&BY_DEVICE), 2, "info counts");
}

count!(TWIN);

mod left {
    use super::*;

    #[device]
    pub(super) fn twin(#[default(1)] size: f64) -> Result<Device> {
        square(&TWIN, size)
    }
}

mod right {
    use super::*;

    #[device]
    pub(super) fn twin(#[default(1)] size: f64) -> Result<Device> {
        square(&TWIN, -size)
    }
}

#[test]
fn generators_of_the_same_name_do_not_share_cells() {
    assert!(!left::twin(1).unwrap().same_cell(&right::twin(1).unwrap()));
    assert_eq!(runs(&TWIN), 2);
}

count!(UNCACHED);

#[device(no_cache)]
fn uncached(#[default(1)] size: f64) -> Result<Device> {
    square(&UNCACHED, size)
}

count!(AROUND);

#[device]
fn around(#[default(1)] size: f64) -> Result<Device> {
    square(&AROUND, size)
}

#[test]
fn the_cache_can_be_left_out_by_the_generator_and_by_the_caller() {
    assert!(!uncached(1).unwrap().same_cell(&uncached(1).unwrap()));
    assert_eq!(runs(&UNCACHED), 2);
    let kept = around(1).unwrap();
    let fresh = cache::bypass(|| AroundParams::default().build().unwrap());
    assert!(!fresh.same_cell(&kept) && fresh == kept);
    assert!(around(1).unwrap().same_cell(&kept), "the one that was kept is still there");
    assert_eq!(runs(&AROUND), 2);
    let panicked = catch_unwind(|| cache::bypass(|| panic!("a bug")));
    assert!(panicked.is_err() && around(1).unwrap().same_cell(&kept), "a panic ends the bypass");
}

count!(FAILING);

#[device]
fn failing(#[default(1)] size: f64) -> Result<Device> {
    FAILING.fetch_add(1, Ordering::SeqCst);
    Err(Error::custom("failing", format_args!("{size} is not to its liking")))
}

#[test]
fn failures_are_not_stored() {
    for _ in 0..2 {
        assert_eq!(failing(4).unwrap_err().to_string(), "failing: 4 is not to its liking");
    }
    assert_eq!(runs(&FAILING), 2);
}

count!(SHAKY);

#[device]
fn shaky() -> Result<Device> {
    assert!(SHAKY.fetch_add(1, Ordering::SeqCst) > 0, "a bug in the first run");
    Device::builder("shaky").build()
}

#[test]
fn a_body_that_panicked_can_be_run_again_by_the_same_thread() {
    assert!(catch_unwind(AssertUnwindSafe(shaky)).is_err());
    assert!(shaky().is_ok(), "it is no longer on the stack of this thread");
}

#[test]
fn hits_and_misses_are_counted() {
    #[device]
    fn counted(size: f64) -> Result<Device> {
        Device::builder(format!("counted_{size}")).build()
    }
    let before = cache::stats();
    counted(1).unwrap();
    counted(1).unwrap();
    let after = cache::stats();
    // Other tests run at the same time and count, too.
    assert!(after.hits > before.hits && after.misses > before.misses);
    assert!(after.entries > 0 && after.bytes > 0);
}
