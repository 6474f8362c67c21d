//! Exact numbers: rationals, and residues modulo a prime.
//!
//! Rationals come from `dashu-ratio`, whose integers stay in two machine words
//! for as long as they fit.

mod random;
mod residue;

use dashu_int::ops::BitTest;
pub use dashu_ratio::RBig as Rational;
pub use random::SplitMix64;
pub use residue::{Residue, circle_point};

/// Bits of the numerator and the denominator together.
pub fn bit_length(x: &Rational) -> usize {
    x.numerator().bit_len() + x.denominator().bit_len()
}
