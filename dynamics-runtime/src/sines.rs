//! Where generated functions get the sines of joint positions from.

use crate::Scalar;

/// Where a generated function gets the sines and cosines of joint positions from.
#[doc(hidden)]
pub trait JointSines<T> {
    /// Sines and cosines of the `positions` of some joints, by their indices.
    fn sin_cos<const K: usize>(&self, joints: [usize; K], positions: [T; K]) -> [(T, T); K];
}

/// Evaluates them, all at once.
#[doc(hidden)]
pub struct Evaluated;

impl<T: Scalar> JointSines<T> for Evaluated {
    #[inline(always)]
    fn sin_cos<const K: usize>(&self, _: [usize; K], positions: [T; K]) -> [(T, T); K] {
        T::sin_cos_array(positions)
    }
}

/// Looks them up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known<T, const N: usize>(pub(crate) [(T, T); N]);

impl<T: Scalar, const N: usize> JointSines<T> for Known<T, N> {
    #[inline(always)]
    fn sin_cos<const K: usize>(&self, joints: [usize; K], _: [T; K]) -> [(T, T); K] {
        // Not `map`, which is not inlined for certain.
        let mut pairs = [self.0[0]; K];
        for (pair, joint) in pairs.iter_mut().zip(joints) {
            *pair = self.0[joint];
        }
        pairs
    }
}
