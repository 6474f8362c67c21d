//! Texts that the command `robot-dynamics` writes, for other programs: the page of a robot, its functions in Rust, and the cells of its table.
#![forbid(unsafe_code)]

pub mod cell;
pub mod page;
pub mod poses;
pub mod rust;
