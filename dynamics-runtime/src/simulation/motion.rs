//! An arm and its torque law as one equation of motion.

use core::cell::Cell;

use nalgebra::SVector;

use super::{Cause, TorqueLaw};
use crate::integrate::{Canonical, Equations, Phase, Point, first_non_finite};
use crate::{ForwardDynamics, Momenta};

pub(super) struct Motion<'a, R, L> {
    robot: &'a R,
    torque: &'a L,
    /// How often the equations of motion were evaluated.
    evaluations: Cell<u64>,
}

impl<'a, R, L> Motion<'a, R, L> {
    pub(super) fn new(robot: &'a R, torque: &'a L) -> Self {
        Motion {
            robot,
            torque,
            evaluations: Cell::new(0),
        }
    }

    pub(super) fn evaluations(&self) -> u64 {
        self.evaluations.get()
    }

    fn count(&self) {
        self.evaluations.set(self.evaluations.get() + 1);
    }

    /// The torques at a time in a phase, where both are finite.
    fn torque<const N: usize>(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause>
    where
        L: TorqueLaw<N>,
    {
        if let Some(joint) = phase.first_non_finite() {
            return Err(Cause::NonFiniteState { joint });
        }
        let tau = (self.torque)(t, &phase.q, &phase.qd);
        match first_non_finite(&tau) {
            Some(joint) => Err(Cause::NonFiniteTorque { joint }),
            None => Ok(tau),
        }
    }
}

impl<R, L, const N: usize> Equations<N> for Motion<'_, R, L>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    type Refusal = Cause;

    /// qdd, where everything on the way to it is finite.
    fn acceleration(&self, t: f64, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause> {
        let tau = self.torque(t, phase)?;
        self.count();
        let qdd = self.robot.forward_dynamics(&phase.q, &phase.qd, &tau)?;
        match first_non_finite(&qdd) {
            Some(joint) => Err(Cause::NonFiniteAcceleration { joint }),
            None => Ok(qdd),
        }
    }
}

/// A motion in positions and momenta.
pub(super) struct InMomenta<'a, R, L, const N: usize> {
    motion: &'a Motion<'a, R, L>,
    arm: &'a dyn Momenta<N>,
}

impl<'a, R: ForwardDynamics<N>, L, const N: usize> InMomenta<'a, R, L, N> {
    /// `None` where the arm is not known in momenta.
    pub(super) fn new(motion: &'a Motion<'a, R, L>) -> Option<Self> {
        let arm = motion.robot.momenta()?;
        Some(InMomenta { motion, arm })
    }
}

impl<R, L: TorqueLaw<N>, const N: usize> Canonical<N> for InMomenta<'_, R, L, N> {
    type Refusal = Cause;

    fn momentum(&self, phase: &Phase<N>) -> Result<SVector<f64, N>, Cause> {
        Ok(self.arm.momentum(&phase.q, &phase.qd))
    }

    fn phase(&self, at: &Point<N>) -> Result<Phase<N>, Cause> {
        if let Some(joint) = at.first_non_finite() {
            return Err(Cause::NonFiniteState { joint });
        }
        let qd = self.arm.velocity(&at.q, &at.p)?;
        Ok(Phase { q: at.q, qd })
    }

    fn rate(&self, t: f64, at: &Point<N>) -> Result<Point<N>, Cause> {
        let phase = self.phase(at)?;
        let tau = self.motion.torque(t, &phase)?;
        self.motion.count();
        let p = self.arm.force(&phase.q, &phase.qd, &tau);
        match first_non_finite(&p) {
            Some(joint) => Err(Cause::NonFiniteAcceleration { joint }),
            None => Ok(Point { q: phase.qd, p }),
        }
    }
}
