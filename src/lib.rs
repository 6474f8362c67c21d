//! Explicit equations of motion of a robot arm, derived from its Denavit-Hartenberg table at
//! compile time and proven equal to the textbook Lagrangian.
//!
//! [`robot_dynamics!`] turns a table into a struct with the arm's mass matrix, Coriolis and gravity
//! vectors, inverse and forward dynamics and energies as methods. [`Simulation`] moves the arm,
//! [`check_against_rnea`] compares it with a numeric recursive Newton-Euler algorithm.

pub use dynamics_runtime::*;
