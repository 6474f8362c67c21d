//! Linear combinations of the phases of three stages.

use crate::integrate::Phase;

/// Sum of three phases, each by its weight.
pub(super) fn combination<const N: usize>(weights: &[f64; 3], of: &[Phase<N>; 3]) -> Phase<N> {
    of[0]
        .scaled(weights[0])
        .plus(weights[1], &of[1])
        .plus(weights[2], &of[2])
}

/// Three such sums, by the rows of a matrix.
pub(super) fn transformed<const N: usize>(by: &[[f64; 3]; 3], of: &[Phase<N>; 3]) -> [Phase<N>; 3] {
    by.map(|row| combination(&row, of))
}
