//! The numbers that closed forms run on.

use super::arc_tangent::{arc_tangent, single_arc_tangent};
use crate::Scalar;

/// `f64` and `f32`, which can be compared and have no digits that a double has not.
pub trait Real: Scalar + PartialOrd + Into<f64> + sealed::Sealed {
    /// Angles, rad, that are closer than this cannot be told apart: 1e-7, in single precision 1e-3.
    const APART: Self;
    /// A pose counts as reached that is missed by this part of the distances in it: 1e-9, in single precision 1e-4.
    const REACHED: Self;
    /// The columns of a rotation are unit vectors at right angles to this: 1e-6, in single precision 1e-3.
    const ROTATION: Self;

    /// -P(z^2) of the arc tangent z + z^3 P(z^2) of a z whose square this is.
    #[doc(hidden)]
    fn arc_tangent(self) -> Self;

    /// The integer that is nearest, of two the even one.
    #[doc(hidden)]
    fn rint(self) -> Self;

    /// Whether the number is finite.
    #[inline]
    fn is_finite(self) -> bool {
        let zero = Self::from_f64(0.0);
        self * zero == zero
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

impl Real for f64 {
    const APART: Self = 1e-7;
    const REACHED: Self = 1e-9;
    const ROTATION: Self = 1e-6;

    #[inline(always)]
    fn arc_tangent(self) -> Self {
        arc_tangent(self)
    }

    #[inline]
    fn rint(self) -> Self {
        libm::rint(self)
    }
}

impl Real for f32 {
    const APART: Self = 1e-3;
    const REACHED: Self = 1e-4;
    const ROTATION: Self = 1e-3;

    #[inline(always)]
    fn arc_tangent(self) -> Self {
        single_arc_tangent(self)
    }

    #[inline]
    fn rint(self) -> Self {
        libm::rintf(self)
    }
}
