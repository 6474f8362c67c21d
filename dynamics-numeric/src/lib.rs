//! The dynamics of a robot from its table, numerically: what generated functions are compared with, and what a table alone
//! can do.
//!
//! - [`NewtonEuler`] computes the functions of an arm from its table; [`FloatingNewtonEuler`] those of a robot whose base moves.
//! - [`check_against_rnea`] compares generated functions with them.
//! - [`InverseKinematics`] finds joint positions for targets of frames.
//! - [`layouts`] has the numbers of a robot whose base moves in the layouts of other libraries.
//!
//! Without the feature `std`, which is on by default, the crate needs neither the standard library nor an allocator, and has
//! everything but checks.
//!
//! Use it through the crate `robot-dynamics`, which re-exports all of it.
#![cfg_attr(not(feature = "std"), no_std)]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
pub mod check;
#[cfg(feature = "std")]
mod equations_of_motion;
pub mod inverse_kinematics;
pub mod layouts;
mod momenta;
mod newton_euler;

#[cfg(feature = "std")]
pub use check::check_against_rnea;
pub use inverse_kinematics::InverseKinematics;
pub use newton_euler::{FloatingNewtonEuler, NewtonEuler, NumericArm, NumericFloating};
