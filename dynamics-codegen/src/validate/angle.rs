//! Angles that were hardly meant: degrees, and right angles in a few decimals.
//!
//! An angle that is a number is judged, wherever it comes from: a cell, a `let`, `deg(x)`. One that is computed from
//! several numbers is taken as it stands, because nobody writes `PI/2 + 0.003` by mistake, unless it is a decimal near a
//! right angle: `3.1416/2`. So is one that depends on a field.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::mistake::{Mistake, joint as mistake};
use dynamics_symbolic::robot::Value;

/// Below it an angle is a multiple of a right one: the engine takes it as that.
const EXACT: f64 = 1e-9;

/// Below it an angle is nearly a multiple of a right one: `1.57` is off by 8e-4.
///
/// Zero is no such multiple. It is never rounded, and small angles are what a calibration finds
/// between axes that were meant to be parallel.
const NEAR: f64 = 1e-2;

/// From here on a whole number is an angle in degrees. Angles between half a turn and a whole one are measured, and have
/// decimals: 3.5 rad. Nobody measures 5 rad, but 5 degrees are a usual offset.
const WHOLE: f64 = 4.0;

/// An angle that was hardly meant.
#[derive(Clone)]
pub(super) enum Odd {
    /// Within [`NEAR`] of that many right angles, which are written so.
    NearlyRight(&'static str),
    /// A decimal that was meant in degrees: more than a turn, or a whole number.
    InDegrees(f64),
    /// Another angle of more than a turn, rad.
    ManyTurns(f64),
}

/// The oddity of an angle; `is_computed` says whether several values were put together in it.
pub(super) fn odd(angle: &Value, is_computed: bool) -> Option<Odd> {
    if !angle.is_number() {
        return None;
    }
    let radians = angle.to_f64(&[]);
    let is_decimal = angle.as_rational().is_some();
    if (is_decimal || !is_computed)
        && let Some((right, distance)) = right_angle(radians)
        && distance > EXACT
    {
        return Some(Odd::NearlyRight(right));
    }
    let is_long = radians.abs() > TAU + EXACT;
    if is_computed {
        None
    } else if is_decimal && (is_long || is_in_whole_degrees(radians)) {
        Some(Odd::InDegrees(radians))
    } else {
        is_long.then_some(Odd::ManyTurns(radians))
    }
}

/// Whether a decimal is whole, and too large for an angle in rad.
pub(crate) fn is_in_whole_degrees(decimal: f64) -> bool {
    decimal.fract() == 0.0 && decimal.abs() >= WHOLE
}

/// The multiple of a right angle that is near, up to a turn, as it is written, and how far it is.
fn right_angle(radians: f64) -> Option<(&'static str, f64)> {
    const WRITTEN: [(f64, &str); 8] = [
        (1.0, "PI/2"),
        (2.0, "PI"),
        (3.0, "3*PI/2"),
        (4.0, "2*PI"),
        (-1.0, "-PI/2"),
        (-2.0, "-PI"),
        (-3.0, "-3*PI/2"),
        (-4.0, "-2*PI"),
    ];
    let distance = |quarters: f64| (radians - quarters * FRAC_PI_2).abs();
    let mut multiples = WRITTEN.into_iter();
    multiples.find_map(|(quarters, written)| {
        let distance = distance(quarters);
        (distance < NEAR).then_some((written, distance))
    })
}

impl Odd {
    /// The mistake of it; `place` is where it can be allowed.
    pub(super) fn mistake(&self, place: &str) -> Mistake {
        match *self {
            Odd::NearlyRight(right) => mistake::nearly_right(right, place),
            Odd::InDegrees(radians) => mistake::angle_in_degrees(radians, place),
            Odd::ManyTurns(radians) => mistake::more_than_a_turn(radians, place),
        }
    }
}

/// The mistake of `deg(angle)`, if the angle was in radians already; `place` is where it can be allowed.
pub(super) fn degrees_of_radians(angle: &Value, place: &str) -> Option<Mistake> {
    match angle {
        value if !value.is_number() => None,
        Value::Rational(number) => right_angle(number.to_f64().value())
            .map(|(right, _)| mistake::degrees_of_right_angle(right, place)),
        value => has_pi(value).then(|| mistake::degrees_of_pi(place)),
    }
}

fn has_pi(value: &Value) -> bool {
    match value {
        Value::Pi => true,
        Value::Rational(_) | Value::Field(_) => false,
        Value::Neg(a) => has_pi(a),
        Value::Add(a, b) | Value::Mul(a, b) | Value::Div(a, b) => has_pi(a) || has_pi(b),
    }
}

#[cfg(test)]
mod tests {
    use super::right_angle;

    #[test]
    fn right_angles_are_told_from_others() {
        let near = |radians: f64| right_angle(radians).map(|(written, _)| written);
        assert_eq!(near(1.57), Some("PI/2"));
        assert_eq!(near(-3.15), Some("-PI"));
        assert_eq!(near(4.71), Some("3*PI/2"));
        assert_eq!(near(-6.29), Some("-2*PI"));
        for other in [0.0, 0.001, -0.009, 1.55, 1.59, 7.854, 11.0] {
            assert_eq!(near(other), None, "{other}");
        }
    }
}
