//! Operations of floats that `core` lacks: from the standard library, or else from `libm`.

use core::ops::{Add, Mul};

/// Whether the target multiplies and adds in one instruction.
pub(crate) const FUSED: bool = cfg!(all(
    feature = "std",
    any(target_feature = "fma", target_arch = "aarch64")
));

/// The functions of one type.
pub trait Float: Copy + Add<Output = Self> + Mul<Output = Self> {
    /// The square root; NaN of a negative number.
    fn root(self) -> Self;

    /// `self * a + b`, rounded once.
    fn fused(self, a: Self, b: Self) -> Self;

    /// `self * a + b`, rounded once where the target has an instruction for it.
    #[inline(always)]
    fn times_plus(self, a: Self, b: Self) -> Self {
        if FUSED {
            self.fused(a, b)
        } else {
            self * a + b
        }
    }
}

macro_rules! impl_float {
    ($float:ident, $sqrt:ident, $fma:ident) => {
        #[cfg(feature = "std")]
        impl Float for $float {
            #[inline(always)]
            fn root(self) -> Self {
                self.sqrt()
            }

            #[inline(always)]
            fn fused(self, a: Self, b: Self) -> Self {
                self.mul_add(a, b)
            }
        }

        #[cfg(not(feature = "std"))]
        impl Float for $float {
            #[inline]
            fn root(self) -> Self {
                libm::$sqrt(self)
            }

            #[inline]
            fn fused(self, a: Self, b: Self) -> Self {
                libm::$fma(self, a, b)
            }
        }
    };
}

impl_float!(f32, sqrtf, fmaf);
impl_float!(f64, sqrt, fma);

/// Sine and cosine.
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    #[cfg(feature = "std")]
    return x.sin_cos();
    #[cfg(not(feature = "std"))]
    libm::sincos(x)
}

/// Index of the first entry that is not finite.
#[inline(always)]
pub fn first_non_finite(entries: &[f64]) -> Option<usize> {
    entries.iter().position(|x| !x.is_finite())
}
