//! Reduction of an angle to [-pi/4, pi/4] (Cody and Waite 1980).

use super::lanes::Lanes;

/// pi/2 = P1 + P2 + P3 + P4: three parts of 33 bits, whose products with
/// whole numbers up to 2^20 are exact, and the rest.
const P1: f64 = 1.5707963267341256;
const P2: f64 = 6.077100506303966e-11;
const P3: f64 = 2.0222662487111665e-21;
const P4: f64 = 8.4784276603689e-32;

/// 1.5 2^52: added and subtracted again, it rounds to a whole number.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// x = n pi/2 + high + low, |high| at most a little above pi/4.
pub(super) struct Reduced<L> {
    /// A mask: n is odd.
    pub(super) odd: L,
    /// A mask: n is 2 or 3 modulo 4.
    pub(super) half_turn: L,
    /// The rest.
    pub(super) high: L,
    /// What `high` leaves out.
    pub(super) low: L,
}

/// Reduces an angle of magnitude up to 1e5.
///
/// The products n P1, n P2 and n P3 are exact, and so is x - n P1: both are
/// multiples of one unit and close to each other. The nearest that such an
/// angle comes to a multiple of pi/2 is above 2^-62; what is left out is below 2^-135.
#[inline(always)]
pub(super) fn reduce<L: Lanes>(x: L) -> Reduced<L> {
    let n = round(x * L::splat(core::f64::consts::FRAC_2_PI));
    let (second, e2) = difference(x - n * L::splat(P1), n * L::splat(P2));
    let (third, e3) = difference(second, n * L::splat(P3));
    let rest = (e2 + e3) - n * L::splat(P4);
    let high = third + rest;
    let low = (third - high) + rest;
    // n = 2 m + (1 if odd), and m = 2 l + (1 if half a turn).
    let half = L::splat(0.5);
    let n_half = n * half;
    let odd = n_half.differs(round(n_half));
    let m_half = (n_half - half.and(odd)) * half;
    let half_turn = m_half.differs(round(m_half));
    Reduced {
        odd,
        half_turn,
        high,
        low,
    }
}

/// The nearest whole number.
#[inline(always)]
fn round<L: Lanes>(x: L) -> L {
    (x + L::splat(ROUND)) - L::splat(ROUND)
}

/// a - b and its rounding error (Knuth 1969).
#[inline(always)]
fn difference<L: Lanes>(a: L, b: L) -> (L, L) {
    let difference = a - b;
    let part = difference - a;
    (difference, (a - (difference - part)) - (b + part))
}
