//! Two to eight angles of one state in the lanes of vector registers.

use fearless_simd::{Level, Simd, SimdBase, SimdFrom, dispatch, f32x4, f32x8, f64x2, f64x4, f64x8};

use super::{Kernel, Lanes, Sines, one, sin_cos};

/// The sines and the cosines of some lanes.
pub(super) type Pair<F, const W: usize> = ([F; W], [F; W]);

macro_rules! in_lanes {
    ($name:ident($($x:ident),*) of $float:ident, $width:literal: $simd:ident => $sines:expr) => {
        /// Sines and cosines in the lanes of vectors. The angles come as numbers and not as an
        /// array: they stay in registers on the way.
        #[inline(always)]
        #[allow(clippy::too_many_arguments)]
        pub(super) fn $name(level: Level, $($x: $float),*) -> Pair<$float, $width> {
            #[inline(always)]
            #[allow(clippy::too_many_arguments)]
            fn evaluated<S: Simd>($simd: S, $($x: $float),*) -> Pair<$float, $width> {
                match $sines {
                    Some(pair) => pair,
                    None => rarely([$($x),*]),
                }
            }

            /// For the processor at hand, with instructions that the caller does not have.
            #[cfg_attr(any(target_arch = "x86", target_arch = "x86_64"), inline(never))]
            #[cfg_attr(not(any(target_arch = "x86", target_arch = "x86_64")), inline(always))]
            #[allow(clippy::too_many_arguments)]
            fn dispatched(level: Level, $($x: $float),*) -> Pair<$float, $width> {
                dispatch!(level, simd => evaluated(simd, $($x),*))
            }

            // A build without optimisation would hold the ways of both in every function that needs sines.
            #[cfg(all(any(target_arch = "x86", target_arch = "x86_64"), not(debug_assertions)))]
            match (Level::baseline().as_avx512(), Level::baseline().as_avx2()) {
                (Some(simd), _) => return evaluated(simd, $($x),*),
                (None, Some(simd)) => return evaluated(simd, $($x),*),
                (None, None) => {}
            }
            dispatched(level, $($x),*)
        }
    };
}

in_lanes!(two(a, b) of f64, 2: simd => whole(f64x2::simd_from(simd, [a, b])));
in_lanes!(four(a, b, c, d) of f64, 4: simd => whole(f64x4::simd_from(simd, [a, b, c, d])));
in_lanes!(eight(a, b, c, d, e, f, g, h) of f64, 8: simd => if IS_HALVED {
    halves(f64x4::simd_from(simd, [a, b, c, d]), f64x4::simd_from(simd, [e, f, g, h]))
} else {
    whole(f64x8::simd_from(simd, [a, b, c, d, e, f, g, h]))
});
in_lanes!(four_singles(a, b, c, d) of f32, 4: simd => whole(f32x4::simd_from(simd, [a, b, c, d])));
in_lanes!(eight_singles(a, b, c, d, e, f, g, h) of f32, 8:
    simd => whole(f32x8::simd_from(simd, [a, b, c, d, e, f, g, h])));

/// Two angles in the lanes of four.
#[inline(always)]
pub(super) fn two_singles(level: Level, a: f32, b: f32) -> Pair<f32, 4> {
    four_singles(level, a, b, 0.0, 0.0)
}

/// Whether eight doubles are in two vectors, and not in one of 512 bits.
///
/// On Intel's processors an instruction of 512 bits takes both units that multiply doubles, and the operations behind the
/// sines take up to twice as long (`docs/contributing/TRIED.md`). AMD's, which alone have SSE4a, gain by one vector. Where the build
/// leaves the instructions to the processor at hand, sines are calls, and are over before the rest begins.
const IS_HALVED: bool = cfg!(all(
    target_feature = "avx512f",
    not(target_feature = "sse4a")
));

/// Sines and cosines in the lanes of one vector; nothing where an angle is too large, or no number.
#[inline(always)]
fn whole<S: Simd, V, A>(x: V) -> Option<(A, A)>
where
    V: Lanes + SimdBase<S, Array = A>,
{
    if !x.all_within(V::Number::LARGEST) {
        return None;
    }
    let (s, c) = sin_cos(x);
    Some((s.to_array(), c.to_array()))
}

/// The same of eight angles in two vectors.
#[inline(always)]
pub(super) fn halves<S: Simd>(x: f64x4<S>, y: f64x4<S>) -> Option<Pair<f64, 8>> {
    let is_usual = x.all_within(f64::LARGEST) && y.all_within(f64::LARGEST);
    if !is_usual {
        return None;
    }
    let ((s, c), (t, d)) = (sin_cos(x), sin_cos(y));
    let sines = side_by_side(s.to_array(), t.to_array());
    Some((sines, side_by_side(c.to_array(), d.to_array())))
}

/// The numbers of two vectors, one by one: of arrays the compiler makes one vector.
#[inline(always)]
fn side_by_side(low: [f64; 4], high: [f64; 4]) -> [f64; 8] {
    let ([a, b, c, d], [e, f, g, h]) = (low, high);
    [a, b, c, d, e, f, g, h]
}

/// Angles among which there is a large one, or no number.
///
/// The angles are an array of their own here, because an array with an address stays out of the registers. So are sines
/// and cosines: side by side, the compiler would join them on the usual way too, in one vector of twice the width.
#[inline(always)]
fn rarely<F: Sines + Default, const W: usize>(x: [F; W]) -> Pair<F, W> {
    let (mut sines, mut cosines) = ([F::default(); W], [F::default(); W]);
    one_by_one(x, &mut sines, &mut cosines);
    (sines, cosines)
}

#[cold]
#[inline(never)]
fn one_by_one<F: Sines, const W: usize>(x: [F; W], sines: &mut [F; W], cosines: &mut [F; W]) {
    for ((x, sine), cosine) in x.into_iter().zip(sines).zip(cosines) {
        (*sine, *cosine) = one(x);
    }
}

/// The processor's instruction set; looked up at run time where the build does not settle it, and there is a standard
/// library to ask.
#[inline(always)]
pub(crate) fn level() -> Level {
    let baseline = Level::baseline();
    #[cfg(all(feature = "std", any(target_arch = "x86", target_arch = "x86_64")))]
    if baseline.as_avx512().is_none() {
        return Level::new();
    }
    baseline
}
