//! The runtime of `robot-dynamics`: what generated robots are made of, and what can be done with
//! any of them.
//!
//! - [`Scalar`], the trait of the numbers that generated functions run on, with [`DoubleDouble`] (31 digits) and
//!   [`Certified`] (a proven bound of the error) among them.
//! - [`Model`], [`ForwardDynamics`], [`Energy`], [`Evaluate`] and others, the traits of a generated robot; [`Table`], its
//!   Denavit-Hartenberg table as numbers.
//! - [`NewtonEuler`], the same dynamics computed numerically from the table, and
//!   [`check_against_rnea`], which compares the two.
//! - [`FloatingNewtonEuler`], the same of a robot whose base moves, at a [`Pose`]; [`layouts`], its numbers in the layouts of
//!   other libraries.
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
pub mod batch;
pub mod certified;
#[cfg(feature = "std")]
pub mod check;
pub mod closed_form;
mod conditioning;
mod double_double;
mod dual;
#[cfg(feature = "num-dual")]
mod dual_scalars;
#[cfg(feature = "std")]
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
mod inputs;
#[cfg(feature = "std")]
mod integrate;
pub mod inverse_kinematics;
mod joint_name;
pub mod layouts;
mod macros;
mod model;
mod momenta;
mod newton_euler;
mod operations;
mod operators;
#[cfg(feature = "std")]
mod place;
mod placement;
#[cfg(feature = "plot")]
pub mod plot;
mod pose;
mod quaternion;
mod random;
#[cfg(feature = "std")]
mod replace;
mod scalar;
#[cfg(feature = "serde")]
mod sequences;
mod shared_sines;
#[cfg(feature = "std")]
pub mod simulation;
mod sine;
mod singular;
mod size;
mod state;
pub mod table;
mod taylor;
mod trajectory;
mod unrolled;

#[cfg(test)]
mod test_arms;

// The items that a first program needs.
#[cfg(feature = "std")]
pub use batch::Batch;
pub use certified::Certified;
#[cfg(feature = "std")]
pub use check::check_against_rnea;
pub use conditioning::Conditioning;
pub use double_double::DoubleDouble;
pub use formula::Formula;
pub use inverse_kinematics::InverseKinematics;
pub use model::{
    CoriolisVector, Energy, ForwardDynamics, GravityVector, InverseDynamics, Kinematics,
    MassMatrix, Model,
};
pub use newton_euler::{FloatingNewtonEuler, NewtonEuler, NumericArm, NumericFloating};
pub use operations::Operations;
pub use pose::Pose;
pub use scalar::Scalar;
pub use shared_sines::SharedSines;
#[cfg(feature = "std")]
pub use simulation::{Friction, Method, Simulation, SimulationError, TaylorSimulation, Trajectory};
pub use singular::SingularMassMatrix;
pub use size::Size;
pub use state::{AccelerationDerivatives, FloatingState, SecondDerivatives, State};
pub use trajectory::Cycloidal;

// The items that generated code and other crates of this workspace name, besides.
#[cfg(feature = "rayon")]
#[doc(hidden)]
pub use batch::on_all_cores;
#[cfg(feature = "std")]
#[doc(hidden)]
pub use batch::{
    BatchError, Fields, LengthMismatch, Precision, States, StatesMut, WithParameters, failing,
    on_one_core,
};
#[doc(hidden)]
pub use dual::Dual;
#[cfg(feature = "std")]
#[doc(hidden)]
pub use equations_of_motion::{EquationsOfMotion, Responses, SizedModel};
#[cfg(feature = "std")]
#[doc(hidden)]
pub use evaluation::{
    Arguments, Evaluate, Evaluation, FloatingArguments, FloatingEvaluate, FunctionValue,
};
#[doc(hidden)]
pub use function::{Arrangement, Entries, Function, Number, functions};
#[doc(hidden)]
pub use inputs::{Evaluated, Inputs};
#[doc(hidden)]
pub use model::{Momenta, SizedKinematics, SizedMomenta};
#[doc(hidden)]
pub use newton_euler::{NAMES_OF_BASE, StandardParameters, turned};
#[cfg(feature = "std")]
#[doc(hidden)]
pub use replace::replace_files;
#[doc(hidden)]
pub use sine::{Part, sin_cos_column};
#[doc(hidden)]
pub use size::{JointMatrix, JointVector, SizedSecondDerivatives};
#[doc(hidden)]
pub use state::SizedState;
#[cfg(feature = "std")]
#[doc(hidden)]
pub use table::RuntimeTable;
#[doc(hidden)]
pub use table::{
    Arm, AsArm, Carrier, Convention, FixedFrame, FloatingBase, Follower, Frame, JointMotion,
    JointType, Placement, Row, Spring, Stribeck, Table, Tool,
};
#[doc(hidden)]
pub use taylor::{
    Block, Common, MAX_TAYLOR_ORDER, ProductTable, Products, SeriesTerm, TaylorCoefficients,
    TaylorDynamics,
};

#[cfg(feature = "macro")]
#[doc(hidden)]
pub mod __private {
    pub use dynamics_macros::robot_dynamics as expand;
}
