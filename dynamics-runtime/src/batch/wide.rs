//! Several numbers in the lanes of one vector register, as a [`Scalar`].

use core::any::Any;
use core::fmt;

use fearless_simd::{
    Bytes, ExtractToken, Level, Select, Simd, SimdBase, SimdFloat, SimdFloatElement, SimdMask,
    dispatch,
};

use super::abreast;
use crate::Scalar;
use crate::operators::{impl_operators, scalar_methods};
use crate::sine::{self, Kernel, Lanes, Part};
use crate::unrolled::for_each_index;

/// The numbers of a batch: `f64`, or `f32` in twice as many lanes.
#[diagnostic::on_unimplemented(message = "batches are of `f64` or `f32`, not of `{Self}`")]
pub trait Precision: Scalar + SimdFloatElement + Send + Sync {
    /// The number of lanes of the widest vectors.
    #[doc(hidden)]
    const MOST_LANES: usize;

    /// Sines and cosines of angles in lanes, of which only these parts are read.
    #[doc(hidden)]
    fn sin_cos_of_lanes<S: Simd, const K: usize>(
        angles: [Wide<S, Self>; K],
        parts: [Part; K],
    ) -> [(Wide<S, Self>, Wide<S, Self>); K];
}

/// As many numbers as a vector register of the instruction set `S` holds.
///
/// `S` cannot be had where the processor lacks the instructions, so that every number carries the
/// proof that its operations may run; it takes no space.
#[derive(Clone, Copy)]
pub struct Wide<S: Simd, E: Precision>(pub(super) E::Native<S>);

/// The number of lanes.
pub(super) const fn lanes<S: Simd, E: Precision>() -> usize {
    <E::Native<S> as SimdBase<S>>::LEN
}

impl<S: Simd, E: Precision> Wide<S, E> {
    /// The number `x` in every lane.
    #[inline(always)]
    fn splat(self, x: E) -> E::Native<S> {
        E::Native::<S>::splat(self.0.token(), x)
    }
}

impl_operators! {
    impl [S: Simd, E: Precision] for Wide<S, E>;
    Add add |a, b| Wide(a.0 + b.0);
    Sub sub |a, b| Wide(a.0 - b.0);
    Mul mul |a, b| Wide(a.0 * b.0);
    Div div |a, b| Wide(a.0 / b.0);
    Neg neg |a| Wide(-a.0);
}

impl<S: Simd, E: Precision> PartialEq for Wide<S, E> {
    fn eq(&self, other: &Self) -> bool {
        self.0.as_slice() == other.0.as_slice()
    }
}

impl<S: Simd, E: Precision> fmt::Debug for Wide<S, E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.as_slice().fmt(f)
    }
}

#[diagnostic::do_not_recommend]
impl<S: Simd, E: Precision> Scalar for Wide<S, E> {
    /// Generated functions do not come here: they make their constants by
    /// [`constant`](Scalar::constant), which need not ask the processor.
    #[cold]
    fn from_f64(x: f64) -> Self {
        Wide(E::Native::<S>::splat(token(), E::from_f64(x)))
    }

    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        Wide(self.splat(E::from_f64(x)))
    }

    #[inline(always)]
    fn rounded_once(mut self, single: f32) -> Self {
        for x in self.0.as_mut_slice() {
            *x = x.rounded_once(single);
        }
        self
    }

    #[cold]
    fn epsilon() -> Self {
        Wide(E::Native::<S>::splat(token(), E::epsilon()))
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let [value] = Self::sin_cos_array([self]);
        value
    }

    #[inline(always)]
    fn sin_cos_array<const K: usize>(angles: [Self; K]) -> [(Self, Self); K] {
        sin_cos_of_lanes(angles, [Part::Both; K])
    }

    #[inline(always)]
    fn sin_cos_parts<const K: usize>(angles: [Self; K], parts: [Part; K]) -> [(Self, Self); K] {
        sin_cos_of_lanes(angles, parts)
    }

    scalar_methods! {
        sqrt(x) => Wide(x.0.sqrt());
        mul_add(x, a, b) => Wide(x.0.mul_add(a.0, b.0));
    }

    /// Lane by lane.
    #[inline]
    fn exp(mut self) -> Self {
        for x in self.0.as_mut_slice() {
            *x = Scalar::exp(*x);
        }
        self
    }

    #[inline(always)]
    fn sign(self) -> Self {
        let (zero, one) = (self.splat(E::from_f64(0.0)), self.splat(E::from_f64(1.0)));
        // Zero of either sign is +0, and NaN is NaN, plus zero.
        let is_signed = self.0.abs().simd_gt(zero);
        Wide(is_signed.select(one.copysign(self.0), self.0 + zero))
    }

    #[inline(always)]
    fn is_positive(self) -> bool {
        self.0.simd_gt(self.splat(E::from_f64(0.0))).all_true()
    }

    #[inline(always)]
    fn exceeds_rounding_of(self, size: Self) -> bool {
        let rounding = size * Wide(self.splat(E::epsilon() * E::from_f64(8.0)));
        (self - rounding).is_positive() && (self + rounding).is_positive()
    }

    #[cold]
    fn ratio_to_f64(self, of: Self) -> f64 {
        let (of, ratios) = (of.0, self.0);
        let ratios = ratios.as_slice().iter().zip(of.as_slice());
        let least = |least: f64, ratio: f64| if least <= ratio { least } else { ratio };
        ratios
            .map(|(a, b)| a.ratio_to_f64(*b))
            .reduce(least)
            .unwrap_or(f64::NAN)
    }
}

/// Sines and cosines of angles in lanes, of which only these parts are read.
///
/// A call in a build without optimisation, where every function of a batch would hold 200 KB of sines.
#[cfg_attr(not(debug_assertions), inline(always))]
fn sin_cos_of_lanes<S: Simd, E: Precision, const K: usize>(
    angles: [Wide<S, E>; K],
    parts: [Part; K],
) -> [(Wide<S, E>, Wide<S, E>); K] {
    #[cfg(not(debug_assertions))]
    return E::sin_cos_of_lanes(angles, parts);
    #[cfg(debug_assertions)]
    match angles.first() {
        Some(first) => first.0.token().vectorize(
            #[inline(always)]
            || E::sin_cos_of_lanes(angles, parts),
        ),
        None => angles.map(|angle| (angle, angle)),
    }
}

/// Whether a product and a sum in lanes are one instruction, which rounds once.
#[inline(always)]
fn fuses(level: Level) -> bool {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    return matches!(level, Level::Avx2(_) | Level::Avx512(_));
    #[cfg(target_arch = "aarch64")]
    return matches!(level, Level::Neon(_));
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
    return {
        let _ = level;
        false
    };
}

/// The instruction set, asked of the processor.
fn token<S: Simd>() -> S {
    let same = |token: &dyn Any| token.downcast_ref::<S>().copied();
    // The best one has all the others in it.
    let level = Level::new();
    let mut found = dispatch!(level, simd => same(&simd));
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        found = found
            .or_else(|| same(&level.as_avx2()?))
            .or_else(|| same(&level.as_sse4_2()?))
            .or_else(|| same(&level.as_sse2()?));
    }
    found.expect("lanes exist only where the processor has their instructions")
}

macro_rules! impl_precision {
    ($($float:ident: $bits:ident, $signed:ident, $last_bit:literal, $most_lanes:literal;)*) => {$(
        impl Precision for $float {
            const MOST_LANES: usize = $most_lanes;

            #[inline(always)]
            fn sin_cos_of_lanes<S: Simd, const K: usize>(
                angles: [Wide<S, $float>; K],
                parts: [Part; K],
            ) -> [(Wide<S, $float>, Wide<S, $float>); K] {
                // Not `map`: the functions of arrays that take a closure are not inlined for certain, and
                // the closure by itself has none of the instructions.
                let Some(&first) = angles.first() else {
                    return angles.map(|angle| (angle, angle));
                };
                let limit = first.splat($float::LARGEST);
                let mut within = first.0.abs().simd_le(limit);
                for angle in &angles[1..] {
                    within &= angle.0.abs().simd_le(limit);
                }
                let mut values = [(first, first); K];
                if within.all_true() {
                    abreast::sin_cos_of_each(&angles, &mut values);
                    // Parts that the program does not read are not computed.
                    for_each_index!(K, i => {
                        if parts[i] != Part::Both {
                            let value = sine::part_in_lanes(angles[i], parts[i]);
                            values[i] = (value, value);
                        }
                    });
                } else {
                    // By way of memory that is used nowhere else: what has an address stays out of the
                    // registers.
                    let mut copy = [first; K];
                    for_each_index!(K, i => copy[i] = angles[i]);
                    let copy = sin_cos_of_large(&copy, sine::one::<$float>);
                    for_each_index!(K, i => values[i] = copy[i]);
                }
                values
            }
        }

        impl<S: Simd> Lanes for Wide<S, $float> {
            type Number = $float;

            const OF_A_BATCH: bool = true;

            #[inline(always)]
            fn constant(self, x: $float) -> Self {
                Wide(self.splat(x))
            }

            #[inline(always)]
            fn product_plus(self, a: Self, b: Self) -> Self {
                Wide(self.0.mul_add(a.0, b.0))
            }

            #[inline(always)]
            fn product_minus(self, a: Self, b: Self) -> Self {
                Wide(self.0.mul_sub(a.0, b.0))
            }

            #[inline(always)]
            fn product_from(self, b: Self, a: Self) -> Self {
                Wide((-self.0).mul_add(b.0, a.0))
            }

            #[inline(always)]
            fn fuses(self) -> bool {
                fuses(self.0.token().level())
            }

            #[inline(always)]
            fn select_by_lowest_bit(self, odd: Self, even: Self) -> Self {
                // Negative where the bit is the sign: a selection needs no more than the sign.
                let lowest = self.0.bitcast::<S::$signed>() << $last_bit;
                let zero = S::$signed::splat(self.0.token(), 0);
                Wide(lowest.simd_lt(zero).select(odd.0, even.0))
            }

            #[inline(always)]
            fn turned_by_bit<const BIT: u32>(self, of: Self) -> Self {
                let turn = (of.0.bitcast::<S::$bits>() >> BIT) << $last_bit;
                Wide((self.0.bitcast::<S::$bits>() ^ turn).bitcast())
            }

            #[inline(always)]
            fn all_within(self, limit: $float) -> bool {
                self.0.abs().simd_le(self.splat(limit)).all_true()
            }
        }
    )*};
}

impl_precision! {
    f32: u32s, i32s, 31, 16;
    f64: u64s, i64s, 63, 8;
}

/// Angles among which there is a large one, or no number: what one state does, for each.
#[cold]
#[inline(never)]
fn sin_cos_of_large<S: Simd, E: Precision, const K: usize>(
    angles: &[Wide<S, E>; K],
    one: fn(E) -> (E, E),
) -> [(Wide<S, E>, Wide<S, E>); K] {
    angles.map(|mut angle| {
        let mut sine = angle;
        for (x, s) in angle.0.as_mut_slice().iter_mut().zip(sine.0.as_mut_slice()) {
            (*s, *x) = one(*x);
        }
        (sine, angle)
    })
}
