//! The operations of double-double arithmetic.
//!
//! Names in brackets are those of algorithms in M. Joldes, J.-M. Muller, V. Popescu, *Tight and rigorous error bounds for
//! basic building blocks of double-word arithmetic*, ACM Trans. Math. Software 44 (2017), article 15.
//!
//! Sums, products and quotients are calls: inlined, a program of some hundred operations would take the compiler
//! minutes.

use core::ops::{Add, Div, Mul};

use super::DoubleDouble;
use crate::exact;
use crate::float::Float as _;
use crate::operators::{impl_assign, impl_operators};

/// Results that are not finite keep their value.
impl DoubleDouble {
    /// `a + b` without rounding.
    #[inline]
    pub fn sum(a: f64, b: f64) -> Self {
        finite_low(exact::two_sum(a, b))
    }

    /// The same where |a| >= |b| or a = 0.
    #[inline]
    fn fast_sum(a: f64, b: f64) -> Self {
        finite_low(exact::fast_two_sum(a, b))
    }

    /// `a b` without rounding.
    #[inline]
    pub(super) fn product(a: f64, b: f64) -> Self {
        finite_low(exact::two_product(a, b))
    }
}

/// An infinite sum has no error, where infinity minus infinity has no value.
#[inline]
fn finite_low((high, low): (f64, f64)) -> DoubleDouble {
    let low = if high.is_finite() { low } else { 0.0 };
    DoubleDouble { high, low }
}

impl_operators! {
    impl [] for DoubleDouble;
    Neg neg |a| DoubleDouble { high: -a.high, low: -a.low };
    Sub sub |a, b| a + -b;
}

impl Add for DoubleDouble {
    type Output = Self;

    /// AccurateDWPlusDW.
    fn add(self, other: Self) -> Self {
        let s = DoubleDouble::sum(self.high, other.high);
        let t = DoubleDouble::sum(self.low, other.low);
        let v = DoubleDouble::fast_sum(s.high, s.low + t.high);
        DoubleDouble::fast_sum(v.high, t.low + v.low)
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    /// DWTimesDW1.
    fn mul(self, other: Self) -> Self {
        let product = DoubleDouble::product(self.high, other.high);
        if !product.high.is_finite() {
            return product;
        }
        let cross = self.high * other.low + self.low * other.high;
        DoubleDouble::fast_sum(product.high, product.low + cross)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// The quotient of the leading parts, and what it leaves, divided again (after DWDivDW2).
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        if !first.is_finite() || other.high.is_infinite() {
            return DoubleDouble::from(first);
        }
        let rest = self - other * DoubleDouble::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * DoubleDouble::from(second);
        DoubleDouble::fast_sum(first, second) + DoubleDouble::from(rest.high / other.high)
    }
}

impl DoubleDouble {
    /// The quotient by a double (DWDivFP3).
    #[inline]
    pub(super) fn over(self, divisor: f64) -> Self {
        let quotient = self.high / divisor;
        let product = DoubleDouble::product(quotient, divisor);
        let rest = ((self.high - product.high) - product.low) + self.low;
        DoubleDouble::fast_sum(quotient, rest / divisor)
    }
}

/// The square root (SQRTDWtoDW: V. Lefevre, N. Louvet, J.-M. Muller, J. Picot, L. Rideau, *Accurate
/// calculation of Euclidean norms using double-word arithmetic*, ACM Trans. Math. Software 49, 2023).
#[inline]
pub(super) fn sqrt(x: DoubleDouble) -> DoubleDouble {
    let root = x.high.root();
    if root == 0.0 || !root.is_finite() {
        return DoubleDouble::from(root);
    }
    let square = DoubleDouble::product(root, root);
    let rest = ((x.high - square.high) - square.low) + x.low;
    DoubleDouble::fast_sum(root, rest / (2.0 * root))
}

impl_assign! { impl [] for DoubleDouble; |x| DoubleDouble::from(x) }
