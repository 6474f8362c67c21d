//! Sine and cosine.

use core::f64::consts::FRAC_PI_2;

use super::DoubleDouble;

/// pi/2 in four doubles: 212 bits.
const HALF_PI: [f64; 4] = [
    FRAC_PI_2,
    6.123233995736766e-17,
    -1.4973849048591698e-33,
    5.562271104316826e-50,
];

/// Up to here a double holds the number of quarter turns, whose products with parts of pi/2 leave less than 1e-44.
const LARGEST: f64 = 7e15;

/// Sine and cosine, rad: an angle in [-pi/4, pi/4] and a number of quarter turns.
pub(super) fn sin_cos(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    if x.high.is_nan() || x.high.abs() > LARGEST {
        let nan = DoubleDouble::from(f64::NAN);
        return (nan, nan);
    }
    let n = libm::round(x.high / FRAC_PI_2);
    let rest = reduced(x, n);
    let square = rest * rest;
    let (s, c) = (rest * series(square, 1.0), series(square, 0.0));
    match (n as i64).rem_euclid(4) {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// x - n pi/2. The products are exact, and so is the first difference.
fn reduced(x: DoubleDouble, n: f64) -> DoubleDouble {
    let [first, second, third, fourth] = HALF_PI.map(|part| DoubleDouble::product(-n, part));
    let lead = DoubleDouble::sum(x.high, first.high);
    let inner = DoubleDouble::sum(lead.low, first.low) + DoubleDouble::from(x.low);
    DoubleDouble::from(lead.high) + (inner + second + third + fourth)
}

/// 1 - z/((k+1)(k+2)) (1 - z/((k+3)(k+4)) (1 - ...)), of which sin x / x is the case k = 1, cos x
/// the case k = 0, with z = x^2: for z below 0.62 the first term left out is below 1e-37.
///
/// The weight of the inner brackets in the sum is below 3e-18: doubles are enough for them.
fn series(z: DoubleDouble, k: f64) -> DoubleDouble {
    let divisor = |i: i32| (k + f64::from(2 * i + 1)) * (k + f64::from(2 * i + 2));
    let inner = (9..16)
        .rev()
        .fold(1.0, |inner, i| 1.0 - z.high() * inner / divisor(i));
    let one = DoubleDouble::from(1.0);
    (0..9).rev().fold(DoubleDouble::from(inner), |inner, i| {
        one - (z * inner).over(divisor(i))
    })
}
