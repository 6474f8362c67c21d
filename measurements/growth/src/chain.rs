//! The measurements of a chain.

use std::error::Error;

use dynamics_symbolic::Function;

pub(crate) type Outcome<T> = Result<T, Box<dyn Error>>;

/// The functions that are listed one by one, with the symbols of their values.
pub(crate) const LISTED: [(Function, &str); 5] = [
    (Function::InverseDynamics, "tau"),
    (Function::MassMatrix, "M"),
    (Function::CoriolisVector, "V"),
    (Function::GravityVector, "G"),
    (Function::ForwardDynamics, "qdd"),
];

/// The measured values of one chain.
pub(crate) struct Chain {
    pub(crate) joints: usize,
    /// Seconds on a processor from the table to tokens, default set of functions.
    pub(crate) expansion: f64,
    /// As `expansion`, in an engine that is compiled as cargo compiles macros.
    pub(crate) unoptimised: Option<f64>,
    /// Operations of the listed functions.
    pub(crate) operations: [f64; 5],
    /// Operations of the default set.
    pub(crate) length: f64,
    /// Seconds of rustc on a processor for the default set, release profile.
    pub(crate) release: f64,
    /// As `release`, dev profile with debug information.
    pub(crate) dev: f64,
    /// Nanoseconds of a call of the listed functions.
    pub(crate) calls: [f64; 5],
}
