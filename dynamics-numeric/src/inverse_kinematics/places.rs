//! Places on a robot that targets are set for: its tip, and frames on its links.

use dynamics_runtime::{Size, SizedKinematics};
use nalgebra::Matrix4;

/// Where a frame is and how it moves: its pose, and its geometric Jacobian in the axes of the world.
pub type Placed<D> = (Matrix4<f64>, <D as Size>::Columns<6>);

/// One or more frames of a robot, each of which can have a target.
pub trait Places<D: Size> {
    /// How many there are.
    fn count(&self) -> usize;

    /// The pose of one of them, counted from 0, and its geometric Jacobian: rows vx vy vz wx wy wz in the world.
    fn place(&self, index: usize, q: &D::Vector) -> Placed<D>;
}

/// The tip of a robot.
#[derive(Debug)]
pub struct Tip<'a, R>(pub(super) &'a R);

impl<R> Clone for Tip<'_, R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Tip<'_, R> {}

impl<D: Size, R: SizedKinematics<D>> Places<D> for Tip<'_, R> {
    fn count(&self) -> usize {
        1
    }

    #[inline(always)]
    fn place(&self, _: usize, q: &D::Vector) -> Placed<D> {
        (self.0.tip_pose(q), self.0.tip_jacobian(q))
    }
}

/// Frames by functions of the joint positions, which return a pose and a Jacobian. A tuple of functions that a call of
/// `robot_dynamics!` requests is one: `hand = (forward_kinematics(hand), jacobian(hand))` gives `arm.hand(&q)`.
impl<D: Size, F: Fn(&D::Vector) -> Placed<D>, const K: usize> Places<D> for [F; K] {
    fn count(&self) -> usize {
        K
    }

    #[inline(always)]
    fn place(&self, index: usize, q: &D::Vector) -> Placed<D> {
        self[index](q)
    }
}

/// As many frames as a program finds at run time.
#[cfg(feature = "std")]
impl<D: Size, F: Fn(&D::Vector) -> Placed<D>> Places<D> for Vec<F> {
    fn count(&self) -> usize {
        self.len()
    }

    fn place(&self, index: usize, q: &D::Vector) -> Placed<D> {
        self[index](q)
    }
}
