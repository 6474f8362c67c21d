//! The laws that move an arm: of its motors, and of what touches its tool.

use nalgebra::SVector;

use super::error::Cause;
use super::tool_force::{NoToolForce, ToolForce};
use crate::integrate::{Phase, first_non_finite};

/// What acts on the joints from outside of the arm's own equations.
pub(super) trait TorqueLaw<const N: usize> {
    /// The joint torques at a time in a phase that is finite, N m or N.
    fn torque(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause>;
}

/// The torque law of free motion: no torque.
pub type NoTorque<const N: usize> = fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>;

/// The torques of the motors, a function of t in s, q in rad or m, and qd, and the force at the tool.
pub(super) struct Laws<'a, R, L, W = NoToolForce> {
    pub(super) robot: &'a R,
    pub(super) torque: &'a L,
    pub(super) tool_force: &'a W,
}

impl<R, L, W, const N: usize> TorqueLaw<N> for Laws<'_, R, L, W>
where
    L: Fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>,
    W: ToolForce<R, N>,
{
    fn torque(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause> {
        let tau = (self.torque)(t, &phase.q, &phase.qd);
        if let Some(joint) = first_non_finite(&tau) {
            return Err(Cause::NonFiniteTorque { joint });
        }
        self.tool_force
            .added_to(tau, self.robot, t, &phase.q, &phase.qd)
    }
}
