//! What tests, examples and measurements share: reference values, the dynamics of a table in 31
//! digits, random numbers, plots and tables.

#![forbid(unsafe_code)]

pub mod exact;
pub mod machine;
pub mod plot;
pub mod random;
pub mod references;
pub mod table;
