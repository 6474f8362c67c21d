//! Sine and cosine on [-pi/4, pi/4] by minimax polynomials.

use crate::sine::lanes::{self, Lanes};

/// sin x = x - x^3 (S[0] + S[1] x^2 + ...), relative error 3.5e-18.
pub(super) const S: [f64; 6] = [
    0.16666666666666632,
    -0.008333333333322413,
    0.00019841269829807778,
    -2.755731369191555e-06,
    2.505075811569819e-08,
    -1.5896795713489563e-10,
];

/// cos x = 1 - x^2/2 + x^4 (C[0] + C[1] x^2 + ...), error 5e-20.
pub(super) const C: [f64; 6] = [
    0.0416666666666666,
    -0.0013888888888874125,
    2.480158728948234e-05,
    -2.7557314352372173e-07,
    2.0875723278132235e-09,
    -1.1359648042271599e-11,
];

/// Sine and cosine of x - d, where d is below the last place of x, or both are tiny.
///
/// A single call waits for its longest chain of operations, not for their number: the polynomials
/// are split in parts that are evaluated side by side (Estrin 1960).
#[inline(always)]
pub(super) fn sin_cos_reduced<L: Lanes<Number = f64>>(x: L, d: L) -> (L, L) {
    if L::OF_A_BATCH {
        return lanes::by_fewest_operations(x, d, S, C);
    }
    let k = |constant: f64| x.constant(constant);
    let z = x * x;
    let (cube, zz) = (x * z, z * z);
    let fifth = z * cube;
    // cos x = w + (1 - w - z/2) + ...: what 1 - z/2 loses is made good.
    let half_z = k(0.5) * z;
    let w = k(1.0) - half_z;
    let lost = (k(1.0) - w) - half_z;
    // sin (x - d) = x - (x^3 S0 + x^5 (S1 + ...) + d (1 - x^2/2))
    let upper = (k(S[3]) + z * k(S[4])) + zz * k(S[5]);
    let lower = fifth * (k(S[1]) + z * k(S[2])) + d * w;
    let sine = x - (cube * k(S[0]) + (lower + (zz * fifth) * upper));
    // cos (x - d) = 1 - x^2/2 + x^4 (C0 + ...) + x d
    let upper = (k(C[2]) + z * k(C[3])) + zz * (k(C[4]) + z * k(C[5]));
    let lower = zz * (k(C[0]) + z * k(C[1])) + x * d;
    let cosine = w + ((lost + lower) + (zz * zz) * upper);
    (sine, cosine)
}

/// The sine of x - d alone, in as few operations as it takes.
#[cfg(feature = "std")]
#[inline(always)]
pub(super) fn sine_reduced<L: Lanes<Number = f64>>(x: L, d: L) -> L {
    lanes::sine_by_fewest(x, d, x * x, S)
}
