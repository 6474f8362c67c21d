//! The base of a simulated robot: it stands or moves.

#[cfg(feature = "std")]
mod charts;

use core::fmt::Debug;
#[cfg(feature = "std")]
use core::marker::PhantomData;

#[cfg(feature = "std")]
use nalgebra::Matrix3;

#[cfg(feature = "std")]
pub(crate) use charts::{Charted, Charts};

#[cfg(feature = "std")]
use crate::Pose;
use crate::size::Size;

mod sealed {
    pub trait Sealed {}

    impl<D: crate::Size> Sealed for D {}

    #[cfg(feature = "std")]
    impl<D: crate::Size, V: crate::Size> Sealed for super::OnBase<D, V> {}
}

/// The base of a simulated robot and the number of its joints: a [`Size`] if the base stands, and [`OnBase`] if it moves.
pub trait Stand: sealed::Sealed + 'static {
    /// The number of joints.
    type Joints: Size;
    /// The number of velocities.
    type Freedoms: Size;
    /// Where the robot is, as laws are given it: q, or the pose of the base and q.
    type Place<'a>: Copy;
    /// The rotation of the base at the start, if it moves.
    type Start: Clone + Debug;
    /// The charts in which the base is followed, if it moves.
    #[doc(hidden)]
    type Charts;
    /// The law of free motion.
    type NoTorque;

    /// No rotation.
    #[doc(hidden)]
    fn start() -> Self::Start;

    /// The law of free motion.
    #[doc(hidden)]
    fn no_torque() -> Self::NoTorque;

    /// Hands on the place that the positions of the integration are.
    #[doc(hidden)]
    fn seen<X>(
        charts: &Self::Charts,
        positions: &<Self::Freedoms as Size>::Vector,
        then: impl FnOnce(Self::Place<'_>) -> X,
    ) -> X;
}

/// The velocities of a robot; its accelerations and forces too.
pub(crate) type Velocities<K> = <<K as Stand>::Freedoms as Size>::Vector;

impl<D: Size> Stand for D {
    type Joints = D;
    type Freedoms = D;
    type Place<'a> = &'a D::Vector;
    type Start = ();
    type Charts = ();
    type NoTorque = fn(f64, &D::Vector, &D::Vector) -> D::Vector;

    fn start() {}

    fn no_torque() -> Self::NoTorque {
        |_, q, _| D::of(q).vector()
    }

    #[inline(always)]
    fn seen<X>(_: &(), q: &D::Vector, then: impl FnOnce(&D::Vector) -> X) -> X {
        then(q)
    }
}

/// A base that moves, below `D` joints: the robot has `V` = 6 + `D` velocities.
#[derive(Clone, Copy, Debug)]
#[cfg(feature = "std")]
pub struct OnBase<D, V>(PhantomData<(D, V)>);

#[cfg(feature = "std")]
impl<D: Size, V: Size> Stand for OnBase<D, V> {
    type Joints = D;
    type Freedoms = V;
    type Place<'a> = (&'a Pose<f64>, &'a D::Vector);
    type Start = Matrix3<f64>;
    type Charts = Charts<D, V>;
    type NoTorque = fn(f64, &Pose<f64>, &D::Vector, &V::Vector) -> V::Vector;

    fn start() -> Matrix3<f64> {
        Matrix3::identity()
    }

    fn no_torque() -> Self::NoTorque {
        |_, _, _, v| V::of(v).vector()
    }

    fn seen<X>(
        charts: &Charts<D, V>,
        positions: &V::Vector,
        then: impl FnOnce(Self::Place<'_>) -> X,
    ) -> X {
        then((&charts.pose(positions), &charts.joints(positions)))
    }
}
