//! The numbers that closed forms run on.

use super::angle;
use crate::Scalar;

/// `f64` and `f32`, which can be compared, and whose angles are known from sines and cosines.
pub trait Real: Scalar + PartialOrd + sealed::Sealed {
    /// Angles, rad, that are closer than this cannot be told apart: 1e-7, in single precision 1e-3.
    const APART: Self;
    /// A pose counts as reached that is missed by this part of the distances in it: 1e-9, in single precision 1e-4.
    const REACHED: Self;
    /// The columns of a rotation are unit vectors at right angles to this: 1e-6, in single precision 1e-3.
    const ROTATION: Self;

    /// Replaces cosines by the angles from -pi to pi that they and the sines belong to.
    #[doc(hidden)]
    fn angles(sines: &[Self], cosines: &mut [Self]);

    /// Whether the number is finite.
    fn is_finite(self) -> bool;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

macro_rules! impl_real {
    ($float:ident, $angles:path, $apart:literal, $reached:literal, $rotation:literal) => {
        impl Real for $float {
            const APART: Self = $apart;
            const REACHED: Self = $reached;
            const ROTATION: Self = $rotation;

            fn angles(sines: &[Self], cosines: &mut [Self]) {
                $angles(sines, cosines);
            }

            #[inline]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }
        }
    };
}

impl_real!(f64, angle::angles, 1e-7, 1e-9, 1e-6);
impl_real!(f32, angle::angles_f32, 1e-3, 1e-4, 1e-3);
