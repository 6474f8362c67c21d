//! The symbolic engine of `robot-dynamics`.
//!
//! Data flows one way through the modules of this crate:
//! [`robot`] (a description of an arm) is read into a [`mechanism`] (joints on links), written as expressions on a
//! graph ([`expr`]) by one of several derivations (`derive`), becomes a straight-line program
//! (`program`), is proven equal to the textbook Lagrangian (`prove`)
//! and leaves as Rust tokens (`emit`).
#![forbid(unsafe_code)]

pub mod bounds;
pub mod derive;
pub mod emit;
pub mod exact;
pub mod expr;
pub mod formula;
mod interval;
pub mod inverse;
pub mod linear;
pub mod mechanism;
mod methods;
pub mod neglect;
mod operators;
mod polynomial;
pub mod program;
pub mod prove;
pub mod robot;
pub mod rounding;
pub mod simplify;
pub mod spatial;

pub use dynamics_functions as function;
pub use emit::{
    Stubbed, base_parameter_constants, function_type, handed_on, method_name, stub,
    stub_of_function, stub_of_inverse, stub_of_trait,
};
pub use function::{Function, Request};
pub use methods::{
    Failure, Method, Reason, expand, expand_with, inverse_kinematics, percent, proven_plan,
    proven_program,
};
pub use program::{Operations, Proven};
