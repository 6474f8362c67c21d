//! The runtime of `robot-dynamics`: what generated robots are made of, and what can be done with
//! any of them.
//!
//! - [`Scalar`], the numbers that generated functions run on; [`Model`], [`ForwardDynamics`],
//!   [`Energy`] and [`Evaluate`], what a generated robot is to generic code; [`Table`], its
//!   Denavit-Hartenberg table as numbers.
//! - [`NewtonEuler`], the same dynamics computed numerically from the table, and
//!   [`check_against_rnea`], which compares the two.
//! - [`Simulation`], which moves an arm under a torque law, and [`Cycloidal`], a motion to follow.
//!
//! Use it through the crate `robot-dynamics`, which re-exports all of it.
#![forbid(unsafe_code)]

pub use nalgebra;

mod batch;
mod check;
mod configuration;
mod integrate;
mod macros;
mod model;
mod newton_euler;
mod operations;
mod scalar;
mod simulation;
mod sine;
mod table;
mod taylor;
mod trajectory;

#[cfg(test)]
mod test_arms;

pub use batch::{Batch, BatchError, LengthMismatch, States, StatesMut};
pub use check::{Check, FunctionReport, Report, check_against_rnea};
pub use configuration::Configuration;
#[doc(hidden)]
pub use configuration::{Evaluated, JointSines};
pub use model::{
    AccelerationDerivatives, CoriolisVector, Energy, Evaluate, Evaluation, ForwardDynamics,
    GravityVector, InverseDynamics, MassMatrix, Model, SingularMassMatrix, State,
};
pub use newton_euler::NewtonEuler;
pub use operations::Operations;
pub use scalar::Scalar;
pub use simulation::{
    Cause, DormandPrince, InvalidSetting, Method, NoTorque, Simulation, SimulationError, Taylor,
    TaylorSimulation, Trajectory,
};
pub use table::{Convention, JointType, Row, Table};
#[doc(hidden)]
pub use taylor::{Block, Common, ProductTable, Products, SeriesTerm};
pub use taylor::{MAX_TAYLOR_ORDER, TaylorCoefficients, TaylorDynamics};
pub use trajectory::{Cycloidal, InvalidDuration};

#[doc(hidden)]
pub mod __private {
    pub use dynamics_macros::robot_dynamics as expand;
}
