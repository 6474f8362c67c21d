//! Sines in single precision, without an operation in another.
//!
//! Error below 0.81 units in the last place for |x| <= 1e4 (measured, see the
//! tests) and beyond, where the reduction is exact, in integers; in the lanes of batches below 0.85 units.

mod integers;
#[cfg(test)]
mod tests;

#[cfg(feature = "std")]
use super::lanes::sine_by_fewest;
use super::lanes::{Kernel, Lanes, Reduced, by_fewest_operations};

/// pi/2 = P1 + P2 + P3 + P4: three parts of 8, 11 and 11 bits, whose products with whole numbers up to
/// 2^13 are exact, and the rest, rounded.
const P1: f32 = 1.570_312_5;
const P2: f32 = 0.000_483_751_3;
const P3: f32 = 7.549_533_6e-8;
const P4: f32 = 2.563_344e-12;

/// 1.5 2^23: added, it rounds to a whole number, whose lowest bits are then the lowest of the sum's.
const ROUND: f32 = 12_582_912.0;

/// sin x = x - x^3 (S[0] + S[1] x^2 + ...), a minimax polynomial on [-pi/4, pi/4] of relative error 4.1e-9.
const S: [f32; 3] = [0.166_666_55, -0.008_332_187, 0.000_195_178_97];

/// cos x = 1 - x^2/2 + x^4 (C[0] + C[1] x^2 + ...), a minimax polynomial there of error 1.1e-10.
const C: [f32; 3] = [0.041_666_646, -0.001_388_730_1, 2.443_067e-5];

impl Kernel for f32 {
    const HALF: Self = 0.5;
    const ONE: Self = 1.0;
    const LARGEST: f32 = 1e4;

    /// Cody and Waite 1980. n P1, n P2 and n P3 are exact. So are x - n P1 and the rest after n P2: multiples of the last
    /// place of x or of 2^-22, whichever is smaller, and small enough for 24 bits.
    #[inline(always)]
    fn reduce<L: Lanes<Number = f32>>(x: L) -> Reduced<L> {
        let k = |constant: f32| x.constant(constant);
        let shifted = x.product_plus(k(core::f32::consts::FRAC_2_PI), k(ROUND));
        let n = shifted - k(ROUND);
        let first = n.product_from(k(P1), x);
        let second = n.product_from(k(P2), first);
        let third = n * k(P3);
        let rest = second - third;
        // The rounding error of second - n P3 (Dekker 1971), its sign turned. It wants |second| >= |n P3|; where
        // that fails both are below 2^-10 and multiples of 2^-34, and there is no rounding.
        let minus_error = (rest - second) + third;
        Reduced {
            n: shifted,
            rest,
            excess: n.product_plus(k(P4), minus_error),
        }
    }

    #[inline(always)]
    fn sin_cos_reduced<L: Lanes<Number = f32>>(x: L, d: L) -> (L, L) {
        if L::OF_A_BATCH {
            return by_fewest_operations(x, d, S, C);
        }
        let k = |constant: f32| x.constant(constant);
        let z = x * x;
        // cos x = w + (1 - w - z/2) + ...: the rounding of w = 1 - z/2 is made good.
        let half_z = k(0.5) * z;
        let w = k(1.0) - half_z;
        let lost = (k(1.0) - w) - half_z;
        // sin (x - d) = x - (x^3 S0 + x^5 (S1 + ...) + d (1 - x^2/2))
        let cube = x * z;
        let sine = x - ((cube * k(S[0]) + d * w) + (z * cube) * (k(S[1]) + z * k(S[2])));
        // cos (x - d) = 1 - x^2/2 + x^4 (C0 + ...) + x d, where the term that waits longest is added last.
        let zz = z * z;
        let lower = zz * (k(C[0]) + z * k(C[1])) + (lost + x * d);
        let cosine = w + (lower + (zz * zz) * k(C[2]));
        (sine, cosine)
    }

    #[cfg(feature = "std")]
    #[inline(always)]
    fn sine_reduced<L: Lanes<Number = f32>>(x: L, d: L) -> L {
        sine_by_fewest(x, d, x * x, S)
    }

    fn sin_cos_of_large(self) -> (f32, f32) {
        if !self.is_finite() {
            return (f32::NAN, f32::NAN);
        }
        let (sine, cosine) = super::of_reduced(integers::reduce(self.abs()));
        (if self < 0.0 { -sine } else { sine }, cosine)
    }
}
