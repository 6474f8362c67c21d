//! Dual numbers: a scalar of the tests' own, which carries an exact directional derivative
//! through a generated program.

use std::ops::{Add, Div, Mul, Neg, Sub};

use robot_dynamics::Scalar;
use robot_dynamics::nalgebra::SVector;

/// `value + derivative * eps` with `eps^2 = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// Its derivative along a direction.
    pub derivative: f64,
}

/// The point `x`, moving at `direction`.
pub fn along<const N: usize>(x: &SVector<f64, N>, direction: &SVector<f64, N>) -> SVector<Dual, N> {
    SVector::from_fn(|i, _| Dual {
        value: x[i],
        derivative: direction[i],
    })
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Dual {
            value: self.value + other.value,
            derivative: self.derivative + other.derivative,
        }
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Dual {
            value: -self.value,
            derivative: -self.derivative,
        }
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Dual {
            value: self.value * other.value,
            derivative: self.derivative * other.value + self.value * other.derivative,
        }
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        Dual {
            value: quotient,
            derivative: (self.derivative - quotient * other.derivative) / other.value,
        }
    }
}

impl Scalar for Dual {
    fn from_f64(x: f64) -> Self {
        Dual {
            value: x,
            derivative: 0.0,
        }
    }

    fn epsilon() -> Self {
        Dual::from_f64(f64::EPSILON)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (
            Dual {
                value: sin,
                derivative: cos * self.derivative,
            },
            Dual {
                value: cos,
                derivative: -sin * self.derivative,
            },
        )
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Dual {
            value: root,
            derivative: self.derivative / (2.0 * root),
        }
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    fn sign(self) -> Self {
        Dual::from_f64(Scalar::sign(self.value))
    }

    fn is_positive(self) -> bool {
        self.value > 0.0
    }

    fn ratio_to_f64(self, of: Self) -> f64 {
        self.value / of.value
    }
}
