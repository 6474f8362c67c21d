//! The common part of tests, examples and measurements: reference values, the dynamics of a table in 31 digits, random
//! numbers and plots.

#![forbid(unsafe_code)]

pub mod columns;
pub mod exact;
pub mod five;
pub mod plot;
pub mod random;
pub mod references;
