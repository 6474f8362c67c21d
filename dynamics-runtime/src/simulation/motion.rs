//! An arm and its torque law as one equation of motion.

use core::cell::Cell;

use nalgebra::SVector;

use super::{Cause, TorqueLaw};
use crate::ForwardDynamics;
use crate::integrate::{Equations, Phase, first_non_finite};

pub(super) struct Motion<'a, R, L> {
    robot: &'a R,
    torque: &'a L,
    /// How often the forward dynamics was evaluated.
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
        self.evaluations.set(self.evaluations.get() + 1);
        let qdd = self.robot.forward_dynamics(&phase.q, &phase.qd, &tau)?;
        match first_non_finite(&qdd) {
            Some(joint) => Err(Cause::NonFiniteAcceleration { joint }),
            None => Ok(qdd),
        }
    }
}
