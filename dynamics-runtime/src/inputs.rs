//! Where generated functions get the sines of joint positions and the fields of their struct from.

use crate::{Part, Scalar};

/// Where a generated function gets the sines and cosines of joint positions and the struct's fields from.
#[doc(hidden)]
pub trait Inputs<T: Scalar> {
    /// Sines and cosines of the `positions` of some joints, by their indices.
    fn sin_cos<const K: usize>(&self, joints: [usize; K], positions: [T; K]) -> [(T, T); K];

    /// The same for a function that reads only these parts of them; the others are any numbers.
    #[inline(always)]
    fn sin_cos_parts<const K: usize>(
        &self,
        joints: [usize; K],
        parts: [Part; K],
        positions: [T; K],
    ) -> [(T, T); K] {
        let _ = parts;
        self.sin_cos(joints, positions)
    }

    /// A field, by its index, with its value in the struct at hand, in the arithmetic of `like`.
    #[inline(always)]
    fn field(&self, index: usize, value: f64, like: T) -> T {
        let _ = index;
        like.exact(value)
    }
}

/// Evaluates sines, all at once.
#[doc(hidden)]
pub struct Evaluated;

impl<T: Scalar> Inputs<T> for Evaluated {
    #[inline(always)]
    fn sin_cos<const K: usize>(&self, _: [usize; K], positions: [T; K]) -> [(T, T); K] {
        T::sin_cos_array(positions)
    }

    #[inline(always)]
    fn sin_cos_parts<const K: usize>(
        &self,
        _: [usize; K],
        parts: [Part; K],
        positions: [T; K],
    ) -> [(T, T); K] {
        T::sin_cos_parts(positions, parts)
    }
}

/// Looks sines up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known<T, const N: usize>(pub(crate) [(T, T); N]);

impl<T: Scalar, const N: usize> Inputs<T> for Known<T, N> {
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
