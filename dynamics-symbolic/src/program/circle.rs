//! Sines and cosines of constants as rational numbers.

use super::{Arithmetic, Real};
use crate::exact::Rational;
use crate::robot::{Angle, Symbol, Value};

/// Bits in which they are computed.
const PRECISION: usize = 320;

/// The error that such a number may have, and what counts as no difference from a half: 2^-220.
const BITS: usize = 220;

/// Sine and cosine of a constant angle: exactly, where they are 0, 1/2 or 1, or else rational numbers that
/// differ from them by less than 1e-60. Multiples of a right angle and of 30 degrees have no other
/// rational sine (Niven 1956, theorem 3.9). None where the angle is so large that nothing is known of it.
pub fn sine_and_cosine(angle: &Value) -> Option<[Rational; 2]> {
    let Angle {
        quarter_turns,
        rest,
    } = Angle::new(angle);
    let (sine, cosine) = match rest {
        None => (Rational::ZERO, Rational::ONE),
        Some(rest) => {
            let mut real = Real::new(PRECISION);
            let mut number = |symbol: Symbol| real.symbol(&symbol)?.rational(BITS).map(halved);
            (
                number(Symbol::AngleSine(rest.clone()))?,
                number(Symbol::AngleCosine(rest))?,
            )
        }
    };
    Some(match quarter_turns {
        0 => [sine, cosine],
        1 => [cosine, -sine],
        2 => [-sine, -cosine],
        _ => [-cosine, sine],
    })
}

/// The number, or the multiple of a half that it equals to all its digits.
fn halved(x: Rational) -> Rational {
    let half = Rational::from((&x * Rational::from(2)).round()) / Rational::from(2);
    let difference = &x - &half;
    let nothing = Rational::ONE / Rational::from(2).pow(BITS as isize);
    let is_half = -&nothing < difference && difference < nothing;
    if is_half { half } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(angle: Value) -> [Rational; 2] {
        sine_and_cosine(&angle).expect("it is known")
    }

    #[test]
    fn rational_sines_are_exact() {
        let twelfth = |n: i64| Value::Pi * Value::Rational(Rational::from(n) / Rational::from(6));
        let half = || Rational::ONE / Rational::from(2);
        assert_eq!(known(twelfth(1))[0], half());
        assert_eq!(known(twelfth(2))[1], half());
        assert_eq!(known(twelfth(-1))[0], -half());
        assert_eq!(known(twelfth(7))[0], -half());
        assert_eq!(known(twelfth(3)), [Rational::ONE, Rational::ZERO]);
        assert_eq!(known(twelfth(6)), [Rational::ZERO, -Rational::ONE]);
    }

    #[test]
    fn other_sines_are_near() {
        for angle in [0.3_f64, -1.7, 2.5, 4.0, 1e-9, 100.0] {
            let [s, c] = known(Value::from_f64(angle).unwrap());
            assert!((s.to_f64().value() - angle.sin()).abs() < 1e-15);
            assert!((c.to_f64().value() - angle.cos()).abs() < 1e-15);
            let error = &s * &s + &c * &c - Rational::ONE;
            assert!(error.to_f64().value().abs() < 1e-60, "{angle}");
        }
        let huge = Value::Rational(Rational::from(10).pow(400));
        assert!(sine_and_cosine(&huge).is_none());
    }
}
