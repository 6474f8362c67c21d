//! Sine and cosine on [-pi/4, pi/4] by minimax polynomials.

use crate::sine::lanes::{self, Lanes};

/// sin x = x - x^3 (S[0] + S[1] x^2 + ...), relative error 4.1e-9.
const S: [f32; 3] = [0.166_666_55, -0.008_332_187, 0.000_195_178_97];

/// cos x = 1 - x^2/2 + x^4 (C[0] + C[1] x^2 + ...), error 1.1e-10.
const C: [f32; 3] = [0.041_666_646, -0.001_388_730_1, 2.443_067e-5];

/// Sine and cosine of x - d, where d is below the last place of x, or both are tiny.
#[inline(always)]
pub(super) fn sin_cos_reduced<L: Lanes<Number = f32>>(x: L, d: L) -> (L, L) {
    if L::OF_A_BATCH {
        return lanes::by_fewest_operations(x, d, S, C);
    }
    let k = |constant: f32| x.constant(constant);
    let z = x * x;
    // cos x = w + (1 - w - z/2) + ...: what 1 - z/2 loses is made good.
    let half_z = k(0.5) * z;
    let w = k(1.0) - half_z;
    let lost = (k(1.0) - w) - half_z;
    // sin (x - d) = x - (x^3 S0 + x^5 (S1 + ...) + d (1 - x^2/2))
    let cube = x * z;
    let sine = x - ((cube * k(S[0]) + d * w) + (z * cube) * (k(S[1]) + z * k(S[2])));
    // cos (x - d) = 1 - x^2/2 + x^4 (C0 + ...) + x d, where what waits longest is added last.
    let zz = z * z;
    let lower = zz * (k(C[0]) + z * k(C[1])) + (lost + x * d);
    let cosine = w + (lower + (zz * zz) * k(C[2]));
    (sine, cosine)
}

/// The sine of x - d alone, in as few operations as it takes.
#[cfg(feature = "std")]
#[inline(always)]
pub(super) fn sine_reduced<L: Lanes<Number = f32>>(x: L, d: L) -> L {
    lanes::sine_by_fewest(x, d, x * x, S)
}
