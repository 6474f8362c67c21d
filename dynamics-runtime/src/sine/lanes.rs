//! The operations of the kernels on a number, or on several in the lanes of a vector.

use core::ops::{Add, Mul, Sub};
use fearless_simd::{
    Select, Simd, SimdBase, SimdFloat, SimdMask, f32x4, f32x8, f64x2, f64x4, f64x8,
};

use crate::float::Float as _;
use crate::unrolled::for_each_index;

/// A float, or several in lanes.
///
/// But for products that are fused with sums, every width and every target rounds alike and gives the same digits.
pub(crate) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
    /// The number in a lane.
    type Number: Kernel;

    /// Whether the lanes are states of a batch, whose sines take as long as their operations are many: those of
    /// one state take as long as its operations wait for each other.
    const OF_A_BATCH: bool = false;

    /// The number `x` in every lane, in the arithmetic of `self`.
    fn constant(self, x: Self::Number) -> Self;

    /// a - self b, rounded once where the processor at hand has an instruction for it: where the product is exact,
    /// the digits are the same either way.
    fn product_from(self, b: Self, a: Self) -> Self;

    /// self a + b, rounded once where the processor at hand has an instruction for it: for the lanes of batches.
    #[inline(always)]
    fn product_plus(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    /// self a - b, rounded once where the processor at hand has an instruction for it.
    #[inline(always)]
    fn product_minus(self, a: Self, b: Self) -> Self {
        self * a - b
    }

    /// `odd` in the lanes where the lowest bit of `self` is set, and `even` in the others.
    fn select_by_lowest_bit(self, odd: Self, even: Self) -> Self;

    /// The sign of a lane turned where bit `BIT` of `of` is set.
    fn turned_by_bit<const BIT: u32>(self, of: Self) -> Self;

    /// The sign of a lane turned where one of the two lowest bits of `of` is set, but not both.
    #[inline(always)]
    fn turned_by_lowest_bits(self, of: Self) -> Self {
        self.turned_by_bit::<0>(of).turned_by_bit::<1>(of)
    }

    /// Whether [`product_plus`](Lanes::product_plus) rounds once.
    #[inline(always)]
    fn fuses(self) -> bool {
        false
    }

    /// Whether |x| <= limit in every lane; false for NaN.
    fn all_within(self, limit: Self::Number) -> bool;
}

/// The sines of one precision.
pub(crate) trait Kernel: Copy {
    /// 1/2 and 1.
    const HALF: Self;
    const ONE: Self;

    /// The largest magnitude that [`reduce`](Kernel::reduce) takes.
    const LARGEST: Self;

    /// Reduces angles of magnitude up to [`LARGEST`](Kernel::LARGEST).
    fn reduce<L: Lanes<Number = Self>>(x: L) -> Reduced<L>;

    /// Sine and cosine of x - d with |x| at most a little above pi/4, where d is below the last place of x, or
    /// both are tiny.
    fn sin_cos_reduced<L: Lanes<Number = Self>>(x: L, d: L) -> (L, L);

    /// The sine of x - d alone, in as few operations as it takes.
    #[cfg(feature = "std")]
    fn sine_reduced<L: Lanes<Number = Self>>(x: L, d: L) -> L;

    /// Sine and cosine of an angle of any magnitude, reduced exactly; NaN of what is not finite.
    fn sin_cos_of_large(self) -> (Self, Self);
}

/// x = n pi/2 + rest - excess, |rest| at most a little above pi/4.
pub(crate) struct Reduced<L> {
    /// A number whose lowest bits are those of n.
    pub(super) n: L,
    /// The rest.
    pub(super) rest: L,
    /// The excess of `rest`.
    pub(super) excess: L,
}

/// Sine and cosine of x - d by the polynomials whose coefficients are given, in as few operations as they
/// take, where d is below the last place of x, or both are tiny.
///
/// Where products are fused the cosine is 1 - (x - d)^2 Q, where Q = 1/2 - x^2 (C0 + ...) does not wait for d. Errors
/// are in units of its last place, 2^-53 in double precision. Its own rounding is at most 0.5, that of the square 0.25
/// (at most 0.62, half a unit, times Q below 1/2), that of Q 0.16 (a quarter of a unit, times the square). Others are
/// below 0.03: less than 0.94 units in all. Rounded products would add a quarter of a unit: there the rounding of 1 -
/// x^2/2 is made good.
#[inline(always)]
pub(super) fn by_fewest_operations<L: Lanes, const K: usize>(
    x: L,
    d: L,
    sine: [L::Number; K],
    cosine: [L::Number; K],
) -> (L, L) {
    let (half, one) = (x.constant(L::Number::HALF), x.constant(L::Number::ONE));
    let z = x * x;
    if x.fuses() {
        let q = z.product_from(polynomial(z, cosine), half);
        let square = x.product_minus(x, x * (d + d));
        return (sine_by_fewest(x, d, z, sine), square.product_from(q, one));
    }
    // cos (x - d) = 1 - x^2/2 + x^4 (C0 + ...) + x d
    let half_z = half * z;
    let w = one - half_z;
    let lost = (one - w) - half_z;
    let rest = L::product_plus(x, d, lost);
    let cosine = w + L::product_plus(z * z, polynomial(z, cosine), rest);
    (sine_by_fewest(x, d, z, sine), cosine)
}

/// sin (x - d) = x - (x^3 (S0 + ...) + d), where z = x^2: cos x is left off d, which is a half of the last place.
#[inline(always)]
pub(super) fn sine_by_fewest<L: Lanes, const K: usize>(
    x: L,
    d: L,
    z: L,
    coefficients: [L::Number; K],
) -> L {
    x - L::product_plus(x * z, polynomial(z, coefficients), d)
}

/// c[0] + c[1] z + c[2] z^2 + ... (Horner).
#[inline(always)]
fn polynomial<L: Lanes, const K: usize>(z: L, c: [L::Number; K]) -> L {
    let mut sum = z.constant(c[K - 1]);
    for_each_index!(K, i => {
        if i > 0 {
            sum = L::product_plus(sum, z, z.constant(c[K - 1 - i]));
        }
    });
    sum
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
            fn product_from(self, b: Self, a: Self) -> Self {
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
            fn product_from(self, b: Self, a: Self) -> Self {
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
