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

#[cfg(test)]
mod tests {
    use super::*;

    fn variable(x: i64) -> Dual<i64> {
        Dual::new(x, 1)
    }

    fn constant(x: i64) -> Dual<i64> {
        Dual::new(x, 0)
    }

    #[test]
    fn rules_of_differentiation() {
        let (x, k) = (variable(5), constant(3));
        assert_eq!(x + k, Dual::new(8, 1));
        assert_eq!(k - x, Dual::new(-2, -1));
        assert_eq!(-x, Dual::new(-5, -1));
        // (3 x^2 - x)' = 6 x - 1
        assert_eq!(k * x * x - x, Dual::new(70, 29));
    }

    /// Dual numbers over dual numbers: (x^3)'' = 6 x.
    #[test]
    fn second_derivatives() {
        let x = Dual::new(variable(2), constant(1));
        let cube = x * x * x;
        assert_eq!(cube.value, Dual::new(8, 12));
        assert_eq!(cube.derivative, Dual::new(12, 12));
    }
}
