//! Sines in doubles, the same on every platform.

use core::f64::consts::FRAC_PI_2;

/// Sine and cosine by Taylor's series, to a few units in the last place for angles of some turns. The
/// host's own differ between platforms; these operations are rounded alike everywhere.
pub fn sin_cos(angle: f64) -> (f64, f64) {
    let quarters = (angle / FRAC_PI_2).round();
    let x = angle - quarters * FRAC_PI_2;
    let (mut s, mut c) = (0.0, 0.0);
    // x^k / k!, the small ones first.
    for k in (0..10).rev() {
        let (even, odd) = ((2 * k) as f64, (2 * k + 1) as f64);
        c = 1.0 - c * x * x / ((even + 1.0) * (even + 2.0));
        s = 1.0 - s * x * x / ((odd + 1.0) * (odd + 2.0));
    }
    let s = s * x;
    match quarters.rem_euclid(4.0) {
        1.0 => (c, -s),
        2.0 => (-s, -c),
        3.0 => (-c, s),
        _ => (s, c),
    }
}

/// How far [`sin_cos`] may be from the true values, over 1 and the size of the angle in radians:
/// about ten times the rounding of its last operations and of the angle that is left of whole
/// quarters.
pub const SINE_ERROR: f64 = 4e-15;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_are_those_of_the_host() {
        for k in -70..70 {
            let angle = 0.17 * k as f64;
            let (s, c) = sin_cos(angle);
            assert!((s - angle.sin()).abs() < 1e-15 && (c - angle.cos()).abs() < 1e-15);
        }
    }
}
