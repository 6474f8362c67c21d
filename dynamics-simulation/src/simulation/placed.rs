//! A robot as equations of motion in what is integrated: the positions of joints, behind coordinates of a base that moves.

use core::cell::Cell;

use dynamics_runtime::internal::Velocities;
use dynamics_runtime::{
    EquationsOfMotion, JointVector as _, Place, Pose, Responses, SingularMassMatrix, Size,
    SizedMomenta, Sizes,
};
use nalgebra::Dim as _;

use super::error::{Outcome, SizedSimulationError};
use super::trajectory::SizedTrajectory;
use crate::chart::Chart;
use crate::integrate::Phase;

/// A robot whose equations are known in the coordinates of an integration.
pub(super) trait InCoordinates<D: Size> {
    /// The number of coordinates.
    fn size(&self) -> D;

    /// The accelerations under some torques.
    fn accelerations(
        &self,
        phase: &Phase<D>,
        tau: &D::Vector,
    ) -> Result<D::Vector, SingularMassMatrix>;

    /// The same, and the columns of M^-1 that belong to some freedoms.
    fn responses(
        &self,
        phase: &Phase<D>,
        tau: &D::Vector,
        freedoms: &D::Each<bool>,
    ) -> Result<Responses<D>, SingularMassMatrix>;

    /// The robot in positions and momenta.
    fn in_momenta(&self) -> Option<&dyn SizedMomenta<D>> {
        None
    }

    /// The pose of a base that moves.
    fn base(&self, _positions: &D::Vector) -> Option<Pose<f64>> {
        None
    }

    /// The rates of the coordinates.
    fn rates(&self, phase: &Phase<D>) -> D::Vector {
        phase.qd.clone()
    }

    /// Goes to the chart around a place, and returns its coordinates there.
    fn recentre(&self, positions: &D::Vector) -> D::Vector {
        positions.clone()
    }
}

/// A robot, and the chart in which a base that moves is followed.
#[derive(Debug)]
pub(super) struct Placed<'a, R, K> {
    pub(super) robot: &'a R,
    chart: Cell<Chart>,
    sizes: core::marker::PhantomData<K>,
}

impl<'a, R: EquationsOfMotion<K>, K: Sizes> Placed<'a, R, K> {
    /// A robot at a place, and the coordinates there.
    pub(super) fn at(robot: &'a R, place: &Place<K::Joints>) -> (Self, Velocities<K>) {
        let placed = Placed {
            robot,
            chart: Cell::new(Chart::around(place.pose().rotation)),
            sizes: core::marker::PhantomData,
        };
        let (base, position) = (placed.of_base(), place.pose().position);
        let coordinates = robot.size().vector_of(|k| match k {
            _ if k >= base => place.q[k - base],
            0..3 => position[k],
            _ => 0.0,
        });
        (placed, coordinates)
    }

    /// The number of coordinates of the base.
    #[inline(always)]
    fn of_base(&self) -> usize {
        self.robot.size().value() - self.robot.joints().value()
    }

    /// The positions of the joints.
    #[inline(always)]
    fn joints(&self, positions: &Velocities<K>) -> <K::Joints as Size>::Vector {
        let q = &positions.entries()[self.of_base()..];
        self.robot.joints().vector_of(|i| q[i])
    }

    /// Where the robot is.
    #[inline(always)]
    pub(super) fn place(&self, positions: &Velocities<K>) -> Place<K::Joints> {
        Place {
            base: self.base(positions),
            q: self.joints(positions),
        }
    }

    /// The motion of the robot itself, from that in coordinates.
    pub(super) fn motion(&self, end: Outcome<K::Freedoms>) -> Outcome<K> {
        match end {
            Ok(motion) => Ok(self.trajectory(motion)),
            Err(error) => {
                let Place { base, q } = self.place(&error.q);
                Err(Box::new(SizedSimulationError {
                    time: error.time,
                    base: base.unwrap_or_else(Pose::identity),
                    q,
                    qd: error.qd,
                    cause: error.cause,
                    joint_names: error.joint_names,
                    trajectory: self.trajectory(error.trajectory),
                }))
            }
        }
    }

    fn trajectory(&self, motion: SizedTrajectory<K::Freedoms>) -> SizedTrajectory<K> {
        SizedTrajectory {
            t: motion.t,
            base: motion.base,
            // In the same memory, if the base stands.
            q: motion.q.into_iter().map(|at| self.joints(&at)).collect(),
            qd: motion.qd,
            qdd: motion.qdd,
            tau: motion.tau,
            work: motion.work,
            creeping: motion.creeping,
        }
    }
}

impl<R: EquationsOfMotion<K>, K: Sizes> InCoordinates<K::Freedoms> for Placed<'_, R, K> {
    fn size(&self) -> K::Freedoms {
        self.robot.size()
    }

    fn accelerations(
        &self,
        phase: &Phase<K::Freedoms>,
        tau: &Velocities<K>,
    ) -> Result<Velocities<K>, SingularMassMatrix> {
        let place = self.place(&phase.q);
        self.robot.accelerations(&place, &phase.qd, tau)
    }

    fn responses(
        &self,
        phase: &Phase<K::Freedoms>,
        tau: &Velocities<K>,
        freedoms: &<K::Freedoms as Size>::Each<bool>,
    ) -> Result<Responses<K::Freedoms>, SingularMassMatrix> {
        let (place, qd) = (self.place(&phase.q), &phase.qd);
        self.robot
            .accelerations_and_responses(&place, qd, tau, freedoms)
    }

    fn in_momenta(&self) -> Option<&dyn SizedMomenta<K::Freedoms>> {
        self.robot.in_momenta()
    }

    #[inline(always)]
    fn base(&self, positions: &Velocities<K>) -> Option<Pose<f64>> {
        (self.of_base() > 0).then(|| self.chart.get().pose::<K::Freedoms>(positions))
    }

    fn rates(&self, phase: &Phase<K::Freedoms>) -> Velocities<K> {
        self.chart.get().rates::<K::Freedoms>(&phase.q, &phase.qd)
    }

    fn recentre(&self, positions: &Velocities<K>) -> Velocities<K> {
        let (chart, centre) = self.chart.get().recentred::<K::Freedoms>(positions);
        self.chart.set(chart);
        centre
    }
}
