//! Products that add to something, with fused operations where the target has them.

use nalgebra::{Matrix3, Vector3};

use crate::Scalar;

/// `a x b + c`.
#[inline(always)]
pub fn cross(a: &Vector3<f64>, b: &Vector3<f64>, c: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(
        difference(a.y, b.z, a.z, b.y) + c.x,
        difference(a.z, b.x, a.x, b.z) + c.y,
        difference(a.x, b.y, a.y, b.x) + c.z,
    )
}

/// `a b + c`.
#[inline(always)]
pub fn times(a: &Matrix3<f64>, b: &Vector3<f64>, c: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(
        dot([a.m11, a.m12, a.m13], [b.x, b.y, b.z]) + c.x,
        dot([a.m21, a.m22, a.m23], [b.x, b.y, b.z]) + c.y,
        dot([a.m31, a.m32, a.m33], [b.x, b.y, b.z]) + c.z,
    )
}

/// `a b - c d`.
#[inline(always)]
pub fn difference(a: f64, b: f64, c: f64, d: f64) -> f64 {
    Scalar::mul_add(a, b, -(c * d))
}

/// `a b + c d`.
#[inline(always)]
pub fn sum(a: f64, b: f64, c: f64, d: f64) -> f64 {
    Scalar::mul_add(a, b, c * d)
}

/// `a x + b y + c z`.
#[inline(always)]
pub fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    Scalar::mul_add(a, x, sum(b, y, c, z))
}
