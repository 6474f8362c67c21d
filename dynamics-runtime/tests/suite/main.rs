//! The numeric algorithms and the simulations against the reference data of `tests/data`, and what they
//! allocate: one program, which is linked once.

mod allocations;
mod arms;
mod check;
mod data;
#[cfg(feature = "serde")]
mod data_formats;
mod endings;
mod every_method;
mod friction;
mod inverse_kinematics;
mod methods;
mod moving_base;
mod progress;
mod reference;
mod sampling;
mod saturation;
mod springs;
mod sticking;
mod stops;
mod structure;
mod trajectories;
mod trees;
