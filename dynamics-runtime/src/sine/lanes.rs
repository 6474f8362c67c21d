//! What the kernel needs of a number, or of several in the lanes of a vector.

use core::ops::{Add, Mul, Sub};
use fearless_simd::{Select, Simd, SimdBase, SimdFloat, SimdMask, f64x2, f64x4, f64x8};

use crate::float::Float as _;

/// A double, or several in lanes.
///
/// No operation rounds otherwise in one lane than in eight, nor on one processor than on
/// another: every width and every target gives the same digits.
pub(crate) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// The number `x` in every lane, in the arithmetic of `self`.
    fn constant(self, x: f64) -> Self;

    /// a - self b, where the product is exact: fused or not, the digits are the same.
    fn exact_product_from(self, b: Self, a: Self) -> Self;

    /// `odd` in the lanes where the lowest bit of `self` is set, and `even` in the others.
    fn select_by_lowest_bit(self, odd: Self, even: Self) -> Self;

    /// The sign of a lane turned where bit `BIT` of `of` is set.
    fn turned_by_bit<const BIT: u32>(self, of: Self) -> Self;

    /// The sign of a lane turned where one of the two lowest bits of `of` is set, but not both.
    #[inline(always)]
    fn turned_by_lowest_bits(self, of: Self) -> Self {
        self.turned_by_bit::<0>(of).turned_by_bit::<1>(of)
    }

    /// Whether |x| <= limit in every lane; false for NaN.
    fn all_within(self, limit: f64) -> bool;
}

const SIGN: u64 = 1 << 63;

impl Lanes for f64 {
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn exact_product_from(self, b: Self, a: Self) -> Self {
        (-self).times_plus(b, a)
    }

    #[inline(always)]
    fn select_by_lowest_bit(self, odd: Self, even: Self) -> Self {
        if self.to_bits() & 1 == 1 { odd } else { even }
    }

    #[inline(always)]
    fn turned_by_bit<const BIT: u32>(self, of: Self) -> Self {
        f64::from_bits(self.to_bits() ^ (of.to_bits() << (63 - BIT) & SIGN))
    }

    #[inline(always)]
    fn all_within(self, limit: f64) -> bool {
        self.abs() <= limit
    }
}

macro_rules! impl_lanes {
    ($($vector:ident),*) => {$(
        impl<S: Simd> Lanes for $vector<S> {
            #[inline(always)]
            fn constant(self, x: f64) -> Self {
                Self::splat(self.simd, x)
            }

            #[inline(always)]
            fn exact_product_from(self, b: Self, a: Self) -> Self {
                (-self).mul_add(b, a)
            }

            #[inline(always)]
            fn select_by_lowest_bit(self, odd: Self, even: Self) -> Self {
                let lowest = self.to_bits() << 63;
                let none = lowest ^ lowest;
                lowest.simd_eq(none).select(even, odd)
            }

            #[inline(always)]
            fn turned_by_bit<const BIT: u32>(self, of: Self) -> Self {
                let turn = (of.to_bits() << (63 - BIT)) & SIGN;
                Self::from_bits(self.to_bits() ^ turn)
            }

            #[inline(always)]
            fn all_within(self, limit: f64) -> bool {
                self.abs().simd_le(self.constant(limit)).all_true()
            }
        }
    )*};
}

impl_lanes!(f64x2, f64x4, f64x8);
