//! How much one call may need: the limits that end a table which nobody wrote by hand in an error
//! within seconds and in little memory. All of them are far beyond the arms that are built.
//!
//! Time is that of the unoptimised macro, memory that of the compiler's process beside the usual.
//! `tests::limits` holds each of them to it. This crate has no hand in the compiler before it: rustc itself ends with
//! an overflow of its stack where it reads delimiters 100,000 deep (10,000 are read).

/// Tokens of a call. The table of 64 joints with every cell written takes 8,000.
pub(crate) const MOST_TOKENS: usize = 100_000;

/// Delimiters inside each other, anywhere in a call: each of them takes some kilobytes of the stack, because they are
/// read by recursion.
pub(crate) const DEEPEST_DELIMITERS: usize = 120;

/// Letters of a name: names are repeated in the documentation of every method.
pub(crate) const MOST_LETTERS: usize = 200;

/// Errors that are shown; reading ends at the last of them.
pub(crate) const MOST_ERRORS: usize = 64;

/// Digits of a number literal's mantissa: far more than any measured quantity has.
pub(crate) const MOST_DIGITS: usize = 100;

/// Parentheses, signs and functions inside each other in one value.
pub(crate) const DEEPEST_VALUE: usize = 100;

/// Terms of one value, the `let`s in it written out: rustc overflows its stack on expressions that are
/// nested about 800 deep.
pub(crate) const MOST_TERMS: usize = 500;

/// Terms of all values of a call, the `let`s in them written out. Each takes some hundred bytes, and
/// the engine's time grows with them.
pub(crate) const MOST_TERMS_IN_ALL: usize = 20_000;

/// Bits of the numerator and denominator of an exact number, 1,200 digits, beyond which the engine computes none
/// either. The smallest `f64` in 100 digits has 1,400 bits.
pub(crate) const MOST_BITS: usize = dynamics_symbolic::exact::MOST_BITS;

/// Bits of all exact numbers in the cells of a table, 75,000 digits. A table of 100 joints with every
/// cell a decimal of 17 digits has as many; where six joints share 50,000 digits, expansion takes ten
/// seconds.
pub(crate) const MOST_BITS_IN_ALL: usize = 250_000;

/// Fixed joints on the ways to all links of a file from those that move them: each is a place of a link's frame.
#[cfg(feature = "files")]
pub(crate) const MOST_PLACES: usize = 20_000;

/// Operations of all functions of a call, by [`Growth`](dynamics_symbolic::function::Growth). The default set has as many
/// of 125 joints, and `coriolis_matrix`, `regressor`, `inverse_dynamics_derivatives` and the default set together of 43.
/// They take half a minute to a minute. Memory grows with the longest function: 190 MB where these are of 38 joints, 780 MB
/// of the default set of 125.
pub(crate) const MOST_OPERATIONS: usize = 400_000;

/// Operations that a function in a tuple counts besides its own, for each joint: it is derived several times over. Four
/// functions of 64 joints are allowed, 36 of seven.
pub(crate) const OPERATIONS_OF_A_PART: usize = 1_100;

/// Operations that are derived in a second.
pub(crate) const OPERATIONS_IN_A_SECOND: usize = 8_000;

/// Names that a message lists.
pub(crate) const MOST_LISTED: usize = 20;

/// Bytes of a file. The URDF files of arms have about 20,000; those with meshes written out are not read.
#[cfg(feature = "files")]
pub const MOST_BYTES: usize = 4_000_000;
