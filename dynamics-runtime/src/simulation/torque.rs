//! The laws that move an arm: the torques of its motors, and the force at its tool.

use core::cell::{Cell, RefCell};

use nalgebra::SVector;

use super::error::Cause;
use super::tool_force::{NoToolForce, ToolForce, Torques};
use crate::integrate::{Phase, first_non_finite};

/// The torques on the joints from outside of the arm's own equations.
pub(super) trait TorqueLaw<const N: usize> {
    /// The torques of the motors at a time in a finite phase, N m or N. They may be infinite or NaN.
    fn motors(&self, t: f64, phase: &Phase<N>) -> SVector<f64, N>;

    /// Torques with those of the force at the tool.
    fn with_tool(&self, tau: SVector<f64, N>, t: f64, phase: &Phase<N>) -> Torques<N>;

    /// The period of laws that are sampled and held.
    fn period(&self) -> Option<f64> {
        None
    }

    /// Begins a period: calls the laws that are sampled.
    fn sample(&self, _t: f64, _phase: &Phase<N>) -> Result<(), Cause> {
        Ok(())
    }

    /// All of the torques.
    #[inline]
    fn torque(&self, t: f64, phase: &Phase<N>) -> Torques<N> {
        self.with_tool(finite(self.motors(t, phase))?, t, phase)
    }
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
    #[inline]
    fn motors(&self, t: f64, phase: &Phase<N>) -> SVector<f64, N> {
        (self.torque)(t, &phase.q, &phase.qd)
    }

    #[inline]
    fn with_tool(&self, tau: SVector<f64, N>, t: f64, phase: &Phase<N>) -> Torques<N> {
        let at = (t, &phase.q, &phase.qd);
        self.tool_force.added_to(tau, self.robot, at)
    }
}

/// Torques of the motors that are sampled and held, and the force at the tool, which may be.
pub(super) struct SampledLaws<'a, R, L, W, const N: usize> {
    robot: &'a R,
    period: f64,
    torque: RefCell<&'a mut L>,
    tool_force: RefCell<&'a mut W>,
    held: Cell<SVector<f64, N>>,
}

impl<'a, R, L, W, const N: usize> SampledLaws<'a, R, L, W, N> {
    pub(super) fn new(robot: &'a R, period: f64, torque: &'a mut L, tool_force: &'a mut W) -> Self {
        SampledLaws {
            robot,
            period,
            torque: RefCell::new(torque),
            tool_force: RefCell::new(tool_force),
            held: Cell::new(SVector::zeros()),
        }
    }
}

impl<R, L, W, const N: usize> TorqueLaw<N> for SampledLaws<'_, R, L, W, N>
where
    L: FnMut(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>,
    W: ToolForce<R, N>,
{
    #[inline]
    fn motors(&self, _t: f64, _phase: &Phase<N>) -> SVector<f64, N> {
        self.held.get()
    }

    #[inline]
    fn with_tool(&self, tau: SVector<f64, N>, t: f64, phase: &Phase<N>) -> Torques<N> {
        let (tool_force, at) = (self.tool_force.borrow(), (t, &phase.q, &phase.qd));
        tool_force.added_to(tau, self.robot, at)
    }

    fn period(&self) -> Option<f64> {
        Some(self.period)
    }

    fn sample(&self, t: f64, phase: &Phase<N>) -> Result<(), Cause> {
        let tau = (self.torque.borrow_mut())(t, &phase.q, &phase.qd);
        self.held.set(tau);
        finite(tau)?;
        let mut tool_force = self.tool_force.borrow_mut();
        tool_force.sample(self.robot, (t, &phase.q, &phase.qd))
    }
}

/// Torques that a law returned, where they are numbers.
pub(super) fn finite<const N: usize>(tau: SVector<f64, N>) -> Torques<N> {
    match first_non_finite(&tau) {
        Some(joint) => Err(Cause::NonFiniteTorque { joint }),
        None => Ok(tau),
    }
}
