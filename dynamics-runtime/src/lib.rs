//! The runtime of `robot-dynamics`: what generated robots are made of, and what can be done with
//! any of them.
//!
//! - [`Scalar`], the trait of the numbers that generated functions run on, with [`DoubleDouble`] (31 digits) and
//!   [`Certified`] (a proven bound of the error) among them.
//! - [`Model`], [`ForwardDynamics`], [`Energy`], [`Evaluate`] and others, the traits of a generated robot; [`Table`], its
//!   Denavit-Hartenberg table as numbers.
//! - [`NewtonEuler`], the same dynamics computed numerically from the table, and
//!   [`check_against_rnea`], which compares the two.
//! - [`Simulation`], which moves an arm under a torque law by a [`Method`] of your choice, and
//!   [`Cycloidal`], a motion to follow.
//!
//! Without the feature `std`, which is on by default, the crate needs neither the standard library nor
//! an allocator, and has everything but simulation, checks and batches.
//!
//! Use it through the crate `robot-dynamics`, which re-exports all of it.
#![cfg_attr(not(feature = "std"), no_std)]
#![forbid(unsafe_code)]

pub use nalgebra;

#[cfg(feature = "std")]
mod batch;
pub mod certified;
#[cfg(feature = "std")]
mod check;
mod conditioning;
mod configuration;
mod double_double;
mod dual;
#[cfg(feature = "num-dual")]
mod dual_scalars;
mod equations_of_motion;
#[cfg(feature = "std")]
mod evaluation;
mod exact;
mod factorisation;
mod float;
mod formula;
mod frame;
mod friction;
mod function;
#[cfg(feature = "std")]
mod identification;
mod inputs;
#[cfg(feature = "std")]
mod integrate;
mod macros;
mod model;
mod momenta;
mod newton_euler;
mod operations;
mod operators;
mod placement;
#[cfg(feature = "plot")]
pub mod plot;
#[cfg(feature = "std")]
mod replace;
mod scalar;
#[cfg(feature = "serde")]
mod sequences;
#[cfg(feature = "std")]
mod simulation;
mod sine;
mod singular;
mod size;
mod state;
mod table;
mod taylor;
mod trajectory;
mod unrolled;

#[cfg(test)]
mod test_arms;

#[cfg(feature = "rayon")]
#[doc(hidden)]
pub use batch::on_all_cores;
#[cfg(feature = "std")]
pub use batch::{Batch, BatchError, LengthMismatch, Precision, States, StatesMut, WithParameters};
#[cfg(feature = "std")]
#[doc(hidden)]
pub use batch::{Fields, failing, on_one_core};
pub use certified::{Certified, Rounded};
#[cfg(feature = "std")]
pub use check::{Check, Checked, FunctionReport, Report, check_against_rnea};
pub use conditioning::Conditioning;
pub use configuration::Configuration;
pub use double_double::DoubleDouble;
#[doc(hidden)]
pub use dual::Dual;
#[cfg(feature = "std")]
pub use equations_of_motion::SizedModel;
pub use equations_of_motion::{EquationsOfMotion, Responses};
#[cfg(feature = "std")]
#[doc(hidden)]
pub use evaluation::Arguments;
#[cfg(feature = "std")]
pub use evaluation::{Evaluate, Evaluation, FunctionValue};
pub use formula::Formula;
pub use frame::{Frame, Tool};
#[doc(hidden)]
pub use function::{Arrangement, Entries, Function, Number, functions};
#[cfg(feature = "std")]
pub use identification::base_parameter_map;
#[doc(hidden)]
pub use inputs::{Evaluated, Inputs};
pub use model::{
    CoriolisVector, Energy, ForwardDynamics, GravityVector, InverseDynamics, Kinematics,
    MassMatrix, Model, Momenta, SizedKinematics, SizedMomenta,
};
#[doc(hidden)]
pub use newton_euler::turned;
pub use newton_euler::{NewtonEuler, NumericArm, StandardParameters};
pub use operations::Operations;
pub use placement::Placement;
#[cfg(feature = "std")]
#[doc(hidden)]
pub use replace::replace_files;
pub use scalar::Scalar;
#[cfg(feature = "std")]
pub use simulation::{
    Cause, Continuous, ContinuousForce, CsvError, CsvMistake, Dop853, DormandPrince, Friction,
    HeldToolForce, HeldTorque, InvalidSetting, JointSet, Method, NoToolForce, NoTorque, Radau5,
    Sampled, Simulation, SimulationError, SizedSimulationError, SizedTrajectory, Taylor,
    TaylorSimulation, ToolForce, Trajectory, Work,
};
#[doc(hidden)]
pub use sine::{Part, sin_cos_column};
pub use singular::SingularMassMatrix;
pub use size::{JointMatrix, JointVector, Size, SizedSecondDerivatives};
pub use state::{AccelerationDerivatives, SecondDerivatives, SizedState, State};
#[cfg(feature = "std")]
pub use table::RuntimeTable;
#[doc(hidden)]
pub use table::{Arm, AsArm};
pub use table::{
    Convention, Follower, Followers, JointMotion, JointType, Row, Spring, Stribeck, Table,
};
#[doc(hidden)]
pub use taylor::{Block, Common, ProductTable, Products, SeriesTerm};
pub use taylor::{MAX_TAYLOR_ORDER, TaylorCoefficients, TaylorDynamics};
pub use trajectory::{Cycloidal, InvalidDuration};

#[doc(hidden)]
pub mod __private {
    pub use dynamics_macros::robot_dynamics as expand;
}
