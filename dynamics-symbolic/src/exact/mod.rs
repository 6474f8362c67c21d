//! Exact numbers: rationals, and residues modulo a prime.
//!
//! Rationals come from `dashu-ratio`, whose integers stay in two machine words
//! for as long as they fit.

mod random;
mod residue;

pub use dashu_ratio::RBig as Rational;
pub use random::SplitMix64;
pub use residue::{Residue, circle_point};
