//! Sine and cosine on [-pi/4, pi/4] by minimax polynomials.

use super::lanes::Lanes;

/// sin x = x + x^3 (S[0] + S[1] x^2 + ...), relative error 3.5e-18.
const S: [f64; 6] = [
    -0.16666666666666632,
    0.008333333333322413,
    -0.00019841269829807778,
    2.755731369191555e-06,
    -2.505075811569819e-08,
    1.5896795713489563e-10,
];

/// cos x = 1 - x^2/2 + x^4 (C[0] + C[1] x^2 + ...), error 5e-20.
const C: [f64; 6] = [
    0.0416666666666666,
    -0.0013888888888874125,
    2.480158728948234e-05,
    -2.7557314352372173e-07,
    2.0875723278132235e-09,
    -1.1359648042271599e-11,
];

/// Sine and cosine of x + e, where e is below the last place of x.
#[inline(always)]
pub(super) fn sin_cos_reduced<L: Lanes>(x: L, e: L) -> (L, L) {
    let (half, one) = (L::splat(0.5), L::splat(1.0));
    let z = x * x;
    let cube = z * x;
    // sin (x + e) = x + (x^3 S0 + (x^5 S1 + ... + e (1 - x^2/2)))
    let sine = x - ((z * (half * e - cube * horner(z, &S[1..])) - e) - cube * L::splat(S[0]));
    // cos (x + e) = 1 - x^2/2 + (x^4 (C0 + ...) - x e); w loses 1 - w - x^2/2.
    let half_z = half * z;
    let w = one - half_z;
    let cosine = w + (((one - w) - half_z) + (z * z * horner(z, &C) - x * e));
    (sine, cosine)
}

/// k0 + z (k1 + z (k2 + ...))
#[inline(always)]
fn horner<L: Lanes>(z: L, coefficients: &[f64]) -> L {
    let (last, others) = coefficients
        .split_last()
        .expect("a polynomial has coefficients");
    others
        .iter()
        .rev()
        .fold(L::splat(*last), |sum, &k| L::splat(k) + z * sum)
}
