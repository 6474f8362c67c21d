//! Dual numbers a + b e, e^2 = 0: derivatives without rounding.

use crate::linear::Ring;
use crate::operators::impl_operators;

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

impl_operators! {
    impl [R: Ring] for Dual<R>;
    Add add |a, b| Dual::new(a.value + b.value, a.derivative + b.derivative);
    Sub sub |a, b| Dual::new(a.value - b.value, a.derivative - b.derivative);
    Neg neg |a| Dual::new(-a.value, -a.derivative);
    Mul mul |a, b| Dual::new(a.value * b.value, a.value * b.derivative + a.derivative * b.value);
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
