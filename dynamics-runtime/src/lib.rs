//! The runtime of `robot-dynamics`: what generated robots are made of.
//!
//! - [`Scalar`], the trait of the numbers that generated functions run on, with [`DoubleDouble`] (31 digits) and
//!   [`Certified`] (a proven bound of the error) among them.
//! - [`Model`], [`ForwardDynamics`], [`Energy`], [`Evaluate`] and others, the traits of a generated robot; [`Table`], its
//!   Denavit-Hartenberg table as numbers.
//! - [`Batch`], functions at many states; [`closed_form`], solutions of inverse kinematics.
//! - [`Cycloidal`], a motion to follow.
//!
//! The crates `dynamics-numeric` and `dynamics-simulation` add what can be done with any robot: numeric algorithms and
//! checks, and motions.
//!
//! Without the feature `std`, which is on by default, the crate needs neither the standard library nor
//! an allocator, and has everything but batches.
//!
//! Use it through the crate `robot-dynamics`, which re-exports all of it.
#![cfg_attr(not(feature = "std"), no_std)]
#![forbid(unsafe_code)]

pub use nalgebra;

#[cfg(feature = "std")]
pub mod batch;
pub mod certified;
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
#[cfg(feature = "std")]
mod fused;
mod geometry;
mod inputs;
#[doc(hidden)]
pub mod internal;
mod joint_name;
mod macros;
mod model;
mod momenta;
mod operations;
mod operators;
#[cfg(feature = "std")]
mod place;
mod placement;
mod pose;
mod quaternion;
mod random;
mod scalar;
#[cfg(feature = "serde")]
mod sequences;
mod shared_sines;
mod sine;
mod singular;
mod size;
mod state;
pub mod table;
mod taylor;
mod trajectory;
mod unrolled;

// The items that a first program needs.
#[cfg(feature = "std")]
pub use batch::Batch;
pub use certified::Certified;
pub use conditioning::Conditioning;
pub use double_double::DoubleDouble;
pub use formula::Formula;
pub use model::{
    CoriolisVector, Energy, ForwardDynamics, GravityVector, InverseDynamics, Kinematics,
    MassMatrix, Model,
};
pub use operations::Operations;
pub use pose::Pose;
pub use scalar::Scalar;
pub use shared_sines::SharedSines;
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
pub use geometry::turned;
#[doc(hidden)]
pub use inputs::{Evaluated, Inputs};
#[doc(hidden)]
pub use model::{Momenta, SizedKinematics, SizedMomenta, SizedTable};
#[cfg(feature = "std")]
#[doc(hidden)]
pub use place::{OnBase, Place, Sizes};
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
    JointType, NAMES_OF_BASE, Placement, Row, Spring, StandardParameters, Stribeck, Table, Tool,
};
#[doc(hidden)]
pub use taylor::{
    Block, Common, MAX_TAYLOR_ORDER, ProductTable, Products, SeriesTerm, TaylorCoefficients,
    TaylorDynamics,
};
#[doc(hidden)]
pub use trajectory::InvalidDuration;

#[cfg(feature = "macro")]
#[doc(hidden)]
pub mod __private {
    pub use dynamics_macros::robot_dynamics as expand;
}
