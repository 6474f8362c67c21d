//! Dual numbers a + b e, e^2 = 0: derivatives without rounding.

use crate::linear::Ring;
use core::ops::{Add, Mul, Neg, Sub};

/// A value and its derivative in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Dual<R> {
    pub(super) value: R,
    pub(super) derivative: R,
}

impl<R: Ring> Dual<R> {
    pub(super) fn new(value: R, derivative: R) -> Self {
        Dual { value, derivative }
    }
}

impl<R: Ring> Add for Dual<R> {
    type Output = Self;

    fn add(self, o: Self) -> Self {
        Dual::new(self.value + o.value, self.derivative + o.derivative)
    }
}

impl<R: Ring> Sub for Dual<R> {
    type Output = Self;

    fn sub(self, o: Self) -> Self {
        Dual::new(self.value - o.value, self.derivative - o.derivative)
    }
}

impl<R: Ring> Neg for Dual<R> {
    type Output = Self;

    fn neg(self) -> Self {
        Dual::new(-self.value, -self.derivative)
    }
}

impl<R: Ring> Mul for Dual<R> {
    type Output = Self;

    fn mul(self, o: Self) -> Self {
        Dual::new(
            self.value * o.value,
            self.value * o.derivative + self.derivative * o.value,
        )
    }
}
