//! The numbers that the functions are measured in.

use std::ops::{Add, Div, Mul, Neg, Sub};

use robot_dynamics::{DoubleDouble, Scalar};

/// Whether this program was built for a processor that multiplies and adds in one instruction.
pub(crate) const BUILT_FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// A number whose value is known exactly.
pub(crate) trait Number: Scalar {
    fn exactly(self) -> DoubleDouble;
}

impl Number for f64 {
    fn exactly(self) -> DoubleDouble {
        DoubleDouble::from(self)
    }
}

impl Number for f32 {
    fn exactly(self) -> DoubleDouble {
        DoubleDouble::from(f64::from(self))
    }
}

/// A double whose sums of products are fused where this build does not fuse them, and apart where
/// it does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Otherwise(pub(crate) f64);

impl Number for Otherwise {
    fn exactly(self) -> DoubleDouble {
        DoubleDouble::from(self.0)
    }
}

macro_rules! operators {
    ($($operator:ident, $method:ident;)*) => {$(
        impl $operator for Otherwise {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Otherwise($operator::$method(self.0, other.0))
            }
        }
    )*};
}

operators! {
    Add, add;
    Sub, sub;
    Mul, mul;
    Div, div;
}

impl Neg for Otherwise {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Otherwise(-self.0)
    }
}

impl Scalar for Otherwise {
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Otherwise(x)
    }

    #[inline(always)]
    fn epsilon() -> Self {
        Otherwise(f64::EPSILON)
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let [value] = Self::sin_cos_array([self]);
        value
    }

    #[inline(always)]
    fn sin_cos_array<const K: usize>(angles: [Self; K]) -> [(Self, Self); K] {
        f64::sin_cos_array(angles.map(|x| x.0)).map(|(s, c)| (Otherwise(s), Otherwise(c)))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Otherwise(self.0.sqrt())
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        match BUILT_FUSED {
            true => Otherwise(self.0 * a.0 + b.0),
            false => Otherwise(f64::mul_add(self.0, a.0, b.0)),
        }
    }

    #[inline(always)]
    fn sign(self) -> Self {
        Otherwise(Scalar::sign(self.0))
    }

    #[inline(always)]
    fn is_positive(self) -> bool {
        self.0 > 0.0
    }

    #[inline(always)]
    fn ratio_to_f64(self, of: Self) -> f64 {
        self.0 / of.0
    }
}

/// Runs a function where the compiler may use the fused instruction, if this machine has it: a
/// plain build has it nowhere else. The function must be inlined.
#[inline(always)]
pub(crate) fn with_fused_instructions<R>(function: impl FnOnce() -> R) -> R {
    #[cfg(target_arch = "x86_64")]
    if let Some(instructions) = fearless_simd::Level::new().as_avx2() {
        return fearless_simd::Simd::vectorize(instructions, function);
    }
    function()
}

/// Whether fused instructions can be used here.
pub(crate) fn can_fuse() -> bool {
    #[cfg(target_arch = "x86_64")]
    return fearless_simd::Level::new().as_avx2().is_some();
    #[cfg(not(target_arch = "x86_64"))]
    return BUILT_FUSED;
}
