//! Simulations against the reference data of `tests/data`, and what they allocate: one program, which is linked once.

mod allocations;
mod arms;
#[cfg(feature = "serde")]
mod data_formats;
mod endings;
mod every_method;
mod friction;
mod methods;
mod moving_base;
mod progress;
mod sampling;
mod saturation;
mod springs;
mod sticking;
mod stops;
mod structure;
mod trajectories;
