//! A radix sort by x, which decides most of the order of grid points.
//!
//! In a strip, few points share a grid column, or (in rectilinear drawings) many do, in runs. So numbers are sorted by
//! column with a radix sort of a few passes over small keys, and only runs of equal columns are compared exactly. A
//! comparison sort of whole segments took a fifth of an operation. The crates `radsort` and `rdst` sort by all eight bytes
//! of such keys; the columns of a strip need two or three passes.

use std::cmp::Ordering;

/// Bits of a key that one pass sorts by.
const DIGIT: u32 = 9;

/// Up to this many keys, a comparison sort is faster.
const FEW: usize = 200;

/// A number and its x, which is in the upper half.
type Key = u64;

/// Numbers in the order of an x each; those with equal x are in the order of `then`.
///
/// `then` has to compare x too: it also decides between numbers in adjacent columns if the range of x is wide.
pub(super) fn by_x(
    numbers: impl Iterator<Item = (u32, i64)> + Clone,
    mut then: impl FnMut(u32, u32) -> Ordering,
) -> Vec<u32> {
    let (mut low, mut high) = (i64::MAX, i64::MIN);
    for (_, x) in numbers.clone() {
        (low, high) = (low.min(x), high.max(x));
    }
    if low > high {
        return Vec::new();
    }
    let bits = 64 - (high - low).leading_zeros();
    let shift = bits.saturating_sub(32);
    #[expect(clippy::cast_sign_loss, reason = "no x is below the lowest")]
    let key = |(number, x): (u32, i64)| ((x - low) as u64 >> shift) << 32 | u64::from(number);
    let mut keys = radix_sorted(numbers.map(key).collect(), bits - shift);
    for run in keys.chunk_by_mut(|a, b| a >> 32 == b >> 32).filter(|run| run.len() > 1) {
        run.sort_unstable_by(|&a, &b| then(number(a), number(b)));
    }
    keys.into_iter().map(number).collect()
}

#[expect(clippy::cast_possible_truncation, reason = "the number is the lower half")]
fn number(key: Key) -> u32 {
    key as u32
}

/// Keys in the order of their upper halves, which have `bits` bits.
fn radix_sorted(mut keys: Vec<Key>, bits: u32) -> Vec<Key> {
    if keys.len() <= FEW {
        keys.sort_by_key(|key| key >> 32);
        return keys;
    }
    let passes = bits.div_ceil(DIGIT);
    let mut sorted = vec![0; if passes > 0 { keys.len() } else { 0 }];
    for pass in 0..passes {
        #[expect(clippy::cast_possible_truncation, reason = "a digit is small")]
        let digit = |key: Key| (key >> (32 + pass * DIGIT)) as usize % (1 << DIGIT);
        let mut positions = [0u32; 1 << DIGIT];
        keys.iter().for_each(|&key| positions[digit(key)] += 1);
        let mut sum = 0;
        for position in &mut positions {
            sum += std::mem::replace(position, sum);
        }
        for &key in &keys {
            let position = &mut positions[digit(key)];
            sorted[*position as usize] = key;
            *position += 1;
        }
        std::mem::swap(&mut keys, &mut sorted);
    }
    keys
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::MAX_COORDINATE;

    #[test]
    fn numbers_are_sorted_by_x_and_then_by_the_comparison() {
        for step in [1, 977, MAX_COORDINATE / 500] {
            let xs: Vec<i64> = (0..1000).map(|i| (i * 7919 % 1000 / 3) * step - 300 * step).collect();
            let numbered = (0u32..).zip(xs.iter().copied());
            let compare = |a: u32, b: u32| (xs[a as usize], b).cmp(&(xs[b as usize], a));
            let sorted = by_x(numbered, compare);
            assert_eq!(sorted.len(), xs.len());
            assert!(sorted.is_sorted_by(|&a, &b| compare(a, b).is_lt()), "{step}");
        }
        assert!(by_x(std::iter::empty(), |_, _| Ordering::Equal).is_empty());
        assert_eq!(by_x([(5, 3), (2, 3)].into_iter(), |a, b| a.cmp(&b)), [2, 5]);
    }
}
