//! The common part of programs that measure: clocks, tables, drawings, the machine, and lines of records that many runs
//! write and a report reads.

#![forbid(unsafe_code)]

mod clock;
pub mod drawing;
mod fit;
pub mod machine;
pub mod records;
pub mod table;

pub use clock::{
    Comparison, Effort, children_seconds, median, median_of_runs, seconds, thread_seconds,
};
pub use fit::power;
