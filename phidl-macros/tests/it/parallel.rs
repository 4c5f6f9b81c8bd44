//! Generators in parallel loops of rayon, whose workers run unrelated jobs in the middle of a body.

use phidl_core::prelude::*;
use phidl_macros::device;
use rayon::prelude::*;

/// A body with a parallel loop in it, as a boolean has. In the middle of it, its worker runs another job.
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
fn stolen_jobs_neither_hang_nor_count_as_cycles() {
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
    endless(depth)
}

#[device]
fn ping(round: i64) -> Result<Device> {
    pong(round)
}

#[device]
fn pong(round: i64) -> Result<Device> {
    ping(round)
}

#[test]
fn a_cycle_of_generators_is_found_on_a_worker_too() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
    for (error, names) in [
        (pool.install(|| endless(1)).unwrap_err(), vec!["endless", "endless"]),
        (pool.install(|| ping(1)).unwrap_err(), vec!["ping", "pong", "ping"]),
    ] {
        assert!(matches!(error.root(), Error::CyclicDependency { chain } if *chain == names), "{error:?}");
    }
}
