//! The numbers that closed forms run on.

use crate::Scalar;

/// `f64` and `f32`, which have an arc tangent and can be compared.
pub trait Real: Scalar + PartialOrd + sealed::Sealed {
    /// Angles, rad, that are closer than this cannot be told apart: 1e-7, in single precision 1e-3.
    const APART: Self;
    /// A pose counts as reached that is missed by this part of the distances in it: 1e-9, in single precision 1e-4.
    const REACHED: Self;

    /// The angle from -pi to pi of the point with these coordinates: that of `self`, the sine, and the cosine.
    fn atan2(self, cosine: Self) -> Self;

    /// Whether the number is finite.
    fn is_finite(self) -> bool;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

macro_rules! impl_real {
    ($float:ident, $atan2:ident, $apart:literal, $reached:literal) => {
        impl Real for $float {
            const APART: Self = $apart;
            const REACHED: Self = $reached;

            #[inline]
            fn atan2(self, cosine: Self) -> Self {
                #[cfg(feature = "std")]
                return <$float>::atan2(self, cosine);
                #[cfg(not(feature = "std"))]
                libm::$atan2(self, cosine)
            }

            #[inline]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }
        }
    };
}

impl_real!(f64, atan2, 1e-7, 1e-9);
impl_real!(f32, atan2f, 1e-3, 1e-4);
