//! How long something takes.

use std::time::{Duration, Instant};

/// Calls are timed in batches that take about this long, so that the clock itself does not count.
const BATCH: Duration = Duration::from_millis(5);

/// How many batches are timed at most; the shortest counts, as for the others.
const BATCHES: u32 = 15;

/// When this much time is gone, no further batch is begun.
const PATIENCE: Duration = Duration::from_secs(3);

/// The shortest time of a call (s) among some batches of calls. A first call, which fills caches, is not counted; what
/// a call returns is dropped within its time.
pub(crate) fn best<T>(work: impl FnMut() -> T) -> f64 {
    best_of_fresh(|| (), with_nothing(work))
}

/// The same where every call is given something new, which is made outside its time.
pub(crate) fn best_of_fresh<I, T>(mut input: impl FnMut() -> I, mut work: impl FnMut(I) -> T) -> f64 {
    let start = Instant::now();
    let mut batch = |count: u32| {
        let inputs: Vec<I> = (0..count).map(|_| input()).collect();
        let start = Instant::now();
        for input in inputs {
            std::hint::black_box(work(input));
        }
        start.elapsed() / count
    };
    batch(1);
    let mut shortest = batch(1);
    let calls = BATCH.as_nanos() / shortest.as_nanos().max(1);
    let count = u32::try_from(calls).unwrap_or(u32::MAX).clamp(1, 100_000);
    let mut rounds = 0;
    while rounds < BATCHES && start.elapsed() < PATIENCE {
        shortest = shortest.min(batch(count));
        rounds += 1;
    }
    shortest.as_secs_f64()
}

fn with_nothing<T>(mut work: impl FnMut() -> T) -> impl FnMut(()) -> T {
    move |()| work()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_call_takes_at_least_as_long_as_it_waits() {
        let seconds = best(|| std::thread::sleep(Duration::from_millis(2)));
        assert!(seconds >= 0.002);
    }

    #[test]
    fn every_call_gets_an_input_of_its_own() {
        let (mut made, mut seen) = (0, Vec::new());
        best_of_fresh(
            || {
                made += 1;
                made
            },
            |input| {
                seen.push(input);
                std::thread::sleep(Duration::from_millis(1));
            },
        );
        assert!(seen.iter().copied().eq(1..=made));
    }
}
