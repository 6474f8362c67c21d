//! Exact numbers: rationals, and residues modulo a prime; and what is the same on every platform.
//!
//! Rationals come from `dashu-ratio`, whose integers stay in two machine words for as long as they fit.

mod multiples;
mod random;
mod residue;
mod root;
mod sine;

use dashu_int::ops::BitTest;
pub use dashu_ratio::RBig as Rational;
pub use multiples::common_angles;
pub use random::SplitMix64;
pub use residue::{Residue, circle_point, rotation_point};
pub use root::square_root;
pub use sine::{SINE_ERROR, sin_cos};

/// The most bits of an exact number that the engine computes, of numerator and denominator together: 1,200 digits, as
/// many as a cell may have. Where a number might get longer, an operation is left as it is written. Its value is
/// then known modulo a prime, and to as many digits as a rounding needs.
pub const MOST_BITS: usize = 4_000;

/// The number, or minus the number where `negate` holds.
pub(crate) fn negate_if<T: core::ops::Neg<Output = T>>(x: T, negate: bool) -> T {
    if negate { -x } else { x }
}

/// Whether the sum, the difference, the product and the quotient of two numbers have at most [`MOST_BITS`], except for
/// a bit that a sum may carry.
pub fn is_short(x: &Rational, y: &Rational) -> bool {
    bit_length(x) + bit_length(y) <= MOST_BITS
}

/// Bits of the numerator and the denominator together.
pub fn bit_length(x: &Rational) -> usize {
    x.numerator().bit_len() + x.denominator().bit_len()
}
