//! Sines of columns of angles, as the blocks of an evaluation have them.

use fearless_simd::{Level, Simd, SimdFrom, dispatch, f64x8};

use super::{Kernel as _, Lanes as _, one, sin_cos};

/// Angles in one vector.
const LANES: usize = 8;

/// Sine and cosine of every angle of a column, rad; of as many angles as all three columns hold.
///
/// The digits are those of [`Scalar::sin_cos`](crate::Scalar::sin_cos). It is inlined so that it is compiled where
/// columns are evaluated, and not in every build of this crate.
#[doc(hidden)]
#[inline]
pub fn sin_cos_column(
    level: Level,
    angles: &[[f64; LANES]],
    sines: &mut [[f64; LANES]],
    cosines: &mut [[f64; LANES]],
) {
    dispatch!(level, simd => groups(simd, angles, sines, cosines))
}

#[inline(always)]
fn groups<S: Simd>(
    simd: S,
    angles: &[[f64; LANES]],
    sines: &mut [[f64; LANES]],
    cosines: &mut [[f64; LANES]],
) {
    for ((angles, sines), cosines) in angles.iter().zip(sines).zip(cosines) {
        let x = f64x8::simd_from(simd, *angles);
        if x.all_within(f64::LARGEST) {
            let (s, c) = sin_cos(x);
            (*sines, *cosines) = (s.into(), c.into());
        } else {
            let values = angles.map(one);
            (*sines, *cosines) = (values.map(|(s, _)| s), values.map(|(_, c)| c));
        }
    }
}
