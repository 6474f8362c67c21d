//! The numbers that generated code runs on.

mod exponential;

use core::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::dispatch;

use crate::float::Float;
use crate::sine::{Part, Sines, level};

/// A real number type on which every generated function can be evaluated.
///
/// The trait requires what straight-line code of equations of motion needs and nothing more,
/// so that it can be implemented for numbers which are no complete field: dual numbers, SIMD lanes,
/// numbers of extended precision. It is implemented for `f32`, `f64`, [`DoubleDouble`](crate::DoubleDouble) and
/// [`Certified`](crate::Certified).
///
/// No method panics. Values that are not finite propagate as IEEE 754 arithmetic has it.
///
/// ```
/// use robot_dynamics::Scalar;
///
/// fn height<T: Scalar>(length: T, angle: T) -> T {
///     let (_, cosine) = angle.sin_cos();
///     length * (T::from_f64(1.0) - cosine)
/// }
/// assert_eq!(height(2.0_f64, 0.0), 0.0);
/// assert_eq!(height(2.0_f32, 0.0), 0.0);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no number that functions of a robot take",
    note = "numbers are `f64`, for example: an integer is written with a point, `1.0` in place of `1`"
)]
pub trait Scalar:
    nalgebra::Scalar
    + Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number nearest to `x`.
    fn from_f64(x: f64) -> Self;

    /// The number nearest to `x`, in the arithmetic of `self`, whose value does not matter: a constant of a generated
    /// function.
    ///
    /// It equals [`from_f64`](Scalar::from_f64), except for types whose values carry an arithmetic that is chosen at run
    /// time: the lanes of an instruction set, or a precision.
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        Self::from_f64(x)
    }

    /// `x` in the arithmetic of `self`, where the double `x` is exactly the number that was meant: a field of the
    /// struct, as opposed to a constant, which was rounded to a double.
    ///
    /// It equals [`constant`](Scalar::constant), except for types that carry their errors.
    #[inline(always)]
    fn exact(self, x: f64) -> Self {
        self.constant(x)
    }

    /// `self`, a constant of a generated function, or the `f32` nearest to it in single precision.
    ///
    /// A constant so close to the middle of two neighbouring `f32` that its double would be rounded to the wrong one is
    /// written with both.
    #[doc(hidden)]
    #[inline(always)]
    fn rounded_once(self, single: f32) -> Self {
        let _ = single;
        self
    }

    /// The distance from 1 to the next larger number.
    fn epsilon() -> Self;

    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);

    /// Sine and cosine of several angles in radians, which generated functions request at once.
    ///
    /// `f64` and `f32` evaluate them in the lanes of a vector register, each in its own precision, with an error
    /// below one unit in the last place.
    #[inline]
    fn sin_cos_array<const K: usize>(angles: [Self; K]) -> [(Self, Self); K] {
        angles.map(Self::sin_cos)
    }

    /// Sine and cosine of several angles, of which only the given parts are read: the others may be any numbers.
    /// Generated functions request the parts that they need. The digits are those of
    /// [`sin_cos_array`](Scalar::sin_cos_array), except for lanes of an instruction set that is chosen at run time.
    #[doc(hidden)]
    #[inline(always)]
    fn sin_cos_parts<const K: usize>(angles: [Self; K], parts: [Part; K]) -> [(Self, Self); K] {
        let _ = parts;
        Self::sin_cos_array(angles)
    }

    /// The square root; NaN of a negative number.
    fn sqrt(self) -> Self;

    /// The exponential function, which friction that falls with the velocity (Stribeck's) needs.
    ///
    /// `f64` and `f32` have an error below one unit in the last place. This implementation, for types that have none
    /// of their own, takes the argument apart by [`ratio_to_f64`](Scalar::ratio_to_f64), and is about ten
    /// roundings off, in any precision up to 40 digits. A type of several lanes needs its own.
    #[inline]
    fn exp(self) -> Self {
        exponential::by_reduction(self)
    }

    /// `self * a + b`: rounded once where the target has a fused instruction for it, else a product and a sum.
    ///
    /// The compiler may emit the instruction on `aarch64`, and on x86 where the target feature `fma` is switched on; never
    /// without the feature `std`. In software it would be many times slower than the two operations.
    fn mul_add(self, a: Self, b: Self) -> Self;

    /// The sign as a number: -1, 0 or 1. Zero of either sign gives 0, NaN gives NaN.
    fn sign(self) -> Self;

    /// Whether the number is greater than zero; false for NaN. A type of several lanes answers
    /// for all of them.
    fn is_positive(self) -> bool;

    /// Whether the number, a difference of numbers as large as `size`, is positive beyond the rounding errors of
    /// these: greater than 8 epsilon times `size`. False for NaN. A type of several lanes answers for all of them.
    #[inline(always)]
    fn exceeds_rounding_of(self, size: Self) -> bool {
        let rounding = size * Self::epsilon() * size.constant(8.0);
        (self - rounding).is_positive() && (self + rounding).is_positive()
    }

    /// `self / of` in double precision, for error reports. A type of several lanes answers with
    /// the least ratio of its lanes.
    fn ratio_to_f64(self, of: Self) -> f64;

    /// Runs `work`, which loops over arrays of these numbers, compiled for the widest vector registers that the
    /// processor has.
    #[doc(hidden)]
    #[inline(always)]
    fn vectorized<R>(work: impl FnOnce() -> R) -> R {
        work()
    }
}

macro_rules! impl_scalar {
    ($float:ident, $exp:path, $($own:item)*) => {
        #[diagnostic::do_not_recommend]
        impl Scalar for $float {
            $(#[inline] $own)*

            #[inline]
            fn from_f64(x: f64) -> Self {
                x as $float
            }

            #[inline]
            fn epsilon() -> Self {
                $float::EPSILON
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                let [value] = Sines::of_array([self]);
                value
            }

            // Always: left to the compiler, a crate with many functions would hand angles over in memory.
            #[inline(always)]
            fn sin_cos_array<const K: usize>(angles: [Self; K]) -> [(Self, Self); K] {
                Sines::of_array(angles)
            }

            #[inline(always)]
            fn sin_cos_parts<const K: usize>(
                angles: [Self; K],
                parts: [Part; K],
            ) -> [(Self, Self); K] {
                Sines::parts_of_array(angles, parts)
            }

            #[inline]
            fn sqrt(self) -> Self {
                self.root()
            }

            #[inline]
            fn exp(self) -> Self {
                // The same digits on every platform.
                $exp(self)
            }

            #[inline]
            fn mul_add(self, a: Self, b: Self) -> Self {
                self.times_plus(a, b)
            }

            #[inline]
            fn sign(self) -> Self {
                // Selections and no branches: nobody can predict which way a joint turns.
                let unit = <$float>::copysign(1.0, self);
                let sign = if self == 0.0 { 0.0 } else { unit };
                if self.is_nan() { self } else { sign }
            }

            #[inline]
            fn is_positive(self) -> bool {
                self > 0.0
            }

            #[inline]
            fn ratio_to_f64(self, of: Self) -> f64 {
                f64::from(self) / f64::from(of)
            }
        }
    };
}

impl_scalar! {
    f32, libm::expf,
    fn rounded_once(self, single: f32) -> Self {
        single
    }
}

impl_scalar! {
    f64, libm::exp,
    fn vectorized<R>(work: impl FnOnce() -> R) -> R {
        dispatch!(level(), simd => {
            let _ = simd;
            work()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Scalar;

    fn signs<T: Scalar>() -> [T; 4] {
        [2.5, -2.5, 0.0, -0.0].map(|x| T::from_f64(x).sign())
    }

    #[test]
    fn sign_is_zero_at_either_zero() {
        assert_eq!(signs::<f64>(), [1.0, -1.0, 0.0, 0.0]);
        assert_eq!(signs::<f32>(), [1.0, -1.0, 0.0, 0.0]);
        assert!(signs::<f64>()[3].is_sign_positive());
    }

    #[test]
    fn nan_is_neither_signed_nor_positive() {
        assert!(Scalar::sign(f64::NAN).is_nan());
        assert!(!Scalar::is_positive(f64::NAN));
        assert!(!Scalar::is_positive(0.0_f64));
        assert!(Scalar::is_positive(f64::MIN_POSITIVE));
    }

    #[test]
    fn multiply_add_is_fused_exactly_where_the_target_is() {
        // (1 + e)(1 - e) - 1 = -e^2 survives one rounding, and is lost in two.
        let e = f64::EPSILON;
        let expected = if crate::float::FUSED { -e * e } else { 0.0 };
        assert_eq!(Scalar::mul_add(1.0 + e, 1.0 - e, -1.0), expected);
    }

    #[test]
    fn ratio_is_taken_in_double_precision() {
        assert_eq!(Scalar::ratio_to_f64(1.0_f32, 3.0_f32), 1.0 / 3.0);
    }
}
