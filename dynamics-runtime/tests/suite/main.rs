//! The numeric algorithms and the simulations against the reference data of `tests/data`.

mod arms;
mod data;
mod reference;
mod trajectories;
