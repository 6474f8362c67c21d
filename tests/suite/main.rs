//! Tests that hold for every robot of `tests/data/robots`.

mod accuracy;
mod allocations;
mod aristo;
mod batch;
mod certified;
mod controllers;
mod decimals;
mod dry_friction;
mod dual_numbers;
mod exact;
mod free_fall;
mod identities;
mod inverse_kinematics;
mod second_derivatives;
mod table;
mod taylor;
mod trees;
