//! Numbers of 31 digits.
//!
//! Errors over 40,000 random numbers against 120 digits: 5.0e-32 in products, 3.1e-32 in sums, quotients and roots.
//! Constants of a program stay the doubles that stand in its text: its value in `DoubleDouble` is the exact value of
//! the same function.

#[cfg(feature = "std")]
mod decimal;
mod operations;
mod trigonometry;

#[cfg(test)]
mod tests;

use crate::Scalar;
use crate::operators::scalar_methods;

/// A number of about 31 digits: the unevaluated sum of two doubles (Dekker 1971).
///
/// Generated functions run on it as they do on `f64`, and take 60 to 80 times as long. It tells the error of a result in
/// `f64`, and carries differences and long integrations that `f64` has too few digits for.
///
/// The constants of a generated function are the doubles in its text, each the exact value rounded once: a value in
/// `DoubleDouble` is the exact value of *that* function. Cells that are fields are the doubles that the fields hold.
///
/// Relative errors, with u = 2^-53: sums and differences below 3 u^2, products 5 u^2, quotients 10 u^2, roots 4 u^2
/// (u^2 = 1.2e-32; Joldes, Muller and Popescu 2017; Lefevre, Louvet, Muller, Picot and Rideau 2023). Sines and cosines
/// are within 1e-31 up to angles of 7e15 rad, and NaN beyond; exponentials within 5e-31. The range is that of `f64`, but
/// products below 1e-291 lose digits of their second half.
///
/// ```
/// use robot_dynamics::{DoubleDouble, Scalar};
///
/// let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
/// assert_eq!(third.high(), 1.0 / 3.0);
/// assert_eq!(third.low(), 1.850371707708594e-17);
///
/// let (s, c) = third.sin_cos();
/// let one = s * s + c * c;
/// assert!((one - DoubleDouble::from(1.0)).high().abs() < 1e-31);
/// assert_eq!(format!("{third:.29}"), "3.33333333333333333333333333333e-1");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    high: f64,
    /// At most half a unit in the last place of `high`; zero where that is not finite.
    low: f64,
}

impl DoubleDouble {
    pub(crate) const ZERO: Self = DoubleDouble {
        high: 0.0,
        low: 0.0,
    };

    /// The nearest double.
    #[inline]
    pub const fn high(self) -> f64 {
        self.high
    }

    /// The rest beside the nearest double.
    #[inline]
    pub const fn low(self) -> f64 {
        self.low
    }

    /// The nearest double.
    #[inline]
    pub fn to_f64(self) -> f64 {
        self.high
    }

    /// The absolute value.
    #[inline]
    pub fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(x: f64) -> Self {
        DoubleDouble { high: x, low: 0.0 }
    }
}

#[diagnostic::do_not_recommend]
impl Scalar for DoubleDouble {
    scalar_methods! {
        from_f64(x) => DoubleDouble::from(x);
        // 2^-104
        epsilon() => DoubleDouble::from(f64::EPSILON * f64::EPSILON);
        sqrt(x) => operations::sqrt(x);
        sign(x) => DoubleDouble::from(Scalar::sign(x.high));
        is_positive(x) => x.high > 0.0;
        ratio_to_f64(x, of) => (x / of).high;
    }

    /// For angles up to 7e15 rad; NaN beyond.
    fn sin_cos(self) -> (Self, Self) {
        trigonometry::sin_cos(self)
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }
}
