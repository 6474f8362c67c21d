//! Trajectories as tables of comma-separated values.

mod columns;
mod mistake;
mod read;
mod rows;
mod write;

pub use mistake::{CsvError, CsvMistake};
#[doc(hidden)]
pub use write::shortest;

#[cfg(test)]
mod tests;
