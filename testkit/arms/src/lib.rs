//! Arms as the engine reads them: those of the data files, random ones, chains of any length; and
//! their programs run by an interpreter.

#![forbid(unsafe_code)]

mod files;
mod generic_chain;
mod interpreted;
mod random;
mod zeros;

pub use files::{NAMES, decimal, robot, with_inertial_fields};
pub use generic_chain::generic_chain;
pub use interpreted::Interpreted;
pub use random::{Bodies, Tables};
pub use zeros::assert_zeros_are_constants;
