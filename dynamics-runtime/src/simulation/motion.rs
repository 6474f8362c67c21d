//! An arm and its torque law as one equation of motion.

use nalgebra::SVector;

use super::Cause;
use crate::ForwardDynamics;
use crate::integrate::{Phase, first_non_finite};

pub(super) struct Motion<'a, R, L> {
    pub(super) robot: &'a R,
    pub(super) torque: &'a L,
}

impl<R, L> Motion<'_, R, L> {
    /// qdd, where everything on the way to it is finite.
    pub(super) fn acceleration<const N: usize>(
        &self,
        t: f64,
        phase: &Phase<N>,
    ) -> Result<SVector<f64, N>, Cause>
    where
        R: ForwardDynamics<N>,
        L: Fn(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>,
    {
        let Phase { q, qd } = phase;
        if let Some(joint) = phase.first_non_finite() {
            return Err(Cause::NonFiniteState { joint });
        }
        let tau = (self.torque)(t, q, qd);
        if let Some(joint) = first_non_finite(&tau) {
            return Err(Cause::NonFiniteTorque { joint });
        }
        let qdd = self.robot.forward_dynamics(q, qd, &tau)?;
        match first_non_finite(&qdd) {
            Some(joint) => Err(Cause::NonFiniteAcceleration { joint }),
            None => Ok(qdd),
        }
    }
}
