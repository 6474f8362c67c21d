//! Derivations: the functions of a robot as expressions on a graph.

pub mod chain;
mod christoffel;
mod composite;
mod energy;
pub mod functions;
pub mod inertia;
mod kinematics;
mod recursive;
mod solve;
pub mod symbols;
