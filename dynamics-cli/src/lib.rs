//! Texts that the command `robot-dynamics` writes, for other programs: the page of a robot, and its functions in Rust.
#![forbid(unsafe_code)]

pub mod page;
pub mod poses;
pub mod rust;
