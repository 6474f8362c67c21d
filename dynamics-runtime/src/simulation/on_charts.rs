//! A robot as equations of motion in what is integrated: the positions of joints, behind coordinates of a base that moves.

use super::error::{Outcome, SizedSimulationError};
use super::trajectory::SizedTrajectory;
use crate::size::Size;
use crate::stand::{Charted, Stand, Velocities};
use crate::{EquationsOfMotion, Responses, SingularMassMatrix, SizedMomenta};

/// A robot, and the charts in which a base that moves is followed.
pub(super) struct OnCharts<'a, R, K: Stand> {
    pub(super) robot: &'a R,
    pub(super) charts: &'a K::Charts,
}

impl<R: EquationsOfMotion<K>, K: Stand> EquationsOfMotion<K::Freedoms> for OnCharts<'_, R, K> {
    fn size(&self) -> K::Freedoms {
        self.robot.size()
    }

    #[inline]
    fn accelerations(
        &self,
        positions: &Velocities<K>,
        v: &Velocities<K>,
        tau: &Velocities<K>,
    ) -> Result<Velocities<K>, SingularMassMatrix> {
        K::seen(self.charts, positions, |place| {
            self.robot.accelerations(place, v, tau)
        })
    }

    fn accelerations_and_responses(
        &self,
        positions: &Velocities<K>,
        v: &Velocities<K>,
        tau: &Velocities<K>,
        freedoms: &<K::Freedoms as Size>::Each<bool>,
    ) -> Result<Responses<K::Freedoms>, SingularMassMatrix> {
        K::seen(self.charts, positions, |place| {
            self.robot
                .accelerations_and_responses(place, v, tau, freedoms)
        })
    }

    #[inline]
    fn in_momenta(&self) -> Option<&dyn SizedMomenta<K::Freedoms>> {
        self.robot.in_momenta()
    }

    #[inline]
    fn charts(&self) -> Option<&dyn Charted<K::Freedoms>> {
        K::charted(self.charts)
    }
}

/// The motion of the robot itself, from that in charts.
pub(super) fn placed<K: Stand>(charts: K::Charts, end: Outcome<K::Freedoms>) -> Outcome<K> {
    let (motion, reached) = match end {
        Ok(motion) => (motion, None),
        Err(error) => {
            let place = K::seen(&charts, &error.q, K::kept);
            let reached = (error.time, place, error.qd, error.cause);
            (error.trajectory, Some(reached))
        }
    };
    let (base, q) = K::sampled(charts, motion.q);
    let trajectory = SizedTrajectory {
        t: motion.t,
        base,
        q,
        qd: motion.qd,
        qdd: motion.qdd,
        tau: motion.tau,
        work: motion.work,
        creeping: motion.creeping,
    };
    let Some((time, (base, q), qd, cause)) = reached else {
        return Ok(trajectory);
    };
    Err(Box::new(SizedSimulationError {
        time,
        base,
        q,
        qd,
        cause,
        joint_names: Vec::new(),
        trajectory,
    }))
}
