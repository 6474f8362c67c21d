//! Numbers of 31 digits: a scalar of the tests' own, for differences over tiny distances.
//!
//! T. J. Dekker, "A floating-point technique for extending the available precision", 1971.

use std::f64::consts::FRAC_PI_2;
use std::ops::{Add, Div, Mul, Neg, Sub};

use robot_dynamics::Scalar;
use robot_dynamics::nalgebra::SVector;

/// An unevaluated sum of two doubles, the second at most half a unit in the last place of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DoubleDouble {
    high: f64,
    low: f64,
}

/// The numbers of a vector, exactly.
pub(crate) fn exact<const N: usize>(x: &SVector<f64, N>) -> SVector<DoubleDouble, N> {
    x.map(DoubleDouble::from_f64)
}

/// a + b without rounding (Knuth).
fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let high = a + b;
    let part = high - a;
    let low = (a - (high - part)) + (b - part);
    DoubleDouble { high, low }
}

/// a b without rounding.
fn two_product(a: f64, b: f64) -> DoubleDouble {
    let high = a * b;
    let low = f64::mul_add(a, b, -high);
    DoubleDouble { high, low }
}

impl DoubleDouble {
    /// The nearest double.
    pub(crate) fn value(self) -> f64 {
        self.high
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (two_sum(self.high, other.high), two_sum(self.low, other.low));
        let sum = two_sum(high.high, high.low + low.high);
        two_sum(sum.high, sum.low + low.low)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        DoubleDouble {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = two_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        two_sum(product.high, product.low + cross)
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = DoubleDouble::from_f64(self.high / other.high);
        let rest = self - first * other;
        let second = DoubleDouble::from_f64(rest.high / other.high);
        let rest = rest - second * other;
        first + second + DoubleDouble::from_f64(rest.high / other.high)
    }
}

/// pi/2 in three doubles.
const HALF_PI: [f64; 3] = [
    FRAC_PI_2,
    6.123_233_995_736_766e-17,
    -1.497_384_904_859_169_8e-33,
];

/// A Taylor series in x^2 from the term `first` = x^start / start! on.
fn series(first: DoubleDouble, square: DoubleDouble, start: f64) -> DoubleDouble {
    let (mut sum, mut term) = (first, first);
    for k in 0..16 {
        let k = start + 2.0 * f64::from(k);
        term = term * square / DoubleDouble::from_f64(-(k + 1.0) * (k + 2.0));
        sum = sum + term;
    }
    sum
}

impl Scalar for DoubleDouble {
    fn from_f64(x: f64) -> Self {
        DoubleDouble { high: x, low: 0.0 }
    }

    fn epsilon() -> Self {
        DoubleDouble::from_f64(f64::EPSILON * f64::EPSILON)
    }

    /// For angles of a few turns.
    fn sin_cos(self) -> (Self, Self) {
        let n = (self.high / FRAC_PI_2).round();
        let turns = HALF_PI.map(|part| two_product(-n, part));
        let rest = turns.into_iter().fold(self, |rest, part| rest + part);
        let square = rest * rest;
        let sine = series(rest, square, 1.0);
        let cosine = series(DoubleDouble::from_f64(1.0), square, 0.0);
        match n.rem_euclid(4.0) {
            0.0 => (sine, cosine),
            1.0 => (cosine, -sine),
            2.0 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    }

    fn sqrt(self) -> Self {
        let root = DoubleDouble::from_f64(self.high.sqrt());
        root + (self - root * root) / (root + root)
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    fn sign(self) -> Self {
        DoubleDouble::from_f64(Scalar::sign(self.high))
    }

    fn is_positive(self) -> bool {
        self.high > 0.0
    }

    fn ratio_to_f64(self, of: Self) -> f64 {
        (self / of).high
    }
}

/// The identities that tie the operations to one another hold to 30 digits.
#[test]
fn double_doubles_have_thirty_digits() {
    for x in [0.3, 1.0, 2.5, -4.0, 6.1].map(DoubleDouble::from_f64) {
        let (s, c) = x.sin_cos();
        let (s2, c2) = (x + x).sin_cos();
        for error in [
            s * s + c * c - DoubleDouble::from_f64(1.0),
            (s * c + s * c) - s2,
            (c * c - s * s) - c2,
            s / c * c - s,
            x * x - (x * x).sqrt() * (x * x).sqrt(),
        ] {
            assert!(error.value().abs() < 1e-29, "{error:?} at {x:?}");
        }
    }
}
