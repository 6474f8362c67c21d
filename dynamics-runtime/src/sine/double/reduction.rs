//! Reduction of an angle to [-pi/4, pi/4] (Cody and Waite 1980).

use crate::sine::lanes::{Lanes, Reduced};

/// pi/2 = P1 + P2 + P3: two parts of 36 bits, whose products with whole numbers up to 2^17 are
/// exact, and the rest, rounded.
const P1: f64 = 1.5707963267923333;
const P2: f64 = 2.5633441515839558e-12;
const P3: f64 = 1.0562999066987428e-23;

/// 1.5 2^52: added, it rounds to a whole number, whose lowest bits are then the lowest of the sum's.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Reduces an angle of magnitude up to 1e5.
///
/// n P1 and n P2 are exact, and so is x - n P1: both are multiples of one unit, and close to each
/// other. The nearest that such an angle comes to a multiple of pi/2 is above 2^-62; what is left
/// out is below 2^-110.
#[inline(always)]
pub(super) fn reduce<L: Lanes<Number = f64>>(x: L) -> Reduced<L> {
    let k = |constant: f64| x.constant(constant);
    let shifted = x.product_plus(k(core::f64::consts::FRAC_2_PI), k(ROUND));
    let n = shifted - k(ROUND);
    let first = n.product_from(k(P1), x);
    let second = n * k(P2);
    let rest = first - second;
    // The rounding error of first - n P2 (Dekker 1971), its sign turned. It wants |first| >= |n P2|; where
    // that fails both are below 2^-22 and multiples of 2^-75, and there is no rounding.
    let minus_error = (rest - first) + second;
    Reduced {
        n: shifted,
        rest,
        excess: n.product_plus(k(P3), minus_error),
    }
}
