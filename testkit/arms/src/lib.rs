//! Arms as the engine reads them: those of the data files, random ones, chains of any length.

#![forbid(unsafe_code)]

mod files;
mod generic_chain;
mod near;
mod programs;
mod random;
mod symbolic;
mod trees;
mod zeros;

pub use files::{MOUNTED, NAMES, decimal, robot, with_inertial_fields};
pub use generic_chain::generic_chain;
pub use near::{Arm, Arms, printed};
pub use programs::{is_installed, is_left_out};
pub use random::{Bodies, Tables};
pub use symbolic::{fingers, two_link_craig};
pub use trees::{FLOATING, TREES, floating, tree};
pub use zeros::assert_zeros_are_constants;
