//! Reduction of an angle to [-pi/4, pi/4] (Cody and Waite 1980).

use crate::sine::lanes::{Lanes, Reduced};

/// pi/2 = P1 + P2 + P3 + P4: three parts of 8, 11 and 11 bits, whose products with whole numbers up to
/// 2^13 are exact, and the rest, rounded.
const P1: f32 = 1.570_312_5;
const P2: f32 = 0.000_483_751_3;
const P3: f32 = 7.549_533_6e-8;
const P4: f32 = 2.563_344e-12;

/// 1.5 2^23: added, it rounds to a whole number, whose lowest bits are then the lowest of the sum's.
const ROUND: f32 = 12_582_912.0;

/// Reduces an angle of magnitude up to 1e4.
///
/// n P1, n P2 and n P3 are exact. So are x - n P1 and what is left after n P2: multiples of the last place of
/// x or of 2^-22, whichever is smaller, and small enough for 24 bits.
#[inline(always)]
pub(super) fn reduce<L: Lanes<Number = f32>>(x: L) -> Reduced<L> {
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
