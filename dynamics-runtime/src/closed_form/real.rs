//! The numbers that closed forms run on.

use crate::Scalar;

/// `f64` and `f32`, which can be compared and have no digits that a double has not.
pub trait Real: Scalar + PartialOrd + Into<f64> + sealed::Sealed {
    /// Angles, rad, that are closer than this cannot be told apart: 1e-7, in single precision 1e-3.
    const APART: Self;
    /// A pose counts as reached that is missed by this part of the distances in it: 1e-9, in single precision 1e-4.
    const REACHED: Self;
    /// The columns of a rotation are unit vectors at right angles to this: 1e-6, in single precision 1e-3.
    const ROTATION: Self;

    /// Whether the number is finite.
    #[inline]
    fn is_finite(self) -> bool {
        self.into().is_finite()
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
}

impl Real for f32 {
    const APART: Self = 1e-3;
    const REACHED: Self = 1e-4;
    const ROTATION: Self = 1e-3;
}
