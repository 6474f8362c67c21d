//! What the kernel asks of a number: one double, or several in the lanes of a vector register.

use core::ops::{Add, Mul, Neg, Sub};

use wide::{f64x2, f64x4, f64x8};

/// One or several doubles, on which the same operations give the same digits.
pub(super) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// The same number in every lane.
    fn splat(x: f64) -> Self;

    /// All bits set where the numbers differ, none where they are equal.
    fn differs(self, other: Self) -> Self;

    /// The bits that are set in both.
    fn and(self, other: Self) -> Self;

    /// The bits that are set in one of both.
    fn xor(self, other: Self) -> Self;

    /// `self` where the bits of the mask are set, `other` where they are not.
    fn or_else(self, mask: Self, other: Self) -> Self {
        self.xor(other).and(mask).xor(other)
    }
}

impl Lanes for f64 {
    #[inline(always)]
    fn splat(x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn differs(self, other: Self) -> Self {
        f64::from_bits(if self != other { u64::MAX } else { 0 })
    }

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() & other.to_bits())
    }

    #[inline(always)]
    fn xor(self, other: Self) -> Self {
        f64::from_bits(self.to_bits() ^ other.to_bits())
    }
}

macro_rules! impl_lanes {
    ($($vector:ty),*) => {$(
        impl Lanes for $vector {
            #[inline(always)]
            fn splat(x: f64) -> Self {
                <$vector>::from(x)
            }

            #[inline(always)]
            fn differs(self, other: Self) -> Self {
                self.simd_ne(other)
            }

            #[inline(always)]
            fn and(self, other: Self) -> Self {
                self & other
            }

            #[inline(always)]
            fn xor(self, other: Self) -> Self {
                self ^ other
            }
        }
    )*};
}

impl_lanes!(f64x2, f64x4, f64x8);
