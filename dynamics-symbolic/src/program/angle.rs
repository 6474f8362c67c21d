//! Constant angles as doubles.

use super::Approximation;
use super::constant::until_certain;
use crate::robot::{Angle, Value};
use core::f64::consts::{FRAC_PI_2, TAU};

/// The double that means a constant angle: correctly rounded, or a multiple of a quarter turn if the engine takes it for
/// one. Whole turns are taken off angles beyond a turn: a double of 1e6 rad is known to 1e-10 rad, but the engine's
/// sines are those of the exact angle.
pub fn rounded_angle(angle: &Value) -> f64 {
    let written = rounded(angle, false);
    let is_within_a_turn = written.abs() <= TAU;
    let parts = Angle::new(angle);
    match (parts.rest.is_none(), is_within_a_turn) {
        (true, true) => (written / FRAC_PI_2).round() * FRAC_PI_2,
        (true, false) => f64::from(parts.signed_quarter_turns()) * FRAC_PI_2,
        (false, true) => written,
        (false, false) => rounded(angle, true),
    }
}

/// The correct rounding; infinite where the angle is beyond what the engine's sines take.
fn rounded(angle: &Value, less_turns: bool) -> f64 {
    until_certain(|real, is_last| {
        let value = if less_turns {
            real.less_turns(angle)
        } else {
            real.angle(angle)
        };
        Approximation::rounded(&value, is_last)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use core::f64::consts::{FRAC_PI_4, PI};

    fn rational(numerator: i64, denominator: u64) -> Value {
        Value::Rational(Rational::from_parts(numerator.into(), denominator.into()))
    }

    /// n pi / d
    fn of_pi(n: i64, d: u64) -> Value {
        rational(n, d) * Value::Pi
    }

    #[test]
    fn angles_within_a_turn_are_as_written() {
        for (angle, expected) in [
            (Value::zero(), 0.0),
            (rational(3, 10), 0.3),
            (rational(-6, 1), -6.0),
            (of_pi(45, 180), FRAC_PI_4),
            (of_pi(3, 2), 3.0 * FRAC_PI_2),
            (of_pi(-1, 1), -PI),
            (rational(-15_707_963_268, 10_000_000_000), -FRAC_PI_2),
            (rational(15_707_963, 10_000_000), 15_707_963.0 / 1e7),
        ] {
            assert_eq!(rounded_angle(&angle), expected, "{angle:?}");
        }
    }

    /// 10000001 = 14 * 714285 + 11: 11 pi/7 and 714285 turns.
    #[test]
    fn whole_turns_are_taken_off_before_rounding() {
        let less = rounded_angle(&of_pi(10_000_001, 7));
        assert!((less - (11.0 / 7.0 - 2.0) * PI).abs() < 1e-15, "{less}");
        let difference = of_pi(10_000_001, 7) - of_pi(10_000_000, 7);
        assert_eq!(rounded_angle(&difference), PI / 7.0);
        assert_eq!(
            rounded_angle(&of_pi(4_000_000_000_000_000_001, 2)),
            FRAC_PI_2
        );
        assert_eq!(
            rounded_angle(&of_pi(-4_000_000_000_000_000_001, 2)),
            -FRAC_PI_2
        );
        let radians = rounded_angle(&rational(10_000_001, 10));
        assert!((radians.sin() - 1_000_000.1_f64.sin()).abs() < 1e-10);
        assert!(radians.abs() <= PI);
    }

    /// sin(10^22), a classic of argument reduction.
    #[test]
    fn huge_angles() {
        let far = Value::Rational(Rational::from(10).pow(22));
        let sine = rounded_angle(&far).sin();
        assert!((sine + 0.852_200_849_767_188_8).abs() < 1e-15, "{sine}");
    }
}
