//! Linear combinations of what the three stages have.

use crate::integrate::Phase;
use crate::size::Size;

/// Sum of three phases, each by its weight.
#[inline]
pub(super) fn combination<D: Size>(weights: &[f64; 3], of: &[Phase<D>; 3]) -> Phase<D> {
    of[0]
        .scaled(weights[0])
        .plus(weights[1], &of[1])
        .plus(weights[2], &of[2])
}

/// Three such sums, by the rows of a matrix.
pub(super) fn transformed<D: Size>(by: &[[f64; 3]; 3], of: &[Phase<D>; 3]) -> [Phase<D>; 3] {
    by.map(|row| combination(&row, of))
}
