//! The operations of double-double arithmetic.
//!
//! M. Joldes, J.-M. Muller, V. Popescu, *Tight and rigorous error bounds for basic building blocks
//! of double-word arithmetic*, ACM Trans. Math. Software 44 (2017), article 15, whose algorithms
//! the names in brackets are.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use super::DoubleDouble;
use crate::float::Float as _;
use crate::scalar::FUSED;

/// a + b without rounding (2Sum; Knuth). What is not finite keeps its value.
#[inline]
pub(super) fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let high = a + b;
    let part = high - a;
    let low = (a - (high - part)) + (b - part);
    finite_low(high, low)
}

/// a + b without rounding where |a| >= |b| or a = 0 (Fast2Sum; Dekker).
#[inline]
fn fast_two_sum(a: f64, b: f64) -> DoubleDouble {
    let high = a + b;
    finite_low(high, b - (high - a))
}

/// a b without rounding (2Prod): by a fused operation where the target has it, else by the halves
/// of the factors, which is several times faster than a fused operation in software.
#[inline]
pub(super) fn two_product(a: f64, b: f64) -> DoubleDouble {
    let high = a * b;
    let low = if FUSED {
        a.fused(b, -high)
    } else {
        by_halves(a, b, high)
    };
    finite_low(high, low)
}

/// a b - high, where `high` is the rounded product (Dekker 1971).
#[inline]
fn by_halves(a: f64, b: f64, high: f64) -> f64 {
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    let low = ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2;
    // The halves of numbers beyond 2^996 overflow.
    if low.is_nan() { a.fused(b, -high) } else { low }
}

/// A number as the sum of two that have 26 bits each (Veltkamp 1968).
#[inline]
fn halves(x: f64) -> (f64, f64) {
    // 2^27 + 1
    let scaled = 134_217_729.0 * x;
    let upper = scaled - (scaled - x);
    (upper, x - upper)
}

/// An infinite sum has no error, where infinity minus infinity has no value.
#[inline]
fn finite_low(high: f64, low: f64) -> DoubleDouble {
    let low = if high.is_finite() { low } else { 0.0 };
    DoubleDouble { high, low }
}

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        DoubleDouble {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    /// AccurateDWPlusDW.
    #[inline]
    fn add(self, other: Self) -> Self {
        let s = two_sum(self.high, other.high);
        let t = two_sum(self.low, other.low);
        let v = fast_two_sum(s.high, s.low + t.high);
        fast_two_sum(v.high, t.low + v.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    /// DWTimesDW1.
    #[inline]
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.high, other.high);
        if !product.high.is_finite() {
            return product;
        }
        let cross = self.high * other.low + self.low * other.high;
        fast_two_sum(product.high, product.low + cross)
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    /// The quotient of the leading parts, and what it leaves, divided again (after DWDivDW2).
    #[inline]
    fn div(self, other: Self) -> Self {
        let first = self.high / other.high;
        if !first.is_finite() || other.high.is_infinite() {
            return DoubleDouble::from(first);
        }
        let rest = self - other * DoubleDouble::from(first);
        let second = rest.high / other.high;
        let rest = rest - other * DoubleDouble::from(second);
        fast_two_sum(first, second) + DoubleDouble::from(rest.high / other.high)
    }
}

impl DoubleDouble {
    /// The quotient by a double (DWDivFP3).
    #[inline]
    pub(super) fn over(self, divisor: f64) -> Self {
        let quotient = self.high / divisor;
        let product = two_product(quotient, divisor);
        let rest = ((self.high - product.high) - product.low) + self.low;
        fast_two_sum(quotient, rest / divisor)
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
    let square = two_product(root, root);
    let rest = ((x.high - square.high) - square.low) + x.low;
    fast_two_sum(root, rest / (2.0 * root))
}

macro_rules! impl_assign {
    ($($assign:ident, $method:ident: $operator:tt;)*) => {$(
        impl $assign for DoubleDouble {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}

impl_assign! {
    AddAssign, add_assign: +;
    SubAssign, sub_assign: -;
    MulAssign, mul_assign: *;
    DivAssign, div_assign: /;
}

impl Zero for DoubleDouble {
    #[inline]
    fn zero() -> Self {
        DoubleDouble::from(0.0)
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.high == 0.0
    }
}

impl One for DoubleDouble {
    #[inline]
    fn one() -> Self {
        DoubleDouble::from(1.0)
    }
}
