//! A force at the tool: what the surroundings do to the arm.

use nalgebra::{Matrix4, SVector, Vector6};

use super::error::Cause;
use crate::Kinematics;

/// A time in s, positions in rad or m, and velocities.
type At<'a, const N: usize> = (f64, &'a SVector<f64, N>, &'a SVector<f64, N>);

/// Joint torques, N m or N.
pub(super) type Torques<const N: usize> = Result<SVector<f64, N>, Cause>;

/// The force at the tool in a [`Simulation`](crate::Simulation): none, or a law, which needs an arm with generated
/// [`Kinematics`].
pub trait ToolForce<R, const N: usize> {
    /// The joint torques `tau` with those of the force: tau + J^T w.
    #[doc(hidden)]
    fn added_to(&self, tau: SVector<f64, N>, robot: &R, at: At<'_, N>) -> Torques<N>;

    /// Begins a period, where the law is sampled.
    #[doc(hidden)]
    fn sample(&mut self, _robot: &R, _at: At<'_, N>) -> Result<(), Cause> {
        Ok(())
    }
}

/// A force at the tool that needs no period: none, or a function of time and state.
#[diagnostic::on_unimplemented(
    message = "a held force at the tool needs a period",
    label = "a law of `held_tool_force`, which is called once each period",
    note = "call `.sampled(period)` before `.run()`, or give the law by `.tool_force(..)` as a function of time and state"
)]
pub trait ContinuousForce {}

impl ContinuousForce for NoToolForce {}

impl<F> ContinuousForce for F where F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64> {}

/// No force at the tool.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoToolForce;

impl<R, const N: usize> ToolForce<R, N> for NoToolForce {
    #[inline]
    fn added_to(&self, tau: SVector<f64, N>, _robot: &R, _at: At<'_, N>) -> Torques<N> {
        Ok(tau)
    }
}

impl<R, F, const N: usize> ToolForce<R, N> for F
where
    R: Kinematics<N>,
    F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64>,
{
    fn added_to(&self, tau: SVector<f64, N>, robot: &R, (t, q, qd): At<'_, N>) -> Torques<N> {
        let pose = robot.forward_kinematics(q);
        let jacobian = robot.jacobian(q);
        let wrench = finite(self(t, &pose, &(jacobian * qd)))?;
        Ok(tau + jacobian.tr_mul(&wrench))
    }
}

/// A law of the force at the tool that is called once each period. In between, the force is held in the axes of
/// `jacobian`.
#[derive(Clone, Copy, Debug)]
pub struct HeldToolForce<F> {
    pub(super) law: F,
    pub(super) wrench: Vector6<f64>,
}

impl<R, F, const N: usize> ToolForce<R, N> for HeldToolForce<F>
where
    R: Kinematics<N>,
    F: FnMut(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64>,
{
    fn added_to(&self, tau: SVector<f64, N>, robot: &R, (_, q, _): At<'_, N>) -> Torques<N> {
        Ok(tau + robot.jacobian(q).tr_mul(&self.wrench))
    }

    fn sample(&mut self, robot: &R, (t, q, qd): At<'_, N>) -> Result<(), Cause> {
        let pose = robot.forward_kinematics(q);
        let twist = robot.jacobian(q) * qd;
        self.wrench = finite((self.law)(t, &pose, &twist))?;
        Ok(())
    }
}

fn finite(wrench: Vector6<f64>) -> Result<Vector6<f64>, Cause> {
    match wrench.iter().position(|x| !x.is_finite()) {
        Some(component) => Err(Cause::NonFiniteToolForce { component }),
        None => Ok(wrench),
    }
}
