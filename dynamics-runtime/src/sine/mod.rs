//! Sine and cosine of several angles at once.
//!
//! Sines are most of what a short program costs. The kernel here has no
//! branches and no fused operations, so that the compiler may evaluate several
//! angles in the lanes of a vector register, and so that every target and every
//! number of lanes gives the same digits. Angles beyond [`LARGEST`] take the
//! standard library's exact reduction.
//!
//! Error below 0.8 units in the last place for |x| <= 1e5 (measured against
//! double-double values: `errors_stay_below_one_ulp`), and the standard
//! library's beyond.

mod polynomial;
mod reduction;
#[cfg(test)]
mod tests;

use polynomial::sin_cos_reduced;
use reduction::reduce;

/// The largest magnitude that the vectorised reduction takes.
const LARGEST: f64 = 1e5;

/// Sine and cosine of every angle, rad.
///
/// Error below one unit in the last place. Not a number, and infinities, give NaN.
#[inline]
pub(crate) fn sin_cos_array<const K: usize>(angles: [f64; K]) -> [(f64, f64); K] {
    // A maximum ignores NaN: the comparison with it is what must fail.
    if angles.iter().all(|x| x.abs() <= LARGEST) {
        return in_lanes(angles);
    }
    angles.map(|x| {
        if x.abs() <= LARGEST {
            sin_cos(x)
        } else {
            x.sin_cos()
        }
    })
}

/// The kernel over vectors of two, four or eight lanes.
#[inline]
fn in_lanes<const K: usize>(angles: [f64; K]) -> [(f64, f64); K] {
    let mut values = [(0.0, 1.0); K];
    match K {
        0 => {}
        1 => values[0] = sin_cos(angles[0]),
        2 => lanes::<2>(&angles, &mut values),
        3 | 4 => lanes::<4>(&angles, &mut values),
        _ => {
            for (angles, values) in angles.chunks(8).zip(values.chunks_mut(8)) {
                lanes::<8>(angles, values);
            }
        }
    }
    values
}

/// Up to `W` angles, as `W` lanes.
#[inline(always)]
fn lanes<const W: usize>(angles: &[f64], values: &mut [(f64, f64)]) {
    let mut x = [0.0; W];
    x[..angles.len()].copy_from_slice(angles);
    let (mut sines, mut cosines) = ([0.0; W], [0.0; W]);
    for lane in 0..W {
        (sines[lane], cosines[lane]) = sin_cos(x[lane]);
    }
    for (lane, value) in values.iter_mut().enumerate() {
        *value = (sines[lane], cosines[lane]);
    }
}

/// Sine and cosine of an angle of magnitude up to [`LARGEST`].
#[inline(always)]
fn sin_cos(x: f64) -> (f64, f64) {
    let reduced = reduce(x);
    let (s, c) = sin_cos_reduced(reduced.high, reduced.low);
    // A quarter turn: (s, c) -> (c, -s).
    let swap = (reduced.quarters & 1).wrapping_neg();
    let (s, c) = (s.to_bits(), c.to_bits());
    let (sine, cosine) = ((s & !swap) | (c & swap), (c & !swap) | (s & swap));
    let sine_sign = (reduced.quarters & 2) << 62;
    let cosine_sign = (reduced.quarters.wrapping_add(1) & 2) << 62;
    let sine = f64::from_bits(sine ^ sine_sign);
    // Zero keeps its sign.
    let sine = if x == 0.0 { x } else { sine };
    (sine, f64::from_bits(cosine ^ cosine_sign))
}
