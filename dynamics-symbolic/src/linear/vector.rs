//! Vectors.

use super::Ring;
use core::ops::{Add, Index, Mul, Neg, Sub};

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

impl<R: Ring> Add for Vector3<R> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Vector3([a + x, b + y, c + z])
    }
}

impl<R: Ring> Sub for Vector3<R> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Vector3([a - x, b - y, c - z])
    }
}

impl<R: Ring> Neg for Vector3<R> {
    type Output = Self;

    fn neg(self) -> Self {
        Vector3(self.0.map(|x| -x))
    }
}

impl<R: Ring> Mul<R> for Vector3<R> {
    type Output = Self;

    fn mul(self, k: R) -> Self {
        self.scale(k)
    }
}
