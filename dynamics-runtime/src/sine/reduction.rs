//! Reduction of an angle to [-pi/4, pi/4] (Cody and Waite 1980).

/// pi/2 = P1 + P2 + P3 + P4: three parts of 33 bits, whose products with
/// whole numbers up to 2^20 are exact, and the rest.
const P1: f64 = 1.5707963267341256;
const P2: f64 = 6.077100506303966e-11;
const P3: f64 = 2.0222662487111665e-21;
const P4: f64 = 8.4784276603689e-32;

/// Adding it rounds to a whole number, which then stands in the last bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// x = quarters pi/2 + high + low, |high| at most a little above pi/4.
pub(super) struct Reduced {
    /// Whole quarter turns; the last two bits count.
    pub(super) quarters: u64,
    /// The rest.
    pub(super) high: f64,
    /// What `high` leaves out.
    pub(super) low: f64,
}

/// Reduces an angle of magnitude up to 1e5.
///
/// The products n P1, n P2 and n P3 are exact, and so is x - n P1: both are
/// multiples of one unit and close to each other. The nearest that such an
/// angle comes to a multiple of pi/2 is above 2^-62; what is left out is below 2^-135.
#[inline(always)]
pub(super) fn reduce(x: f64) -> Reduced {
    let shifted = x * core::f64::consts::FRAC_2_PI + ROUND;
    let n = shifted - ROUND;
    let (second, e2) = difference(x - n * P1, n * P2);
    let (third, e3) = difference(second, n * P3);
    let rest = (e2 + e3) - n * P4;
    let high = third + rest;
    let low = (third - high) + rest;
    Reduced {
        quarters: shifted.to_bits(),
        high,
        low,
    }
}

/// a - b and its rounding error (Knuth 1969).
#[inline(always)]
fn difference(a: f64, b: f64) -> (f64, f64) {
    let difference = a - b;
    let part = difference - a;
    (difference, (a - (difference - part)) - (b + part))
}
