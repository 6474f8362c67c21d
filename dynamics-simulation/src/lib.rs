//! The motion of a robot: methods of integration, simulation, trajectories, plots and files.
//!
//! - [`Simulation`] moves a robot under a torque law by a [`Method`] of your choice.
//! - [`TaylorSimulation`] does so by series of the motion.
//! - [`Trajectory`] is the motion that they return.
//!
//! Use it through the crate `robot-dynamics`, which re-exports all of it.
#![forbid(unsafe_code)]

mod chart;
mod integrate;
#[cfg(feature = "plot")]
pub mod plot;
mod replace;
pub mod simulation;
mod taylor;

pub use simulation::{Friction, Method, Simulation, SimulationError, TaylorSimulation, Trajectory};

// The item that the command names, besides.
#[doc(hidden)]
pub use replace::replace_files;
