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

/// Bits of all exact numbers in the cells of a table, 50,000 digits. A table of 64 joints with every
/// cell a decimal of 17 digits has 160,000; where six joints share as many, expansion takes ten
/// seconds.
pub(crate) const MOST_BITS_IN_ALL: usize = 170_000;

/// Joints of a robot, those that are locked or follow others included; a base that moves counts as six of them, here and
/// below. The default set of functions of 64 joints, all cells full, takes ten seconds.
pub(crate) const MOST_JOINTS: usize = 64;

/// Fixed joints on the ways to all links of a file from those that move them: each is a place of a link's frame.
#[cfg(feature = "files")]
pub(crate) const MOST_PLACES: usize = 20_000;

/// Joints that follow others, for which a table has room without an allocator.
pub(crate) const MOST_FOLLOWERS: usize = 8;

/// Joints where a function is requested whose length grows with their square or cube, such as
/// `coriolis_matrix`: it takes ten seconds, all cells full, and has 180,000 operations.
pub(crate) const MOST_JOINTS_OF_LONG_FUNCTIONS: usize = 32;

/// Joints where a function is requested that has as many values as the cube of their number: a quarter
/// of a minute, and 57,000 operations for 7,000 values.
pub(crate) const MOST_JOINTS_OF_CUBIC_FUNCTIONS: usize = 12;

/// The same where the base moves: a quadruped has as many.
pub(crate) const MOST_OF_CUBIC_FUNCTIONS_ON_A_MOVING_BASE: usize = 18;

/// Such functions of one call, times the cube of the number of joints: two functions of 32 joints, all
/// six of 22. The two longest of 32 joints have 390,000 operations.
pub(crate) const MOST_LONG_FUNCTIONS: usize = 2 * MOST_JOINTS_OF_LONG_FUNCTIONS.pow(3);

/// Functions in all tuples of one call, times the number of joints: each is derived several times over.
/// Four of 64 joints, 36 of seven.
pub(crate) const MOST_PARTS: usize = 256;

/// Functions of frames in one call, times the number of joints: 64 of 64 joints. One that solves with M grows with the
/// square of that number, and counts as so many: one of 64 joints takes seconds and 130 MB, four of 30 are allowed.
pub(crate) const MOST_OF_FRAMES: usize = 4096;

/// Names that a message lists.
pub(crate) const MOST_LISTED: usize = 20;

/// Bytes of a file. The URDF files of arms have about 20,000; those with meshes written out are not read.
#[cfg(feature = "files")]
pub const MOST_BYTES: usize = 4_000_000;
