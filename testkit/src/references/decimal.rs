//! Decimals of more digits than a double holds, and the exact error of a double against them.

use std::ops::Add;

use robot_dynamics::DoubleDouble;
use serde::Deserialize;

/// A reference value: the double nearest to it, and what that double leaves.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(try_from = "String")]
pub struct Decimal {
    nearest: f64,
    rest: f64,
}

impl Decimal {
    /// The double nearest to the value.
    pub fn nearest(self) -> f64 {
        self.nearest
    }

    /// The value, to 31 digits.
    pub fn value(self) -> DoubleDouble {
        DoubleDouble::sum(self.nearest, self.rest)
    }

    /// Whether the value is zero.
    pub fn is_zero(self) -> bool {
        self.nearest == 0.0
    }

    /// `x` minus the value. The first difference is exact where `x` is near, so that the
    /// result holds the error of `x` and not the rounding of the reference.
    pub fn error_of(self, x: f64) -> f64 {
        (x - self.nearest) - self.rest
    }
}

impl Add for Decimal {
    type Output = Self;

    /// The sum, with the rounding of the leading parts kept (Knuth's two-sum).
    fn add(self, other: Self) -> Self {
        let nearest = self.nearest + other.nearest;
        let part = nearest - self.nearest;
        let lost = (self.nearest - (nearest - part)) + (other.nearest - part);
        Decimal {
            nearest,
            rest: self.rest + other.rest + lost,
        }
    }
}

impl TryFrom<String> for Decimal {
    type Error = std::num::ParseFloatError;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        let nearest: f64 = text.parse()?;
        let rest = difference(&text, &format!("{nearest:.34e}"))?;
        Ok(Decimal { nearest, rest })
    }
}

/// The difference of two decimals of at most 36 digits that agree in most of them.
fn difference(a: &str, b: &str) -> Result<f64, std::num::ParseFloatError> {
    let ((a, a_exponent), (b, b_exponent)) = (integer(a), integer(b));
    let exponent = a_exponent.min(b_exponent);
    let scaled = |digits: i128, from: i32| digits * 10_i128.pow((from - exponent) as u32);
    let difference = scaled(a, a_exponent) - scaled(b, b_exponent);
    format!("{difference}e{exponent}").parse()
}

/// The digits of a decimal as an integer, and the power of ten that it is to be multiplied by.
fn integer(text: &str) -> (i128, i32) {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: i128 = format!("{whole}{fraction}").parse().expect("digits");
    let exponent: i32 = exponent.parse().expect("an exponent");
    if digits == 0 {
        (0, 0)
    } else {
        (digits, exponent - fraction.len() as i32)
    }
}
