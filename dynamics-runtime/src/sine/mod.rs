//! Sine and cosine of several angles at once.
//!
//! Sines are most of what a short program costs. The kernel here has neither
//! branches nor fused operations, so that several angles are evaluated in the
//! lanes of a vector register, and so that every target and every number of
//! lanes gives the same digits. Angles beyond [`LARGEST`] take the standard
//! library's exact reduction.
//!
//! Error below 0.78 units in the last place for |x| <= 1e5 (measured on ten
//! million angles against double-double values, see the tests), and the
//! standard library's beyond.

mod lanes;
mod polynomial;
mod reduction;
#[cfg(test)]
mod tests;

use lanes::Lanes;
use polynomial::sin_cos_reduced;
use reduction::reduce;
use wide::{f64x2, f64x4, f64x8};

/// The largest magnitude that the vectorised reduction takes.
const LARGEST: f64 = 1e5;

/// Sine and cosine of every angle, rad.
///
/// Error below one unit in the last place. Not a number, and infinities, give NaN.
#[inline]
pub(crate) fn sin_cos_array<const K: usize>(angles: [f64; K]) -> [(f64, f64); K] {
    // NaN fails the comparison, as it must.
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

/// The kernel over the fewest vectors that hold the angles.
#[inline]
fn in_lanes<const K: usize>(angles: [f64; K]) -> [(f64, f64); K] {
    let mut values = [(0.0, 1.0); K];
    for (angles, values) in angles.chunks(8).zip(values.chunks_mut(8)) {
        match angles.len() {
            1 => values[0] = sin_cos(angles[0]),
            2 => {
                let (s, c) = sin_cos(f64x2::new(padded(angles)));
                unpack(s.to_array(), c.to_array(), values);
            }
            3 | 4 => {
                let (s, c) = sin_cos(f64x4::new(padded(angles)));
                unpack(s.to_array(), c.to_array(), values);
            }
            _ => {
                let (s, c) = sin_cos(f64x8::new(padded(angles)));
                unpack(s.to_array(), c.to_array(), values);
            }
        }
    }
    values
}

/// The angles, and zeros behind them.
#[inline(always)]
fn padded<const W: usize>(angles: &[f64]) -> [f64; W] {
    let mut lanes = [0.0; W];
    lanes[..angles.len()].copy_from_slice(angles);
    lanes
}

#[inline(always)]
fn unpack<const W: usize>(s: [f64; W], c: [f64; W], values: &mut [(f64, f64)]) {
    for (value, pair) in values.iter_mut().zip(s.into_iter().zip(c)) {
        *value = pair;
    }
}

/// Sine and cosine of angles of magnitude up to [`LARGEST`].
#[inline(always)]
fn sin_cos<L: Lanes>(x: L) -> (L, L) {
    let reduced = reduce(x);
    let (s, c) = sin_cos_reduced(reduced.high, reduced.low);
    let sign = L::splat(-0.0);
    // A quarter turn: (s, c) -> (c, -s).
    let sine = c.or_else(reduced.odd, s).xor(reduced.half_turn.and(sign));
    let cosine = s
        .or_else(reduced.odd, c)
        .xor(reduced.half_turn.xor(reduced.odd).and(sign));
    // Zero keeps its sign.
    (sine.or_else(x.differs(L::splat(0.0)), x), cosine)
}
