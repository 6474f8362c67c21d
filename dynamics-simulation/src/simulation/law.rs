//! Laws of the forces on a robot.

use dynamics_runtime::internal::Velocities;
use dynamics_runtime::{OnBase, Place, Pose, Size as _, Sizes};
use nalgebra::{Const, DVector, Dyn, SVector};

/// A law of the forces on a robot: a function of time, place and velocities.
pub trait ForceLaw<K: Sizes> {
    /// The forces.
    #[doc(hidden)]
    fn forces(
        &mut self,
        t: f64,
        place: &Place<K::Joints>,
        velocities: &Velocities<K>,
    ) -> Velocities<K>;
}

/// An arm: t, q, qd.
impl<F, const N: usize> ForceLaw<Const<N>> for F
where
    F: FnMut(f64, &SVector<f64, N>, &SVector<f64, N>) -> SVector<f64, N>,
{
    #[inline(always)]
    fn forces(&mut self, t: f64, place: &Place<Const<N>>, qd: &SVector<f64, N>) -> SVector<f64, N> {
        self(t, &place.q, qd)
    }
}

/// A robot on a base that moves: t, its pose, q, v.
impl<F, const N: usize, const V: usize> ForceLaw<OnBase<N, V>> for F
where
    F: FnMut(f64, &Pose<f64>, &SVector<f64, N>, &SVector<f64, V>) -> SVector<f64, V>,
{
    #[inline(always)]
    fn forces(&mut self, t: f64, place: &Place<Const<N>>, v: &SVector<f64, V>) -> SVector<f64, V> {
        self(t, &place.pose(), &place.q, v)
    }
}

/// A robot that is known at run time: t, its place, v.
impl<F> ForceLaw<Dyn> for F
where
    F: FnMut(f64, &Place<Dyn>, &DVector<f64>) -> DVector<f64>,
{
    #[inline(always)]
    fn forces(&mut self, t: f64, place: &Place<Dyn>, v: &DVector<f64>) -> DVector<f64> {
        self(t, place, v)
    }
}

/// No forces: free motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FreeMotion;

impl<K: Sizes> ForceLaw<K> for FreeMotion {
    fn forces(&mut self, _: f64, _: &Place<K::Joints>, v: &Velocities<K>) -> Velocities<K> {
        K::Freedoms::of(v).vector()
    }
}

impl<K: Sizes> ForceLaw<K> for &FreeMotion {
    fn forces(&mut self, _: f64, _: &Place<K::Joints>, v: &Velocities<K>) -> Velocities<K> {
        K::Freedoms::of(v).vector()
    }
}
