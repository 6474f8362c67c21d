//! What the kernels need of a number, or of several in the lanes of a vector.

use core::ops::{Add, Mul, Sub};
use fearless_simd::{
    Select, Simd, SimdBase, SimdFloat, SimdMask, f32x4, f32x8, f64x2, f64x4, f64x8,
};

use crate::float::Float as _;

/// A float, or several in lanes.
///
/// No operation rounds otherwise in one lane than in eight, nor on one processor than on
/// another: every width and every target gives the same digits.
pub(crate) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// The number in a lane.
    type Number: Kernel;

    /// The number `x` in every lane, in the arithmetic of `self`.
    fn constant(self, x: Self::Number) -> Self;

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
    fn all_within(self, limit: Self::Number) -> bool;
}

/// The sines of one precision.
pub(crate) trait Kernel: Copy {
    /// The largest magnitude that [`reduce`](Kernel::reduce) takes.
    const LARGEST: Self;

    /// Reduces angles of magnitude up to [`LARGEST`](Kernel::LARGEST).
    fn reduce<L: Lanes<Number = Self>>(x: L) -> Reduced<L>;

    /// Sine and cosine of x + e with |x| at most a little above pi/4, where e is below the last place of x, or
    /// both are tiny.
    fn sin_cos_reduced<L: Lanes<Number = Self>>(x: L, e: L) -> (L, L);

    /// Sine and cosine of an angle of any magnitude, reduced exactly; NaN of what is not finite.
    fn sin_cos_of_large(self) -> (Self, Self);
}

/// x = n pi/2 + rest + tail, |rest| at most a little above pi/4.
pub(crate) struct Reduced<L> {
    /// A number whose lowest bits are those of n.
    pub(super) n: L,
    /// The rest.
    pub(super) rest: L,
    /// What `rest` leaves out.
    pub(super) tail: L,
}

macro_rules! impl_number {
    ($($float:ident: $last_bit:literal),*) => {$(
        impl Lanes for $float {
            type Number = $float;

            #[inline(always)]
            fn constant(self, x: $float) -> Self {
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
                let turn = (of.to_bits() >> BIT) << $last_bit;
                $float::from_bits(self.to_bits() ^ turn)
            }

            #[inline(always)]
            fn all_within(self, limit: $float) -> bool {
                self.abs() <= limit
            }
        }
    )*};
}

impl_number!(f32: 31, f64: 63);

macro_rules! impl_lanes {
    ($($vector:ident: $float:ident, $last_bit:literal),*) => {$(
        impl<S: Simd> Lanes for $vector<S> {
            type Number = $float;

            #[inline(always)]
            fn constant(self, x: $float) -> Self {
                Self::splat(self.simd, x)
            }

            #[inline(always)]
            fn exact_product_from(self, b: Self, a: Self) -> Self {
                (-self).mul_add(b, a)
            }

            #[inline(always)]
            fn select_by_lowest_bit(self, odd: Self, even: Self) -> Self {
                let lowest = self.to_bits() << $last_bit;
                let none = lowest ^ lowest;
                lowest.simd_eq(none).select(even, odd)
            }

            #[inline(always)]
            fn turned_by_bit<const BIT: u32>(self, of: Self) -> Self {
                let turn = (of.to_bits() >> BIT) << $last_bit;
                Self::from_bits(self.to_bits() ^ turn)
            }

            #[inline(always)]
            fn all_within(self, limit: $float) -> bool {
                self.abs().simd_le(self.constant(limit)).all_true()
            }
        }
    )*};
}

impl_lanes!(f32x4: f32, 31, f32x8: f32, 31, f64x2: f64, 63, f64x4: f64, 63, f64x8: f64, 63);
