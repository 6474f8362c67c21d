//! The numbers whose errors are bounded: all that the bounds rest on stands here.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Sub};

use crate::float::FUSED;
use crate::{DoubleDouble, Scalar};

/// A float that bounds are kept in.
#[doc(hidden)]
pub trait Magnitude:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + 'static
{
    const ZERO: Self;
    const HALF: Self;
    const ONE: Self;
    const INFINITY: Self;

    /// The next larger number.
    fn above(self) -> Self;

    /// The next smaller number.
    fn below(self) -> Self;

    /// The square root, rounded to nearest.
    fn root(self) -> Self;

    /// The same number in double precision.
    fn double(self) -> f64;

    /// A double rounded up.
    fn at_least(x: f64) -> Self;
}

/// A precision that [`Certified`](super::Certified) numbers have: `f64`, `f32`, or [`DoubleDouble`].
pub trait Rounded: Scalar + PartialOrd {
    /// The numbers of bounds: the float itself, a double beside 31 digits.
    type Magnitude: Magnitude;

    /// The precision in which residuals are evaluated: double of single, 31 digits of double.
    type Wide: Rounded;

    /// Whether `mul_add` is rounded once.
    #[doc(hidden)]
    const FUSED: bool;

    #[doc(hidden)]
    const ZERO: Self;

    /// The absolute value, or a little more; not finite where the number is not.
    #[doc(hidden)]
    fn magnitude(self) -> Self::Magnitude;

    /// The absolute value, or a little less.
    #[doc(hidden)]
    fn least_magnitude(self) -> Self::Magnitude;

    /// The greatest distance of a product, a quotient or a root from this number, to which it was rounded.
    #[doc(hidden)]
    fn rounding(self) -> Self::Magnitude;

    /// The greatest rounding of a sum.
    #[doc(hidden)]
    fn left_out(a: Self, b: Self, sum: Self) -> Self::Magnitude;

    /// The greatest distance of an exponential from this number, which was computed.
    #[doc(hidden)]
    fn kernel_error(self) -> Self::Magnitude;

    /// The greatest distance of the sine or cosine of this angle from the computed number.
    #[doc(hidden)]
    fn sine_error(self, sine: Self) -> Self::Magnitude;

    /// The nearest double.
    #[doc(hidden)]
    fn to_f64(self) -> f64;
}

macro_rules! impl_rounded {
    ($($float:ident: $wide:ident),*) => {$(
        impl Magnitude for $float {
            const ZERO: Self = 0.0;
            const HALF: Self = 0.5;
            const ONE: Self = 1.0;
            const INFINITY: Self = $float::INFINITY;

            #[inline]
            fn above(self) -> Self {
                self.next_up()
            }

            #[inline]
            fn below(self) -> Self {
                self.next_down()
            }

            #[inline]
            fn root(self) -> Self {
                Scalar::sqrt(self)
            }

            #[inline]
            fn double(self) -> f64 {
                f64::from(self)
            }

            #[inline]
            fn at_least(x: f64) -> Self {
                let nearest = x as $float;
                if f64::from(nearest) < x { nearest.next_up() } else { nearest }
            }
        }

        impl Rounded for $float {
            type Magnitude = Self;
            type Wide = $wide;

            const FUSED: bool = FUSED;
            const ZERO: Self = 0.0;

            #[inline]
            fn magnitude(self) -> Self {
                self.abs()
            }

            #[inline]
            fn least_magnitude(self) -> Self {
                self.abs()
            }

            /// Half a unit in the last place: no number is further from the result that it was rounded to, and
            /// none from the least number that was rounded to zero.
            #[inline]
            fn rounding(self) -> Self {
                let unit = unit(self);
                let half = unit * 0.5;
                // Half the least number is zero.
                if half > 0.0 { half } else { unit }
            }

            /// Exactly, where nothing overflowed (2Sum: Knuth, *The Art of Computer Programming* 2, theorem
            /// 4.2.2 B).
            #[inline]
            fn left_out(a: Self, b: Self, sum: Self) -> Self {
                let part = sum - a;
                ((a - (sum - part)) + (b - part)).abs()
            }

            /// One unit in the last place of a number that is less than two units away.
            #[inline]
            fn kernel_error(self) -> Self {
                unit(self.abs().next_up().next_up())
            }

            #[inline]
            fn sine_error(self, sine: Self) -> Self {
                sine.kernel_error()
            }

            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }
    )*};
}

impl_rounded!(f32: f64, f64: DoubleDouble);

/// From |x| to the next larger number; exact.
fn unit<F: Rounded<Magnitude = F> + Magnitude>(x: F) -> F {
    let size = x.magnitude();
    size.above() - size
}

/// 2^-100. Sums are within 3 u^2, products and roots within 7 u^2 and quotients within 10 u^2, with u^2 = 2^-106
/// (see [`DoubleDouble`]).
const ROUNDING: f64 = f64::EPSILON * f64::EPSILON * 16.0;

/// 2^-96. A series of about thirty operations on numbers of at most 1, each within [`ROUNDING`], and the
/// reduction of the angle before, which adds about ten of at most 2.
const SERIES: f64 = ROUNDING * 16.0;

/// 2^40, rad. Beyond it the number of quarter turns may be one off, and nothing is said.
const LARGEST_ANGLE: f64 = 1_099_511_627_776.0;

/// 2^-1000: products below it lose digits of their second half by underflow.
const UNDERFLOW: f64 = 9.332_636_185_032_189e-302;

impl Rounded for DoubleDouble {
    type Magnitude = f64;
    type Wide = Self;

    const FUSED: bool = false;
    const ZERO: Self = DoubleDouble::ZERO;

    fn magnitude(self) -> f64 {
        let [high, low] = [self.high(), self.low()].map(f64::abs);
        if high == 0.0 {
            0.0
        } else {
            (high + low).next_up()
        }
    }

    fn least_magnitude(self) -> f64 {
        let [high, low] = [self.high(), self.low()].map(f64::abs);
        (high - low).next_down().max(0.0)
    }

    fn rounding(self) -> f64 {
        self.magnitude() * ROUNDING + UNDERFLOW
    }

    /// No sum underflows.
    fn left_out(_: Self, _: Self, sum: Self) -> f64 {
        sum.magnitude() * ROUNDING
    }

    fn kernel_error(self) -> f64 {
        (self.magnitude() + UNDERFLOW) * SERIES
    }

    fn sine_error(self, _: Self) -> f64 {
        let is_reduced = self.magnitude() < LARGEST_ANGLE;
        if is_reduced { SERIES } else { f64::INFINITY }
    }

    fn to_f64(self) -> f64 {
        self.high()
    }
}
