//! Numbers: exact where they are rational, in fifty digits where they are not.

use dynamics_symbolic::exact::{self, Rational, bit_length};
use dynamics_symbolic::robot::{Angle, Value};

/// pi in 60 digits.
const PI: &str = "314159265358979323846264338327950288419716939937510582097494/\
                  100000000000000000000000000000000000000000000000000000000000";

/// Digits behind the point of what is rounded.
const DIGITS: usize = 50;

/// Bits beyond which a number that was put together of others is rounded.
const MOST_BITS: usize = 600;

/// The number in 50 digits behind the point.
fn rounded(x: &Rational) -> Rational {
    let scale = Rational::from(10).pow(DIGITS as isize);
    Rational::from((x * &scale).round()) / scale
}

/// The number itself where it is short, in 50 digits behind the point where it has more than 600 bits.
pub fn tidy(x: Rational) -> Rational {
    if bit_length(&x) > MOST_BITS {
        rounded(&x)
    } else {
        x
    }
}

/// The number itself, in 50 digits behind the point where it is longer than the engine's may get: of many frames in
/// each other, and of many bodies at one link.
pub(super) fn bounded(x: Rational) -> Rational {
    if bit_length(&x) > exact::MOST_BITS {
        rounded(&x)
    } else {
        x
    }
}

/// A constant in 60 digits; none where it is no number.
pub fn number(value: &Value) -> Option<Rational> {
    Some(match value {
        Value::Rational(x) => x.clone(),
        Value::Pi => PI.parse().ok()?,
        Value::Field(_) => return None,
        Value::Neg(a) => -number(a)?,
        Value::Add(a, b) => number(a)? + number(b)?,
        Value::Mul(a, b) => number(a)? * number(b)?,
        Value::Div(a, b) => {
            let b = number(b)?;
            if b.is_zero() {
                return None;
            } else {
                number(a)? / b
            }
        }
    })
}

/// Sine and cosine of a constant angle: exact of quarter turns, else in 50 digits.
pub fn sin_cos(angle: &Value) -> Option<[Rational; 2]> {
    let angle = Angle::new(angle);
    let [s, c] = match &angle.rest {
        None => [Rational::ZERO, Rational::ONE],
        Some(rest) => series(&number(rest)?),
    };
    Some(match angle.quarter_turns {
        0 => [s, c],
        1 => [c, -s],
        2 => [-s, -c],
        _ => [-c, s],
    })
}

/// The series of sine and cosine.
fn series(x: &Rational) -> [Rational; 2] {
    // Less a multiple of 2 pi: the terms of a large angle are large.
    let turn: Rational = Rational::from(2) * PI.parse::<Rational>().unwrap_or(Rational::ONE);
    let x = x - Rational::from((x / &turn).round()) * turn;
    let mut sums = [Rational::ZERO, Rational::ZERO];
    let mut term = Rational::ONE;
    let mut n: usize = 0;
    while !term.is_zero() {
        // 1, x, -x^2/2, -x^3/6, x^4/24, ...
        let sum = &mut sums[1 - n % 2];
        match n % 4 {
            0 | 1 => *sum += &term,
            _ => *sum -= &term,
        }
        n += 1;
        term = rounded(&(&term * &x / Rational::from(n)));
    }
    sums
}

/// The azimuth and the polar angle of a direction, Rz(azimuth) Ry(polar) z: exact along an axis, else in 50
/// digits. None of a vector of length zero.
pub fn direction(v: &[Rational; 3]) -> Option<[Value; 2]> {
    let quarter = |count: i64| {
        let half = Rational::from_parts_signed(count.into(), 2_u8.into());
        Value::Pi * Value::Rational(half)
    };
    let sign = |x: &Rational| if *x < Rational::ZERO { -1 } else { 1 };
    let [x, y, z] = v;
    Some(match (x.is_zero(), y.is_zero(), z.is_zero()) {
        (true, true, true) => return None,
        (true, true, false) => [quarter(0), quarter(1 - sign(z))],
        (false, true, true) => [quarter(0), quarter(sign(x))],
        (true, false, true) => [quarter(1), quarter(sign(y))],
        _ => {
            let azimuth = polar_angle(x, y);
            let [s, c] = series(&azimuth);
            // Along the azimuth the direction has x cos + y sin and z.
            let polar = polar_angle(z, &(x * c + y * s));
            [Value::Rational(azimuth), Value::Rational(polar)]
        }
    })
}

/// atan2(y, x), in 50 digits: in double precision, then by atan t = t - t^3/3 of what is left, about 1e-16.
pub fn polar_angle(x: &Rational, y: &Rational) -> Rational {
    let first = y.to_f64().value().atan2(x.to_f64().value());
    let first = Rational::try_from(first).unwrap_or(Rational::ZERO);
    let [s, c] = series(&first);
    let along = x * &c + y * &s;
    if along.is_zero() {
        return first;
    }
    let t = rounded(&((y * c - x * s) / along));
    let cube = &t * &t * &t / Rational::from(3);
    rounded(&(first + t - cube))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decimal(text: &str) -> Rational {
        text.parse().unwrap()
    }

    #[test]
    fn sines_have_fifty_digits() {
        // sin 1 and cos 1, by mpmath.
        let [s, c] = sin_cos(&Value::integer(1)).unwrap();
        let expected = [
            "84147098480789650665250232163029899962256306079837",
            "54030230586813971740093660744297660373231042061792",
        ];
        for (found, digits) in [s, c].into_iter().zip(expected) {
            let expected = decimal(digits) / Rational::from(10).pow(50);
            let error = (found - expected).to_f64().value();
            assert!(error.abs() < 1e-48, "{error:e}");
        }
    }

    #[test]
    fn directions_are_those_of_their_angles() {
        for v in [
            [3, 4, 0],
            [1, 1, 1],
            [-2, 3, -7],
            [0, -1, 5],
            [0, 0, -2],
            [0, -3, 0],
        ] {
            let v = v.map(Rational::from);
            let [azimuth, polar] = direction(&v).unwrap();
            let [[sa, ca], [sp, cp]] = [sin_cos(&azimuth).unwrap(), sin_cos(&polar).unwrap()];
            let found = [&sp * &ca, &sp * &sa, cp];
            let length = v
                .iter()
                .zip(&found)
                .map(|(a, b)| a * b)
                .reduce(|a, b| a + b)
                .unwrap();
            assert!(length > Rational::ZERO);
            for (v, found) in v.iter().zip(&found) {
                let error = (v / &length - found).to_f64().value();
                assert!(error.abs() < 1e-45, "{error:e}");
            }
        }
        assert_eq!(direction(&[0; 3].map(Rational::from)), None);
    }
}
