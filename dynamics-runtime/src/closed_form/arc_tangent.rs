//! The arc tangent of a number below 7/16 by a polynomial.

/// Coefficients of the odd polynomial z + z^3 P(z^2), which is the arc tangent for |z| <= 7/16 with a relative error below 2^-57:
/// those of FreeBSD's `s_atan.c` (Sun Microsystems 1993), from the highest power downwards.
const ARC_TANGENT: [f64; 11] = [
    1.628_582_011_536_578_2e-2,
    -3.653_157_274_421_691_6e-2,
    4.976_877_994_615_932_4e-2,
    -5.833_570_133_790_573_5e-2,
    6.661_073_137_387_531e-2,
    -7.691_876_205_044_83e-2,
    9.090_887_133_436_507e-2,
    -1.111_111_040_546_235_6e-1,
    1.428_571_427_250_346_6e-1,
    -1.999_999_999_987_648_3e-1,
    3.333_333_333_333_293e-1,
];

/// The same in single precision, for |z| <= tan(pi/8) with a relative error below 3e-8: minimax, by Remez's algorithm.
const SINGLE_ARC_TANGENT: [f32; 4] = [-0.080_537_21, 0.138_776_78, -0.199_777_1, 0.333_329_5];

/// -P(z^2) of a z whose square is given, in double precision.
#[inline(always)]
pub(super) fn arc_tangent(square: f64) -> f64 {
    // Even and odd powers, one beside the other.
    let fourth = square * square;
    let [mut even, mut odd] = [ARC_TANGENT[0], ARC_TANGENT[1]];
    for k in 1..5 {
        even = even * fourth + ARC_TANGENT[2 * k];
        odd = odd * fourth + ARC_TANGENT[2 * k + 1];
    }
    even * fourth + ARC_TANGENT[10] + odd * square
}

/// The same in single precision.
#[inline(always)]
pub(super) fn single_arc_tangent(square: f32) -> f32 {
    let [a, b, c, d] = SINGLE_ARC_TANGENT;
    ((a * square + b) * square + c) * square + d
}
