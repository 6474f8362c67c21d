//! Vectors.

use super::Ring;
use crate::operators::impl_operators;
use core::ops::{Index, Mul};

/// A vector of three components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector3<R>(pub [R; 3]);

impl<R: Ring> Vector3<R> {
    /// The vector (x, y, z).
    pub fn new(x: R, y: R, z: R) -> Self {
        Vector3([x, y, z])
    }

    /// The same component three times.
    pub fn splat(x: R) -> Self {
        Vector3([x; 3])
    }

    /// a . b
    pub fn dot(self, other: Self) -> R {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    /// a x b
    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Vector3([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// v + k z
    pub fn plus_z(self, k: R) -> Self {
        let [x, y, z] = self.0;
        Vector3([x, y, z + k])
    }

    /// The vector times a number.
    pub fn scale(self, k: R) -> Self {
        Vector3(self.0.map(|x| k * x))
    }
}

impl<R> Index<usize> for Vector3<R> {
    type Output = R;

    fn index(&self, i: usize) -> &R {
        &self.0[i]
    }
}

impl_operators! {
    impl [R: Ring] for Vector3<R>;
    Add add |left, right| {
        let ([a, b, c], [x, y, z]) = (left.0, right.0);
        Vector3([a + x, b + y, c + z])
    };
    Sub sub |left, right| {
        let ([a, b, c], [x, y, z]) = (left.0, right.0);
        Vector3([a - x, b - y, c - z])
    };
    Neg neg |a| Vector3(a.0.map(|x| -x));
}

impl<R: Ring> Mul<R> for Vector3<R> {
    type Output = Self;

    fn mul(self, k: R) -> Self {
        self.scale(k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Vector3<i64> = Vector3([2, -3, 5]);
    const B: Vector3<i64> = Vector3([7, 11, -13]);

    #[test]
    fn axes_are_right_handed() {
        let [x, y, z] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(Vector3);
        assert_eq!(x.cross(y), z);
        assert_eq!(y.cross(z), x);
        assert_eq!(z.cross(x), y);
    }

    #[test]
    fn products() {
        assert_eq!(A.dot(B), 14 - 33 - 65);
        let normal = A.cross(B);
        assert_eq!((normal.dot(A), normal.dot(B)), (0, 0));
        // |a x b|^2 = |a|^2 |b|^2 - (a.b)^2
        assert_eq!(
            normal.dot(normal),
            A.dot(A) * B.dot(B) - A.dot(B) * A.dot(B)
        );
    }

    #[test]
    fn sums_and_multiples() {
        assert_eq!(A + B - B, A);
        assert_eq!(A * 3, A + A + A);
        assert_eq!(-A, A.scale(-1));
        assert_eq!((A + Vector3::splat(1))[1], A[1] + 1);
    }
}
