//! Angles that are found from sines and cosines, and frames by their angles.

use dynamics_codegen::geometry::{Matrix, Transform, Vector, polar_angle};
use dynamics_symbolic::exact::{Rational, square_root};
use dynamics_symbolic::robot::Value;

/// An angle: so many quarter turns, or rad.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Angle {
    Quarters(i8),
    Radians(Rational),
}

/// Whether a number of fifty digits is zero. Directions of small vectors have fewer digits: tables are compared to 28.
pub(super) fn is_zero(x: &Rational) -> bool {
    is_below(x, 30)
}

/// Whether a number is zero to so many places behind the point.
fn is_below(x: &Rational, places: isize) -> bool {
    let least = Rational::ONE / Rational::from(10).pow(places);
    *x < least && -x < least
}

impl Angle {
    pub(super) const ZERO: Angle = Angle::Quarters(0);

    /// The angle whose sine and cosine are those numbers, or in proportion to them.
    pub(super) fn atan2(sine: &Rational, cosine: &Rational) -> Angle {
        let is_positive = |x: &Rational| *x > Rational::ZERO;
        match (is_zero(sine), is_zero(cosine)) {
            (true, _) if is_positive(cosine) => Angle::ZERO,
            (true, _) => Angle::Quarters(2),
            (_, true) if is_positive(sine) => Angle::Quarters(1),
            (_, true) => Angle::Quarters(-1),
            _ => Angle::Radians(polar_angle(cosine, sine)),
        }
    }

    pub(super) fn is_zero(&self) -> bool {
        *self == Angle::ZERO
    }

    /// The quarter turns of an angle so near to them that every reader takes it for these, and the rest.
    pub(super) fn split(self) -> (Option<Angle>, Angle) {
        let Angle::Radians(angle) = &self else {
            return (None, self);
        };
        let count = (angle.to_f64().value() / core::f64::consts::FRAC_PI_2).round();
        let whole = Angle::Quarters(count as i8);
        let exact = dynamics_codegen::geometry::number(&whole.value());
        let rest = angle - exact.unwrap_or(Rational::ZERO);
        // Readers compare in doubles: what is a little further off is left apart as well.
        let is_near = is_below(&(&rest * Rational::from(9) / Rational::from(10)), 9);
        if count != 0.0 && is_near {
            (Some(whole), Angle::Radians(rest))
        } else {
            (None, self)
        }
    }

    /// The angle as a cell of a table.
    pub(super) fn value(&self) -> Value {
        match self {
            Angle::Quarters(count) => {
                let half = Rational::from_parts_signed((*count).into(), 2_u8.into());
                Value::Pi * Value::Rational(half)
            }
            Angle::Radians(angle) => Value::Rational(angle.clone()),
        }
    }
}

/// Roll, pitch and yaw of a rotation Rz(yaw) Ry(pitch) Rx(roll).
pub(super) fn roll_pitch_yaw(m: &Matrix) -> [Angle; 3] {
    let square = &m[0][0] * &m[0][0] + &m[1][0] * &m[1][0];
    let cosine = square_root(&square).unwrap_or(Rational::ZERO);
    let pitch = Angle::atan2(&-&m[2][0], &cosine);
    if is_zero(&cosine) {
        // Roll and yaw turn about one axis: yaw is zero.
        return [Angle::atan2(&-&m[1][2], &m[1][1]), pitch, Angle::ZERO];
    }
    [
        Angle::atan2(&m[2][1], &m[2][2]),
        pitch,
        Angle::atan2(&m[1][0], &m[0][0]),
    ]
}

/// A frame by xyz and rpy.
pub(super) type Origin = (Vector, [Angle; 3]);

/// A frame in as many places, each in the one before it, as it takes for angles to mean what they say.
pub(super) fn origins(frame: &Transform) -> Vec<Origin> {
    let [roll, pitch, yaw] = roll_pitch_yaw(&frame.rotation).map(Angle::split);
    let xyz = frame.origin.clone();
    if roll.0.is_none() && pitch.0.is_none() && yaw.0.is_none() {
        return vec![(xyz, [roll.1, pitch.1, yaw.1])];
    }
    // Rz(whole) Rz(rest) Ry(whole) Ry(rest) Rx(whole) Rx(rest), for Rz Ry Rx is one place.
    let whole = |(whole, _): &(Option<Angle>, Angle)| whole.clone().unwrap_or(Angle::ZERO);
    let (zero, nowhere) = (|| Angle::ZERO, || [Rational::ZERO; 3]);
    vec![
        (xyz, [zero(), zero(), whole(&yaw)]),
        (nowhere(), [zero(), whole(&pitch), yaw.1.clone()]),
        (nowhere(), [whole(&roll), pitch.1.clone(), zero()]),
        (nowhere(), [roll.1, zero(), zero()]),
    ]
}

/// Whether two frames are the same, except for digits that the feet of normals lose between axes that are
/// nearly parallel.
pub(super) fn is_same(one: &Transform, other: &Transform) -> bool {
    let [one, other] =
        [one, other].map(|frame| frame.rotation.iter().flatten().chain(&frame.origin));
    one.zip(other).all(|(a, b)| is_below(&(a - b), 28))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rotation(rpy: [Value; 3]) -> Transform {
        Transform::new(&[Rational::ZERO; 3], &rpy).expect("numbers")
    }

    #[test]
    fn roll_pitch_and_yaw_are_found_again() {
        let decimal = |x: i64| Value::Rational(Rational::from_parts(x.into(), 100_u8.into()));
        let quarter = |count: i8| Angle::Quarters(count).value();
        for rpy in [
            [decimal(30), decimal(-50), decimal(120)],
            [quarter(1), quarter(0), quarter(-1)],
            [quarter(2), decimal(1), quarter(2)],
            [decimal(70), quarter(1), decimal(20)],
            [decimal(70), quarter(-1), decimal(-310)],
        ] {
            let expected = rotation(rpy.clone());
            let found = roll_pitch_yaw(&expected.rotation).map(|angle| angle.value());
            assert!(is_same(&rotation(found), &expected), "{rpy:?}");
        }
    }
}
