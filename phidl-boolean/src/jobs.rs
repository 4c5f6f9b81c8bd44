//! Job sizes: how much work justifies another thread.

/// Points whose work outweighs waking a thread, which takes some microseconds.
const WORTH: usize = 2048;

/// How many items of a list make one job for another thread, if all `items` have `points` points together.
///
/// Most booleans of a layout are tiny; without a minimum they would wait for threads longer than they work.
pub(crate) fn per_job(items: usize, points: usize) -> usize {
    (items.saturating_mul(WORTH) / points.max(1)).max(1)
}

/// The results of two jobs, on two threads if they process enough points.
pub(crate) fn both<A: Send, B: Send>(
    points: usize,
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    if points < WORTH { (a(), b()) } else { rayon::join(a, b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_items_are_jobs_of_their_own_and_small_ones_share_one() {
        assert_eq!(per_job(2, 1_000_000), 1);
        assert_eq!(per_job(1000, 4000), 512);
        assert!(per_job(2, 150) > 2 && per_job(0, 0) == 1);
    }
}
