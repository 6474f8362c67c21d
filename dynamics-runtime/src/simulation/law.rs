//! Laws of the forces on a robot, whatever its base does.

use crate::Pose;
use crate::size::Size;
use crate::stand::{OnBase, Stand, Velocities};

/// A law of the forces on a robot: a function of time, place and velocities.
pub trait ForceLaw<K: Stand> {
    /// The forces.
    #[doc(hidden)]
    fn forces(&mut self, t: f64, place: K::Place<'_>, velocities: &Velocities<K>) -> Velocities<K>;
}

impl<F: FnMut(f64, &D::Vector, &D::Vector) -> D::Vector, D: Size> ForceLaw<D> for F {
    #[inline(always)]
    fn forces(&mut self, t: f64, q: &D::Vector, qd: &D::Vector) -> D::Vector {
        self(t, q, qd)
    }
}

impl<F, D: Size, V: Size> ForceLaw<OnBase<D, V>> for F
where
    F: FnMut(f64, &Pose<f64>, &D::Vector, &V::Vector) -> V::Vector,
{
    #[inline(always)]
    fn forces(&mut self, t: f64, (base, q): (&Pose<f64>, &D::Vector), v: &V::Vector) -> V::Vector {
        self(t, base, q, v)
    }
}
