//! The numeric algorithms and the simulations against the reference data of `tests/data`.

mod arms;
mod data;
mod methods;
mod reference;
mod structure;
mod trajectories;
