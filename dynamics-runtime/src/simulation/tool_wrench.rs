//! The forces of the surroundings at the tool and at frames.
//!
//! J' w is added to the torque at every evaluation of the equations of motion, so that each method and the events of
//! friction see it. J and the pose are the generated ones (`Kinematics`). Without a force the type is `NoToolWrench`,
//! which adds nothing.

use nalgebra::{Matrix4, Vector6};

use super::error::Cause;
use crate::size::Size;
use crate::stand::{OnBase, Stand, Velocities};
use crate::{Pose, SizedKinematics};

/// A time, and the place and the velocities then.
type At<'p, 'v, K> = (f64, <K as Stand>::Place<'p>, &'v Velocities<K>);

/// The force at the tool in a [`Simulation`](crate::Simulation): none, or a law, which needs an arm with generated
/// [`Kinematics`](crate::Kinematics).
pub trait ToolWrench<R, K: Stand> {
    /// The joint torques `tau` with those of the force: tau + J^T w.
    #[doc(hidden)]
    fn added_to(
        &self,
        tau: Velocities<K>,
        robot: &R,
        at: At<'_, '_, K>,
    ) -> Result<Velocities<K>, Cause>;

    /// Begins a period, where the law is sampled.
    #[doc(hidden)]
    fn sample(&mut self, _robot: &R, _at: At<'_, '_, K>) -> Result<(), Cause> {
        Ok(())
    }
}

/// A force at the tool that needs no period: none, or a function of time and state.
#[diagnostic::on_unimplemented(
    message = "a held force at the tool needs a period",
    label = "a law of `held_tool_wrench`, which is called once each period",
    note = "call `.control_period(period)` before `.run()`, or give the law by `.tool_wrench(..)` as a function of time and state"
)]
pub trait ContinuousWrench {}

impl ContinuousWrench for NoToolWrench {}

impl<F> ContinuousWrench for F where F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64> {}

/// No force at the tool.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoToolWrench;

impl<R, K: Stand> ToolWrench<R, K> for NoToolWrench {
    #[inline]
    fn added_to(
        &self,
        tau: Velocities<K>,
        _robot: &R,
        _at: At<'_, '_, K>,
    ) -> Result<Velocities<K>, Cause> {
        Ok(tau)
    }
}

impl<R, F, D: Size> ToolWrench<R, D> for F
where
    R: SizedKinematics<D>,
    F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64>,
{
    fn added_to(&self, tau: D::Vector, robot: &R, at: At<'_, '_, D>) -> Result<D::Vector, Cause> {
        let (t, q, qd) = at;
        let (pose, jacobian) = (robot.tip_pose(q), robot.tip_jacobian(q));
        let wrench = finite(self(t, &pose, &twist::<D>(&jacobian, qd)))?;
        Ok(tau + torques::<D>(&jacobian, &wrench, q))
    }
}

/// A law of the force at the tool that is called once each period. In between, the force is held in the axes of
/// `jacobian`.
#[derive(Clone, Copy, Debug)]
pub struct HeldToolWrench<F> {
    pub(super) law: F,
    pub(super) wrench: Vector6<f64>,
}

impl<R, F, D: Size> ToolWrench<R, D> for HeldToolWrench<F>
where
    R: SizedKinematics<D>,
    F: FnMut(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64>,
{
    fn added_to(&self, tau: D::Vector, robot: &R, at: At<'_, '_, D>) -> Result<D::Vector, Cause> {
        let (_, q, _) = at;
        Ok(tau + torques::<D>(&robot.tip_jacobian(q), &self.wrench, q))
    }

    fn sample(&mut self, robot: &R, (t, q, qd): At<'_, '_, D>) -> Result<(), Cause> {
        let twist = twist::<D>(&robot.tip_jacobian(q), qd);
        self.wrench = finite((self.law)(t, &robot.tip_pose(q), &twist))?;
        Ok(())
    }
}

/// A force at a frame.
#[derive(Clone, Copy, Debug)]
pub struct WrenchAt<P, F> {
    place: P,
    law: F,
}

impl<P, F> WrenchAt<P, F> {
    /// `place` returns the pose and the Jacobian of the frame, and `law` the wrench there, as in
    /// [`wrench_at`](crate::Simulation::wrench_at).
    pub fn new(place: P, law: F) -> Self {
        WrenchAt { place, law }
    }
}

impl<P, F> ContinuousWrench for WrenchAt<P, F> {}

impl<R, P, F, D: Size> ToolWrench<R, D> for WrenchAt<P, F>
where
    P: Fn(&R, &D::Vector) -> (Matrix4<f64>, D::Columns<6>),
    F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64>,
{
    fn added_to(&self, tau: D::Vector, robot: &R, at: At<'_, '_, D>) -> Result<D::Vector, Cause> {
        let (t, q, qd) = at;
        let (pose, jacobian) = (self.place)(robot, q);
        let wrench = finite((self.law)(t, &pose, &twist::<D>(&jacobian, qd)))?;
        Ok(tau + torques::<D>(&jacobian, &wrench, q))
    }
}

impl<R, P, F, D: Size, V: Size> ToolWrench<R, OnBase<D, V>> for WrenchAt<P, F>
where
    P: Fn(&R, &Pose<f64>, &D::Vector) -> (Matrix4<f64>, V::Columns<6>),
    F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64>,
{
    fn added_to(
        &self,
        tau: V::Vector,
        robot: &R,
        at: At<'_, '_, OnBase<D, V>>,
    ) -> Result<V::Vector, Cause> {
        let (t, (base, q), v) = at;
        let (pose, jacobian) = (self.place)(robot, base, q);
        let wrench = finite((self.law)(t, &pose, &twist::<V>(&jacobian, v)))?;
        Ok(tau + torques::<V>(&jacobian, &wrench, v))
    }
}

impl<A: ContinuousWrench, B: ContinuousWrench> ContinuousWrench for (A, B) {}

/// Both forces.
impl<R, A: ToolWrench<R, K>, B: ToolWrench<R, K>, K: Stand> ToolWrench<R, K> for (A, B) {
    fn added_to(
        &self,
        tau: Velocities<K>,
        robot: &R,
        at: At<'_, '_, K>,
    ) -> Result<Velocities<K>, Cause> {
        let tau = self.0.added_to(tau, robot, at)?;
        self.1.added_to(tau, robot, at)
    }

    fn sample(&mut self, robot: &R, at: At<'_, '_, K>) -> Result<(), Cause> {
        self.0.sample(robot, at)?;
        self.1.sample(robot, at)
    }
}

impl<W: ContinuousWrench> ContinuousWrench for Vec<W> {}

/// All of these forces.
impl<R, W: ToolWrench<R, K>, K: Stand> ToolWrench<R, K> for Vec<W> {
    fn added_to(
        &self,
        tau: Velocities<K>,
        robot: &R,
        at: At<'_, '_, K>,
    ) -> Result<Velocities<K>, Cause> {
        let mut wrenches = self.iter();
        wrenches.try_fold(tau, |tau, wrench| wrench.added_to(tau, robot, at))
    }

    fn sample(&mut self, robot: &R, at: At<'_, '_, K>) -> Result<(), Cause> {
        let mut wrenches = self.iter_mut();
        wrenches.try_for_each(|wrench| wrench.sample(robot, at))
    }
}

/// J qd.
fn twist<D: Size>(jacobian: &D::Columns<6>, qd: &D::Vector) -> Vector6<f64> {
    let entry = |i| D::of(qd).joints().map(|j| jacobian[(i, j)] * qd[j]).sum();
    Vector6::from_fn(|i, _| entry(i))
}

/// J^T w: as many numbers as `like` has.
fn torques<D: Size>(
    jacobian: &D::Columns<6>,
    wrench: &Vector6<f64>,
    like: &D::Vector,
) -> D::Vector {
    D::of(like).vector_of(|j| (0..6).map(|i| jacobian[(i, j)] * wrench[i]).sum())
}

fn finite(wrench: Vector6<f64>) -> Result<Vector6<f64>, Cause> {
    match wrench.iter().position(|x| !x.is_finite()) {
        Some(component) => Err(Cause::NonFiniteToolWrench { component }),
        None => Ok(wrench),
    }
}
