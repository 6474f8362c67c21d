//! Steppers for equations of motion q'' = a(t, q, q'), one file each.
//!
//! They know nothing of robots: an acceleration is any function of time and phase that may refuse.

mod craig_euler;
mod dormand_prince;
mod phase;
mod rk4;
mod semi_implicit_euler;
mod step_control;
mod tableau;

pub(crate) use craig_euler::craig_euler;
pub(crate) use dormand_prince::{Adaptive, Failure, StepRange, Tolerance};
pub(crate) use phase::{Phase, first_non_finite};
pub(crate) use rk4::rk4;
pub(crate) use semi_implicit_euler::semi_implicit_euler;

#[cfg(test)]
mod test_problems;
