//! The Denavit-Hartenberg table of a robot arm, or its URDF file, becomes explicit functions at compile time: mass matrix,
//! Coriolis and gravity vectors, inverse and forward dynamics, and what is asked for besides, each proven equal to the
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
//! - [`robot_dynamics!`] has the whole grammar of a table, with an example of each entry, the files that it reads, and
//!   the list of all functions.
//! - [`Scalar`] is what functions compute with: `f32`, `f64`, [`DoubleDouble`] of 31 digits, dual numbers, your own.
//! - [`Certified`] numbers carry a proven bound of their error; [`certified`] has sharper ones of what is solved for with M.
//! - [`Simulation`] moves an arm under torques and forces by a [`Method`] of your choice, [`TaylorSimulation`] to any
//!   accuracy that a double holds; [`Cycloidal`] is a motion to follow.
//! - `Batch` gives every function a second one, `NAME_batch`, for many states at once.
//! - [`check_against_rnea`] compares every function with [`NewtonEuler`], which knows nothing of the symbolic result;
//!   [`Conditioning`] says how many digits accelerations lose.
//! - [`Model`], [`ForwardDynamics`], [`Kinematics`] and so on are what a generated arm is to generic code.
//!
//! # Features
//!
//! | feature | default | what it adds |
//! |---|---|---|
//! | `std` | yes | simulation, checks, batches. Without it neither the standard library nor an allocator is needed |
//! | `files` | yes | `file:` in a call: the readers of TOML, JSON and URDF, three seconds of the macro's build |
//! | `rayon` | | batches on all cores: `par_NAME_batch` |
//! | `num-dual` | | [`Scalar`] for the dual numbers of that crate |
//! | `runtime-robot` | | `evaluation::RuntimeRobot`, an arm that is known at run time alone |
//! | `plot` | | `Trajectory::plot`: curves over time as SVG |
//! | `serde` | | tables, trajectories, settings and reports as data |
//!
//! # Compile time
//!
//! The macro runs inside the compiler, unoptimised unless the top-level `Cargo.toml` says otherwise, which makes it some
//! ten times faster:
//!
//! ```toml
//! [profile.dev.build-override]
//! opt-level = 3
//!
//! [profile.release.build-override]
//! opt-level = 3
//! ```
//!
//! It runs again at each edit of the crate that a call stands in: robots belong into a crate of their own.
#![cfg_attr(not(feature = "std"), no_std)]
#![forbid(unsafe_code)]

pub use dynamics_runtime::*;

#[cfg(feature = "runtime-robot")]
pub use dynamics_evaluation as evaluation;

/// The README, whose code is run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
