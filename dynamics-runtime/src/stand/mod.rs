//! The base of a simulated robot: it stands or moves.

mod charts;

use core::fmt::Debug;
use core::marker::PhantomData;

pub(crate) use charts::{Charted, Charts};

use crate::Pose;
use crate::size::Size;

mod sealed {
    pub trait Sealed {}

    impl<D: crate::Size> Sealed for D {}

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
    /// The charts in which the base is followed, if it moves.
    #[doc(hidden)]
    type Charts;
    /// The law of free motion.
    type NoTorque;
    /// The pose of a base that moves; nothing of one that stands.
    type Pose: Clone + Debug + PartialEq;
    /// Such poses, one after the other.
    type Poses: Clone + Debug + PartialEq + Default + Extend<Self::Pose>;
    /// The number of velocities before those of the joints: six of a base that moves.
    #[doc(hidden)]
    const OF_BASE: usize;

    /// The law of free motion.
    #[doc(hidden)]
    fn no_torque() -> Self::NoTorque;

    /// The pose, if the base moves.
    #[doc(hidden)]
    fn pose(base: Pose<f64>) -> Self::Pose;

    /// Where the robot is.
    #[doc(hidden)]
    fn place<'a>(base: &'a Self::Pose, q: &'a <Self::Joints as Size>::Vector) -> Self::Place<'a>;

    /// The pose of a base that moves, and the positions of the joints.
    #[doc(hidden)]
    fn parts(place: Self::Place<'_>) -> (Option<&Pose<f64>>, &<Self::Joints as Size>::Vector);

    /// Where the robot is, one place after the other.
    #[doc(hidden)]
    fn places<'a>(
        base: &'a Self::Poses,
        q: &'a [<Self::Joints as Size>::Vector],
    ) -> impl ExactSizeIterator<Item = Self::Place<'a>> + DoubleEndedIterator;

    /// How many poses there are, if the base moves.
    #[doc(hidden)]
    fn count(poses: &Self::Poses) -> Option<usize>;

    /// The charts of a run that begins there.
    #[doc(hidden)]
    fn charts(start: &Self::Pose) -> Self::Charts;

    /// The charts, if the positions of the integration are coordinates in them.
    #[doc(hidden)]
    fn charted(charts: &Self::Charts) -> Option<&dyn Charted<Self::Freedoms>>;

    /// Hands on the place that the positions of the integration are.
    #[doc(hidden)]
    fn seen<X>(
        charts: &Self::Charts,
        positions: &<Self::Freedoms as Size>::Vector,
        then: impl FnOnce(Self::Place<'_>) -> X,
    ) -> X;

    /// Where the robot is at the samples of a run, by the positions of the integration there.
    #[doc(hidden)]
    fn sampled(
        charts: Self::Charts,
        positions: Vec<<Self::Freedoms as Size>::Vector>,
    ) -> (Self::Poses, Vec<<Self::Joints as Size>::Vector>);

    /// Where the robot is, to be kept.
    #[doc(hidden)]
    fn kept(place: Self::Place<'_>) -> (Self::Pose, <Self::Joints as Size>::Vector) {
        let (base, q) = Self::parts(place);
        let base = base.copied().unwrap_or_else(Pose::identity);
        (Self::pose(base), q.clone())
    }
}

/// The velocities of a robot; its accelerations and forces too.
pub(crate) type Velocities<K> = <<K as Stand>::Freedoms as Size>::Vector;

impl<D: Size> Stand for D {
    type Joints = D;
    type Freedoms = D;
    type Place<'a> = &'a D::Vector;
    type Charts = ();
    type NoTorque = fn(f64, &D::Vector, &D::Vector) -> D::Vector;
    type Pose = ();
    type Poses = ();
    const OF_BASE: usize = 0;

    fn no_torque() -> Self::NoTorque {
        |_, q, _| D::of(q).vector()
    }

    fn pose(_: Pose<f64>) {}

    fn place<'a>(_: &'a (), q: &'a D::Vector) -> &'a D::Vector {
        q
    }

    fn parts(q: Self::Place<'_>) -> (Option<&Pose<f64>>, &D::Vector) {
        (None, q)
    }

    fn places<'a>(
        _: &'a (),
        q: &'a [D::Vector],
    ) -> impl ExactSizeIterator<Item = &'a D::Vector> + DoubleEndedIterator {
        q.iter()
    }

    fn count((): &()) -> Option<usize> {
        None
    }

    fn charts(_: &()) {}

    #[inline(always)]
    fn charted(_: &()) -> Option<&dyn Charted<D>> {
        None
    }

    #[inline(always)]
    fn seen<X>(_: &(), q: &D::Vector, then: impl FnOnce(&D::Vector) -> X) -> X {
        then(q)
    }

    fn sampled(_: (), q: Vec<D::Vector>) -> ((), Vec<D::Vector>) {
        ((), q)
    }
}

/// A base that moves, below `D` joints: the robot has `V` = 6 + `D` velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnBase<D, V>(PhantomData<(D, V)>);

impl<D: Size, V: Size> Stand for OnBase<D, V> {
    type Joints = D;
    type Freedoms = V;
    type Place<'a> = (&'a Pose<f64>, &'a D::Vector);
    type Charts = Charts<D, V>;
    type NoTorque = fn(f64, &Pose<f64>, &D::Vector, &V::Vector) -> V::Vector;
    type Pose = Pose<f64>;
    type Poses = Vec<Pose<f64>>;
    const OF_BASE: usize = 6;

    fn no_torque() -> Self::NoTorque {
        |_, _, _, v| V::of(v).vector()
    }

    fn pose(base: Pose<f64>) -> Pose<f64> {
        base
    }

    fn place<'a>(base: &'a Pose<f64>, q: &'a D::Vector) -> Self::Place<'a> {
        (base, q)
    }

    fn parts<'a>((base, q): Self::Place<'a>) -> (Option<&'a Pose<f64>>, &'a D::Vector) {
        (Some(base), q)
    }

    fn places<'a>(
        base: &'a Vec<Pose<f64>>,
        q: &'a [D::Vector],
    ) -> impl ExactSizeIterator<Item = Self::Place<'a>> + DoubleEndedIterator {
        base.iter().zip(q)
    }

    fn count(poses: &Vec<Pose<f64>>) -> Option<usize> {
        Some(poses.len())
    }

    fn charts(start: &Pose<f64>) -> Charts<D, V> {
        Charts::around(start.rotation)
    }

    fn charted(charts: &Charts<D, V>) -> Option<&dyn Charted<V>> {
        Some(charts)
    }

    fn seen<X>(
        charts: &Charts<D, V>,
        positions: &V::Vector,
        then: impl FnOnce(Self::Place<'_>) -> X,
    ) -> X {
        then((&charts.pose(positions), &charts.joints(positions)))
    }

    fn sampled(
        charts: Charts<D, V>,
        positions: Vec<V::Vector>,
    ) -> (Vec<Pose<f64>>, Vec<D::Vector>) {
        let q = positions.iter().map(|at| charts.joints(at)).collect();
        (charts.noted(), q)
    }
}
