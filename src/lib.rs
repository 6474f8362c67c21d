//! The Denavit-Hartenberg table of a robot arm, or its URDF file, becomes explicit functions at compile time: mass matrix,
//! Coriolis and gravity vectors, inverse and forward dynamics, and others on request, each proven equal to the
//! textbook Lagrangian.
//!
//! ```
//! use robot_dynamics::{nalgebra::Vector2, robot_dynamics};
//!
//! robot_dynamics! {
//!     /// Two slender rods in a vertical plane, angles from the horizontal.
//!     struct TwoLink { payload: f64 }
//!
//!     convention: standard,
//!     gravity: [0, -9.81, 0],
//!     joints: [
//!         shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
//!         elbow:    revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
//!     ],
//!     tool: { mass: payload },
//! }
//!
//! let arm = TwoLink { payload: 0.5 };
//! let (q, qd, tau) = (Vector2::new(0.4, 0.9), Vector2::new(1.0, -2.0), Vector2::new(50.0, 3.0));
//! let qdd: Vector2<f64> = arm.forward_dynamics(&q, &qd, &tau)?;
//! assert!((arm.inverse_dynamics(&q, &qd, &qdd) - tau).norm() < 1e-12);
//! # Ok::<(), robot_dynamics::SingularMassMatrix>(())
//! ```
//!
//! - [`robot_dynamics!`] documents the whole grammar of a table with examples, the files that it reads, and all functions.
//! - [`Scalar`] is the trait of the numbers that functions compute with: `f32`, `f64`, [`DoubleDouble`] with 31 digits,
//!   dual numbers, your own.
//! - [`Certified`] numbers carry a proven bound of their error; the module [`certified`] has sharper bounds of
//!   accelerations and other results of solving with M.
//! - [`Simulation`] moves an arm under torques and forces by a [`Method`] of your choice; [`TaylorSimulation`] does so with
//!   errors down to the rounding of a double. [`Cycloidal`] is a motion to follow.
//! - [`Batch`] adds to every function `NAME` a method `NAME_batch` for many states at once.
//! - [`check_against_rnea`] compares every function with [`NewtonEuler`], a numeric algorithm that reads only the table;
//!   [`Conditioning`] says how many digits accelerations lose.
//! - [`Model`], [`ForwardDynamics`], [`Kinematics`] and other traits give generic code access to a generated arm.
//!
//! Everything beyond a first program is in modules: [`simulation`] (settings of methods, causes of errors), [`check`]
//! (reports, [`check::Evaluation`]), [`table`] (rows and frames as numbers), [`batch`], [`certified`].
//!
//! # Features
//!
//! | feature | default | what it adds |
//! |---|---|---|
//! | `std` | yes | all of the next three |
//! | `batch` | in `std` | batches, and functions by the standard library: all that torques in a loop need. Without it neither the standard library nor an allocator is needed |
//! | `numeric` | in `std` | [`NewtonEuler`], inverse kinematics by iteration and [`layouts`], from the table alone; with `batch` checks |
//! | `simulation` | in `std` | [`Simulation`], its methods and trajectories |
//! | `nalgebra-std` | yes | all of nalgebra: aligned columns of printed matrices, exponentials of matrices, fast products of large ones; a seventh of a first build |
//! | `files` | yes | `file:` in a call: the readers of TOML, JSON and URDF, three seconds of the macro's build |
//! | `rayon` | | batches on all cores: `par_NAME_batch` |
//! | `num-dual` | | [`Scalar`] for the dual numbers of that crate |
//! | `runtime-robot` | | `evaluation::RuntimeRobot`, an arm that is not known before run time |
//! | `plot` | | `Trajectory::plot`: curves over time as SVG |
//! | `csv` | | `Trajectory::write_csv` and `read_csv`: comma-separated values |
//! | `serde` | | tables, trajectories, settings and reports as data |
//!
//! # Compile time
//!
//! The macro runs inside the compiler. By default it is compiled without optimisation; these lines in the top-level
//! `Cargo.toml` make it about ten times faster:
//!
//! ```toml
//! [profile.dev.build-override]
//! opt-level = 3
//!
//! [profile.release.build-override]
//! opt-level = 3
//! ```
//!
//! It runs again after each edit of the crate in which the call stands: put robots into a crate of their own.
#![cfg_attr(not(feature = "batch"), no_std)]
#![forbid(unsafe_code)]

// The names that the documentation shows; generated code names others besides.
#[cfg(feature = "numeric")]
#[doc(inline)]
pub use dynamics_numeric::{
    FloatingNewtonEuler, InverseKinematics, NewtonEuler, NumericArm, NumericFloating,
    inverse_kinematics, layouts,
};
#[cfg(all(feature = "numeric", feature = "batch"))]
#[doc(inline)]
pub use dynamics_numeric::{check, check_against_rnea};
#[doc(hidden)]
pub use dynamics_runtime::*;
#[doc(inline)]
pub use dynamics_runtime::{
    AccelerationDerivatives, Certified, Conditioning, CoriolisVector, Cycloidal, DoubleDouble,
    Energy, FloatingState, Formula, ForwardDynamics, GravityVector, InverseDynamics, Kinematics,
    MassMatrix, Model, Operations, Pose, Scalar, SecondDerivatives, SharedSines,
    SingularMassMatrix, Size, State, certified, closed_form, nalgebra, table,
};
#[cfg(feature = "batch")]
#[doc(inline)]
pub use dynamics_runtime::{Batch, batch};
#[cfg(feature = "plot")]
#[doc(inline)]
pub use dynamics_simulation::plot;
#[cfg(feature = "simulation")]
#[doc(inline)]
pub use dynamics_simulation::{
    Friction, Method, Simulation, SimulationError, TaylorSimulation, Trajectory, simulation,
};

#[doc = include_str!("robot_dynamics.md")]
// `$crate` is this crate under whatever name and through whatever re-export the caller sees it, so that the generated code
// finds the runtime without a dependency of its own. The runtime itself compiles beside the engine of the macro.
#[macro_export]
macro_rules! robot_dynamics {
    ($($tokens:tt)*) => {
        $crate::__private::expand! { @[$crate] $($tokens)* }
    };
}

/// The procedural macro behind [`robot_dynamics!`].
#[doc(hidden)]
pub mod __private {
    pub use dynamics_macros::robot_dynamics as expand;
}

#[cfg(feature = "runtime-robot")]
pub use dynamics_evaluation as evaluation;

/// The README, whose code is run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
