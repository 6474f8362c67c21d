//! The numeric algorithms and the simulations against the reference data of `tests/data`.

mod arms;
mod data;
mod endings;
mod friction;
mod methods;
mod reference;
mod springs;
mod sticking;
mod structure;
mod trajectories;
