//! The rule of each operation.
//!
//! With a' = a + e_a, |e_a| is at most the bound of a. The error of a result is that which the operands pass on and the
//! rounding of the operation (Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., section 3.3).

use core::ops::{Add, Div, Mul};

use super::outward::Bound;
use super::{Certified, Rounded};
use crate::operators::{impl_assign, impl_operators};

impl_operators! {
    impl [F: Rounded] for Certified<F>;
    Neg neg |a| Certified { value: -a.value, ..a };
    Sub sub |a, b| a + -b;
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

impl<F: Rounded> Mul for Certified<F> {
    type Output = Self;

    fn mul(self, b: Self) -> Self {
        let value = self.value * b.value;
        let rounding = Self::rounding(value, self.value == F::ZERO || b.value == F::ZERO);
        Certified::new(value, self.error_of_product(b) + rounding)
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
        let rounding = Self::rounding(value, self.value == F::ZERO);
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

    /// The bound of the rounding to `value`: zero where the operation is exact, as that by zero is.
    pub(super) fn rounding(value: F, is_exact: bool) -> Bound<F::Magnitude> {
        if is_exact {
            Bound::NONE
        } else {
            Bound::new(value.rounding())
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

impl_assign! { impl [F: Rounded] for Certified<F>; |x| Certified::exact(F::from_f64(x)) }
