//! Sine and cosine of several angles at once.
//!
//! Sines are most of what a short program costs. The kernel here has no branches, so that several
//! angles are evaluated in the lanes of a vector register, as wide as the processor at hand has
//! them, and no operation that rounds otherwise where it is fused: every processor and every
//! number of lanes gives the same digits. Angles beyond [`LARGEST`] take the exact reduction of the
//! `libm` crate (Payne and Hanek 1983), which is the same on every platform too; the C library's
//! loses up to 80 units in the last place near multiples of pi/2.
//!
//! Error below 0.8 units in the last place for |x| <= 1e5 (measured on ten million angles against
//! double-double values, see the tests) and beyond.

mod lanes;
mod polynomial;
mod reduction;
#[cfg(test)]
mod tests;

use fearless_simd::{Level, SimdBase, SimdFrom, dispatch, f64x2, f64x4, f64x8};
pub(crate) use lanes::Lanes;
use polynomial::sin_cos_reduced;
use reduction::{Reduced, reduce};

/// The largest magnitude that the vectorised reduction takes.
pub(crate) const LARGEST: f64 = 1e5;

/// Sine and cosine of every angle, rad.
///
/// Error below one unit in the last place. Not a number, and infinities, give NaN.
#[inline]
pub(crate) fn sin_cos_array<const K: usize>(x: [f64; K]) -> [(f64, f64); K] {
    let mut values = [(0.0, 1.0); K];
    match K {
        0 => {}
        1 => values[0] = one(x[0]),
        2 => store(two(level(), x[0], x[1]), &mut values),
        3 => store(four(level(), x[0], x[1], x[2], 0.0), &mut values),
        4 => store(four(level(), x[0], x[1], x[2], x[3]), &mut values),
        _ => {
            let level = level();
            for (x, values) in x.chunks(8).zip(values.chunks_mut(8)) {
                let lane = |i: usize| if i < x.len() { x[i] } else { 0.0 };
                let [a, b, c, d, e, f, g, h] = core::array::from_fn(lane);
                store(eight(level, a, b, c, d, e, f, g, h), values);
            }
        }
    }
    values
}

/// The first lanes, as many as there are places for them.
#[inline(always)]
fn store<const W: usize>((sines, cosines): Pair<W>, values: &mut [(f64, f64)]) {
    for (value, pair) in values.iter_mut().zip(sines.into_iter().zip(cosines)) {
        *value = pair;
    }
}

/// Sine and cosine of one angle.
#[inline]
pub(crate) fn one(x: f64) -> (f64, f64) {
    if x.all_within(LARGEST) {
        sin_cos(x)
    } else {
        libm::sincos(x)
    }
}

/// The sines and the cosines of some lanes.
type Pair<const W: usize> = ([f64; W], [f64; W]);

macro_rules! in_a_vector {
    ($name:ident: $vector:ident, $width:literal, $($x:ident),*) => {
        /// Sines and cosines in the lanes of one vector. The angles come as numbers and not as an
        /// array: they stay in registers on the way.
        #[inline]
        #[allow(clippy::too_many_arguments)]
        fn $name(level: Level, $($x: f64),*) -> Pair<$width> {
            dispatch!(level, simd => {
                let x = $vector::simd_from(simd, [$($x),*]);
                if x.all_within(LARGEST) {
                    let (s, c) = sin_cos(x);
                    (s.to_array(), c.to_array())
                } else {
                    one_by_one([$($x),*])
                }
            })
        }
    };
}

in_a_vector!(two: f64x2, 2, a, b);
in_a_vector!(four: f64x4, 4, a, b, c, d);
in_a_vector!(eight: f64x8, 8, a, b, c, d, e, f, g, h);

/// The way of angles among which there is a large one, or no number.
#[cold]
#[inline(never)]
fn one_by_one<const W: usize>(x: [f64; W]) -> Pair<W> {
    let values = x.map(one);
    (values.map(|(s, _)| s), values.map(|(_, c)| c))
}

/// The processor's instruction set; asked for at run time where the build does not settle it, and
/// there is a standard library to ask.
#[inline(always)]
pub(crate) fn level() -> Level {
    let baseline = Level::baseline();
    #[cfg(all(feature = "std", any(target_arch = "x86", target_arch = "x86_64")))]
    if baseline.as_avx512().is_none() {
        return Level::new();
    }
    baseline
}

/// Sine and cosine of angles of magnitude up to [`LARGEST`].
#[inline(always)]
pub(crate) fn sin_cos<L: Lanes>(x: L) -> (L, L) {
    let Reduced { n, rest, tail } = reduce(x);
    let (s, c) = sin_cos_reduced(rest, tail);
    // A quarter turn: (s, c) -> (c, -s).
    let sine = n.select_by_lowest_bit(c, s).turned_by_bit::<1>(n);
    let cosine = n.select_by_lowest_bit(s, c).turned_by_lowest_bits(n);
    (sine, cosine)
}
