//! Methods of integration for equations of motion q'' = a(t, q, q').
//!
//! They know nothing of robots: [`Equations`] are any function of time and phase that may refuse. Every method is a
//! [`Stepper`]. [`FixedStep`] makes equal steps of a method ([`OneStep`]), some of them in positions and momenta
//! ([`Canonical`]). [`Adaptive`] chooses the steps of a method with an error estimate
//! ([`Embedded`](embedded::Embedded)).

mod adaptive;
mod canonical;
mod compensated;
mod dop853;
mod dop853_tableau;
mod dormand_prince;
mod dormand_prince_tableau;
mod embedded;
mod equations;
mod euler;
mod fixed_step;
mod gauss_legendre;
mod grid;
mod initial_step;
mod jacobian;
mod lu;
mod phase;
mod radau;
mod rk4;
mod step_control;
mod stepper;
mod tolerance;

pub(crate) use adaptive::Adaptive;
pub(crate) use canonical::{Canonical, Point};
pub(crate) use dop853::Dop853Method;
pub(crate) use dormand_prince::DormandPrince54;
pub(crate) use dynamics_runtime::internal::first_non_finite;
pub(crate) use equations::Equations;
pub(crate) use euler::Euler;
pub(crate) use fixed_step::{FixedStep, OneStep};
pub(crate) use gauss_legendre::GaussLegendre;
pub(crate) use grid::{Grid, sample_time};
pub(crate) use lu::Lu;
pub(crate) use phase::{Phase, Start};
pub(crate) use radau::Radau;
pub(crate) use rk4::Rk4;
pub(crate) use stepper::{Failure, Stepper};
pub(crate) use tolerance::{StepRange, Tolerance};

#[cfg(test)]
mod order_conditions;
#[cfg(test)]
mod test_problems;
