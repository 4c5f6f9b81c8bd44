//! Generators in parallel loops of rayon, whose workers take up unrelated jobs in the middle of a body.

use std::sync::atomic::{AtomicI64, Ordering};

use phidl_core::prelude::*;
use phidl_macros::device;
use rayon::prelude::*;

/// A body with a parallel loop in it, as a boolean has. In the middle of it, its worker takes up another job.
#[device]
fn hub(round: i64) -> Result<Device> {
    rayon::yield_now();
    let work: i32 =
        (0..64_i32).into_par_iter().with_max_len(1).map(|i| (0..2000).map(|k| (i * k) % 7).sum::<i32>()).sum();
    Device::builder(format!("hub_{}", i64::from(work) + round)).build()
}

#[device]
fn spoke(round: i64, number: i32) -> Result<Device> {
    let mut d = Device::builder(format!("spoke_{number}"));
    d.add(hub(round)?);
    let _: i32 = (0..16_i32).into_par_iter().with_max_len(1).sum();
    d.build()
}

fn spokes(threads: usize, round: i64) -> Vec<Device> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let spoke = |number| spoke(round, number).unwrap();
    pool.install(|| (0..64_i32).into_par_iter().with_max_len(1).map(spoke).collect())
}

#[test]
fn workers_that_take_up_each_others_jobs_neither_hang_nor_see_circles() {
    for (round, threads) in [1, 4].repeat(5).into_iter().enumerate() {
        let round = i64::try_from(round).unwrap();
        let hub_of = |spoke: &Device| spoke.references()[0].device().clone();
        let hub = hub(round).unwrap();
        assert!(spokes(threads, round).iter().all(|spoke| hub_of(spoke).same_cell(&hub)), "it is there already");
        let fresh = spokes(threads, round + 1000);
        assert!(fresh.iter().all(|spoke| hub_of(spoke).same_cell(&hub_of(&fresh[0]))), "the first one is kept");
    }
}

#[device]
fn endless(depth: i64) -> Result<Device> {
    RUNS.fetch_add(1, Ordering::SeqCst);
    endless(depth)
}

static RUNS: AtomicI64 = AtomicI64::new(0);

#[test]
fn a_real_circle_is_found_on_a_worker_too() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    let error = pool.install(|| endless(1)).unwrap_err();
    assert!(matches!(error.root(), Error::CyclicDependency { chain } if chain == &["endless", "endless"]), "{error:?}");
    assert_eq!(RUNS.load(Ordering::SeqCst), 2, "once on the worker, once apart from it");
}
