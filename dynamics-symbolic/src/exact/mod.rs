//! Exact numbers: rationals, and residues modulo a prime; and what is the same on every platform.
//!
//! Rationals come from `dashu-ratio`, whose integers stay in two machine words
//! for as long as they fit.

mod multiples;
mod random;
mod residue;
mod root;
mod sine;

use dashu_int::ops::BitTest;
pub use dashu_ratio::RBig as Rational;
pub use multiples::common_angles;
pub use random::SplitMix64;
pub use residue::{Residue, circle_point};
pub use root::square_root;
pub use sine::{SINE_ERROR, sin_cos};

/// Bits of the numerator and the denominator together.
pub fn bit_length(x: &Rational) -> usize {
    x.numerator().bit_len() + x.denominator().bit_len()
}
