//! The forces of the surroundings at the tool and at frames.
//!
//! J' w is added to the torque at every evaluation of the equations of motion, so that each method and the events of
//! friction see it. J and the pose are the generated ones (`Kinematics`).

use core::cell::{Cell, RefCell};
use core::fmt;
use std::rc::Rc;

use dynamics_runtime::internal::Velocities;
use dynamics_runtime::{OnBase, Place, Pose, Size, SizedKinematics, Sizes};
use nalgebra::{Const, Dyn, Matrix4, Matrix6xX, SMatrix, SVector, Vector6};

use super::error::Cause;

/// A time, and the place and the velocities then.
pub(super) type At<'p, K> = (f64, &'p Place<<K as Sizes>::Joints>, &'p Velocities<K>);

/// The pose of a frame and its Jacobian, rows vx vy vz wx wy wz.
type Frame<K> = (Matrix4<f64>, <<K as Sizes>::Freedoms as Size>::Columns<6>);

/// A force of the surroundings on a robot in a [`Simulation`](crate::Simulation): [`WrenchAt`] a frame.
pub trait Wrench<R, K: Sizes> {
    /// The joint torques `tau` with those of the force: tau + J^T w.
    #[doc(hidden)]
    fn added_to(
        &self,
        tau: Velocities<K>,
        robot: &R,
        at: (f64, &Place<K::Joints>, &Velocities<K>),
    ) -> Result<Velocities<K>, Cause>;

    /// Begins a period, if the law is sampled.
    #[doc(hidden)]
    fn sample(
        &self,
        _robot: &R,
        _at: (f64, &Place<K::Joints>, &Velocities<K>),
    ) -> Result<(), Cause> {
        Ok(())
    }
}

/// A frame of a robot: a function of the robot and its place that returns the frame's pose and Jacobian.
pub trait FrameOf<R, K: Sizes> {
    /// The pose and the Jacobian.
    #[doc(hidden)]
    fn frame(&self, robot: &R, place: &Place<K::Joints>) -> Frame<K>;
}

impl<R, P, const N: usize> FrameOf<R, Const<N>> for P
where
    P: Fn(&R, &SVector<f64, N>) -> (Matrix4<f64>, SMatrix<f64, 6, N>),
{
    fn frame(&self, robot: &R, place: &Place<Const<N>>) -> Frame<Const<N>> {
        self(robot, &place.q)
    }
}

impl<R, P, const N: usize, const V: usize> FrameOf<R, OnBase<N, V>> for P
where
    P: Fn(&R, &Pose<f64>, &SVector<f64, N>) -> (Matrix4<f64>, SMatrix<f64, 6, V>),
{
    fn frame(&self, robot: &R, place: &Place<Const<N>>) -> Frame<OnBase<N, V>> {
        self(robot, &place.pose(), &place.q)
    }
}

impl<R, P> FrameOf<R, Dyn> for P
where
    P: Fn(&R, &Place<Dyn>) -> (Matrix4<f64>, Matrix6xX<f64>),
{
    fn frame(&self, robot: &R, place: &Place<Dyn>) -> Frame<Dyn> {
        self(robot, place)
    }
}

/// The tip of an arm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tip;

impl<R: SizedKinematics<D>, D: Size> FrameOf<R, D> for Tip {
    fn frame(&self, robot: &R, place: &Place<D>) -> Frame<D> {
        (robot.tip_pose(&place.q), robot.tip_jacobian(&place.q))
    }
}

/// A force at a frame.
#[derive(Clone, Copy, Debug)]
pub struct WrenchAt<P, F> {
    frame: P,
    law: F,
}

impl<P, F> WrenchAt<P, F> {
    /// `frame` returns the pose and the Jacobian of the frame, and `law` the wrench there, as in
    /// [`wrench_at`](crate::Simulation::wrench_at).
    pub fn new(frame: P, law: F) -> Self {
        WrenchAt { frame, law }
    }
}

impl<R, P: FrameOf<R, K>, F, K: Sizes> Wrench<R, K> for WrenchAt<P, F>
where
    F: Fn(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64>,
{
    fn added_to(
        &self,
        tau: Velocities<K>,
        robot: &R,
        (t, place, v): At<'_, K>,
    ) -> Result<Velocities<K>, Cause> {
        let (pose, jacobian) = self.frame.frame(robot, place);
        let wrench = (self.law)(t, &pose, &twist::<K::Freedoms>(&jacobian, v));
        Ok(tau + torques::<K::Freedoms>(&jacobian, &finite(wrench)?, v))
    }
}

/// A law of the force at a frame that is called once each period. In between, the force is held in the axes of the
/// Jacobian.
pub(super) struct HeldWrench<P, F> {
    frame: P,
    law: RefCell<F>,
    wrench: Cell<Vector6<f64>>,
}

impl<P, F> HeldWrench<P, F> {
    pub(super) fn new(frame: P, law: F) -> Self {
        HeldWrench {
            frame,
            law: RefCell::new(law),
            wrench: Cell::new(Vector6::zeros()),
        }
    }
}

impl<R, P: FrameOf<R, K>, F, K: Sizes> Wrench<R, K> for HeldWrench<P, F>
where
    F: FnMut(f64, &Matrix4<f64>, &Vector6<f64>) -> Vector6<f64>,
{
    fn added_to(
        &self,
        tau: Velocities<K>,
        robot: &R,
        (_, place, v): At<'_, K>,
    ) -> Result<Velocities<K>, Cause> {
        let (_, jacobian) = self.frame.frame(robot, place);
        Ok(tau + torques::<K::Freedoms>(&jacobian, &self.wrench.get(), v))
    }

    fn sample(&self, robot: &R, (t, place, v): At<'_, K>) -> Result<(), Cause> {
        let (pose, jacobian) = self.frame.frame(robot, place);
        let twist = twist::<K::Freedoms>(&jacobian, v);
        let wrench = (self.law.borrow_mut())(t, &pose, &twist);
        self.wrench.set(finite(wrench)?);
        Ok(())
    }
}

/// All forces of the surroundings on a robot. Copies of a simulation share their laws.
pub(super) struct Wrenches<'a, R, K>(Vec<Rc<dyn Wrench<R, K> + 'a>>);

impl<R, K> Default for Wrenches<'_, R, K> {
    fn default() -> Self {
        Wrenches(Vec::new())
    }
}

impl<R, K> Clone for Wrenches<'_, R, K> {
    fn clone(&self) -> Self {
        Wrenches(self.0.clone())
    }
}

impl<R, K> fmt::Debug for Wrenches<'_, R, K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} forces", self.0.len())
    }
}

impl<'a, R, K: Sizes> Wrenches<'a, R, K> {
    /// These forces and another one.
    pub(super) fn and(mut self, wrench: impl Wrench<R, K> + 'a) -> Self {
        self.0.push(Rc::new(wrench));
        self
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The joint torques with those of all forces.
    pub(super) fn added_to(
        &self,
        tau: Velocities<K>,
        robot: &R,
        at: At<'_, K>,
    ) -> Result<Velocities<K>, Cause> {
        let mut wrenches = self.0.iter();
        wrenches.try_fold(tau, |tau, wrench| wrench.added_to(tau, robot, at))
    }

    /// Begins a period.
    pub(super) fn sample(&self, robot: &R, at: At<'_, K>) -> Result<(), Cause> {
        self.0
            .iter()
            .try_for_each(|wrench| wrench.sample(robot, at))
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
