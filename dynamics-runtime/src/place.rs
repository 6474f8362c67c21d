//! Where a robot is, and how many joints and velocities it has.

use core::marker::PhantomData;

use nalgebra::{Const, Dim as _};

use crate::Pose;
use crate::size::Size;

/// Where a robot is: the pose of a base that moves, and the positions of the joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Place<D: Size> {
    /// The pose of a base that moves; `None` of one that stands.
    pub base: Option<Pose<f64>>,
    /// Joint positions, rad or m.
    pub q: D::Vector,
}

impl<D: Size> Place<D> {
    /// The pose of the base, which is the world's frame where it stands.
    #[doc(hidden)]
    pub fn pose(&self) -> Pose<f64> {
        self.base.unwrap_or_else(Pose::identity)
    }
}

mod sealed {
    pub trait Sealed {}

    impl<D: crate::Size> Sealed for D {}

    impl<const N: usize, const V: usize> Sealed for super::OnBase<N, V> {}
}

/// The numbers of joints and of velocities of a simulated robot. A [`Size`] has as many of both: `Const<N>` of an arm, and
/// `Dyn` of any robot that is known at run time. A base that moves is [`OnBase`].
pub trait Sizes: sealed::Sealed + 'static {
    /// The number of joints.
    type Joints: Size;
    /// The number of velocities.
    type Freedoms: Size;
}

/// The velocities of a robot; its accelerations and forces too.
pub type Velocities<K> = <<K as Sizes>::Freedoms as Size>::Vector;

/// Whether sizes that the compiler knows are those of a base that moves.
pub fn moves<K: Sizes>() -> bool {
    K::Joints::try_to_usize() != K::Freedoms::try_to_usize()
}

impl<D: Size> Sizes for D {
    type Joints = D;
    type Freedoms = D;
}

/// A base that moves, below `N` joints: the robot has `V` = 6 + `N` velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnBase<const N: usize, const V: usize>(PhantomData<(Const<N>, Const<V>)>);

impl<const N: usize, const V: usize> Sizes for OnBase<N, V> {
    type Joints = Const<N>;
    type Freedoms = Const<V>;
}
