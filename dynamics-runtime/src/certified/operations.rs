//! The rule of each operation.
//!
//! With a' = a + e_a, what is known of a: |a' - a| is at most the bound of a. The result is what the operands
//! pass on, and what the operation itself leaves out (Higham, *Accuracy and Stability of Numerical Algorithms*,
//! 2nd ed., section 3.3).

use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::{One, Zero};

use super::outward::Bound;
use super::{Certified, Rounded};
use crate::operators::impl_assign;

impl<F: Rounded> Neg for Certified<F> {
    type Output = Self;

    fn neg(self) -> Self {
        Certified {
            value: -self.value,
            ..self
        }
    }
}

impl<F: Rounded> Add for Certified<F> {
    type Output = Self;

    /// |(a' + b') - (a + b)| <= |e_a| + |e_b|
    fn add(self, b: Self) -> Self {
        let value = self.value + b.value;
        let rounding = Bound::new(F::left_out(self.value, b.value, value));
        Certified::new(value, self.error + b.error + rounding)
    }
}

impl<F: Rounded> Sub for Certified<F> {
    type Output = Self;

    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl<F: Rounded> Mul for Certified<F> {
    type Output = Self;

    fn mul(self, b: Self) -> Self {
        let value = self.value * b.value;
        Certified::new(
            value,
            self.error_of_product(b) + self.rounding_of_product(b, value),
        )
    }
}

impl<F: Rounded> Div for Certified<F> {
    type Output = Self;

    /// |a'/b' - a/b| = |(a'/b') e_b - e_a| / |b|, and |b| >= |b'| - |e_b|.
    fn div(self, b: Self) -> Self {
        let value = self.value / b.value;
        let Some(least) = b.least_size().beyond(b.error) else {
            return Certified::new(value, Bound::UNKNOWN);
        };
        let rounding = match self.value == F::ZERO {
            true => Bound::NONE,
            false => Bound::new(value.rounding()),
        };
        let quotient = Bound::new(value.magnitude()) + rounding;
        let passed_on = (quotient * b.error + self.error) / least;
        Certified::new(value, passed_on + rounding)
    }
}

impl<F: Rounded> Certified<F> {
    /// |a' b' - a b| <= |a'| |e_b| + |b'| |e_a| + |e_a| |e_b|
    pub(super) fn error_of_product(self, b: Self) -> Bound<F::Magnitude> {
        self.size() * b.error + b.size() * self.error + self.error * b.error
    }

    /// What is left out of a product that is rounded to `value`: nothing of one by zero.
    fn rounding_of_product(self, b: Self, value: F) -> Bound<F::Magnitude> {
        match self.value == F::ZERO || b.value == F::ZERO {
            true => Bound::NONE,
            false => Bound::new(value.rounding()),
        }
    }

    /// |a'| + |e_a|: no exact number is larger.
    pub(super) fn largest(self) -> Bound<F::Magnitude> {
        self.size() + self.error
    }

    /// |a'|, which is no bound of |a|.
    pub(super) fn size(self) -> Bound<F::Magnitude> {
        Bound::new(self.value.magnitude())
    }

    /// |a'| or less.
    pub(super) fn least_size(self) -> Bound<F::Magnitude> {
        Bound::new(self.value.least_magnitude())
    }
}

impl_assign! { impl [F: Rounded] for Certified<F> }

impl<F: Rounded> Zero for Certified<F> {
    fn zero() -> Self {
        Certified::exact(F::ZERO)
    }

    fn is_zero(&self) -> bool {
        *self == Self::zero()
    }
}

impl<F: Rounded> One for Certified<F> {
    fn one() -> Self {
        Certified::exact(F::from_f64(1.0))
    }
}
