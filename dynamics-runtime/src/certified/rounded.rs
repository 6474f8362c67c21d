//! The floats whose errors are bounded.

use crate::Scalar;

/// A precision that [`Certified`](super::Certified) numbers have: `f64` or `f32`.
///
/// All that the bounds rest on stands here: where the neighbours of a number are, and what a sum leaves
/// out.
pub trait Rounded: Scalar + PartialOrd {
    /// 0.
    const ZERO: Self;

    /// Infinity.
    const INFINITY: Self;

    /// The absolute value.
    fn magnitude(self) -> Self;

    /// The next larger number.
    fn above(self) -> Self;

    /// The next smaller number.
    fn below(self) -> Self;

    /// What the rounding of a sum to `sum` left out, exactly, where nothing overflowed (2Sum: Knuth, *The Art of
    /// Computer Programming* 2, theorem 4.2.2 B).
    fn left_out(a: Self, b: Self, sum: Self) -> Self;

    /// The same number in double precision.
    fn to_f64(self) -> f64;

    /// A double rounded up.
    fn at_least(x: f64) -> Self;
}

macro_rules! impl_rounded {
    ($($float:ident),*) => {$(
        impl Rounded for $float {
            const ZERO: Self = 0.0;
            const INFINITY: Self = $float::INFINITY;

            #[inline]
            fn magnitude(self) -> Self {
                self.abs()
            }

            #[inline]
            fn above(self) -> Self {
                self.next_up()
            }

            #[inline]
            fn below(self) -> Self {
                self.next_down()
            }

            #[inline]
            fn left_out(a: Self, b: Self, sum: Self) -> Self {
                let part = sum - a;
                (a - (sum - part)) + (b - part)
            }

            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            #[inline]
            fn at_least(x: f64) -> Self {
                let nearest = x as $float;
                if f64::from(nearest) < x { nearest.next_up() } else { nearest }
            }
        }
    )*};
}

impl_rounded!(f32, f64);
