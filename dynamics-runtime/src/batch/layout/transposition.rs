//! From a vector of states for each number to a vector of numbers for each state.

use fearless_simd::{Simd, SimdBase};

use super::MOST_LANES;
use crate::batch::wide::{Precision, Wide, lanes};

/// The first vectors, as many as there are lanes, as a matrix that is transposed: lane `j` of `numbers[i]` becomes lane
/// `i` of vector `j`. The other vectors are of no use.
///
/// Shuffling the two halves of a deck of 2^k cards turns the k digits of each place by one. The places of all numbers
/// have the digits of i and then those of j: after as many shuffles as i has digits, those of j are first.
#[inline(always)]
pub(super) fn transposed<S: Simd, E: Precision>(
    numbers: &[Wide<S, E>],
) -> [Wide<S, E>; MOST_LANES] {
    let (lanes, half) = (lanes::<S, E>(), lanes::<S, E>() / 2);
    let mut deck = [numbers[0]; MOST_LANES];
    deck[..lanes].copy_from_slice(&numbers[..lanes]);
    for _ in 0..lanes.ilog2() {
        let old = deck;
        for i in 0..half {
            let (first, second) = (old[i].0, old[i + half].0);
            deck[2 * i] = Wide(first.zip_low(second));
            deck[2 * i + 1] = Wide(first.zip_high(second));
        }
    }
    deck
}

#[cfg(test)]
mod tests {
    use fearless_simd::dispatch;

    use super::*;
    use crate::sine::tests::levels;

    /// Number i of state j is 100 i + j.
    #[inline(always)]
    fn assert_transposed<S: Simd, E: Precision>(simd: S) {
        let lanes = lanes::<S, E>();
        let number = |i: usize, j: usize| E::from_f64((100 * i + j) as f64);
        let of_number = |i| Wide::<S, E>(E::Native::<S>::from_fn(simd, |j| number(i, j)));
        let numbers: Vec<_> = (0..lanes).map(of_number).collect();
        for (j, state) in transposed(&numbers)[..lanes].iter().enumerate() {
            let expected: Vec<_> = (0..lanes).map(|i| number(i, j)).collect();
            assert_eq!(state.0.as_slice(), expected);
        }
    }

    #[test]
    fn numbers_of_states_become_states_of_numbers() {
        for level in levels() {
            dispatch!(level, simd => assert_transposed::<_, f64>(simd));
            dispatch!(level, simd => assert_transposed::<_, f32>(simd));
        }
    }
}
