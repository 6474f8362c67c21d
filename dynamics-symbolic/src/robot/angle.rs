//! Constant angles: whole quarter turns, which are exact, and a rest.

use super::Value;
use crate::exact::{Rational, is_short};
use core::f64::consts::{FRAC_PI_2, PI};
use dashu_int::IBig;
use dashu_int::ops::RemEuclid;

/// A distance to a multiple of a quarter turn below which an angle means that
/// multiple: decimals such as 1.5707963267948966 are pi/2.
///
/// Zero has no decimals to round: 1e-9 is the angle between two axes that are nearly parallel.
const TOLERANCE: f64 = 1e-9;

/// Beyond it the spacing of doubles comes near to the tolerance.
const LARGEST: f64 = 1e6;

/// A constant angle: `quarter_turns` * pi/2, plus the angle `rest`.
#[derive(Clone, Debug, PartialEq)]
pub struct Angle {
    /// Whole quarter turns, modulo 4.
    pub quarter_turns: u8,
    /// The rest, `None` where that is zero.
    pub rest: Option<Value>,
}

/// c0 + c1 pi + others, with rational c0, c1.
struct LinearForm {
    number: Rational,
    pi: Rational,
    others: Value,
}

impl Angle {
    /// Takes the whole quarter turns out of an angle.
    pub fn new(angle: &Value) -> Self {
        let form = LinearForm::read(angle);
        if let Some(quarter_turns) = form.whole_quarter_turns() {
            return Angle {
                quarter_turns,
                rest: nonzero(form.others),
            };
        }
        let quarters = (&form.pi * Rational::from(2)).round();
        Angle {
            quarter_turns: modulo_4(&quarters),
            rest: nonzero(form.rest(Rational::from(quarters) / Rational::from(2))),
        }
    }

    /// Whether two angles without whole quarter turns, as they are read, are opposite: -x is read as the number, the
    /// multiple of pi and the rest of x, each times -1.
    pub(crate) fn are_opposite(a: &Value, b: &Value) -> bool {
        let is_of = |a: &Value, b: &Value| {
            let form = LinearForm::read(a).scaled(&Rational::from(-1));
            form.is_some_and(|form| form.rest(Rational::ZERO) == *b)
        };
        *a == -b.clone() || is_of(a, b) || is_of(b, a)
    }

    /// The quarter turns as -1, 0, 1 or 2.
    pub fn signed_quarter_turns(&self) -> i8 {
        match self.quarter_turns {
            3 => -1,
            few => few as i8,
        }
    }
}

fn nonzero(value: Value) -> Option<Value> {
    (!value.is_zero()).then_some(value)
}

/// The remainder of a whole number of quarter turns.
fn modulo_4(quarters: &IBig) -> u8 {
    let quarters: u64 = quarters
        .rem_euclid(IBig::from(4))
        .try_into()
        .expect("0 to 3");
    quarters as u8
}

impl LinearForm {
    /// The angle less a multiple of pi.
    fn rest(self, whole: Rational) -> Value {
        let multiple_of_pi = Value::Rational(self.pi - whole) * Value::Pi;
        Value::Rational(self.number) + multiple_of_pi + self.others
    }

    /// The constant part as whole quarter turns modulo 4, where it is a multiple of one: exactly,
    /// or as decimals that are near enough. Near zero only a difference of decimals and pi is that.
    fn whole_quarter_turns(&self) -> Option<u8> {
        let of_pi = &self.pi * Rational::from(2);
        if self.number.is_zero() && of_pi.is_int() {
            return Some(modulo_4(&of_pi.round()));
        }
        let radians = self.number.to_f64().value() + self.pi.to_f64().value() * PI;
        let nearest = (radians / FRAC_PI_2).round();
        let is_difference = !self.number.is_zero() && !self.pi.is_zero();
        let is_near = radians.abs() <= LARGEST
            && (radians - nearest * FRAC_PI_2).abs() <= TOLERANCE
            && (nearest != 0.0 || is_difference);
        is_near.then(|| nearest.rem_euclid(4.0) as u8)
    }

    /// The form of a value. A part that only long numbers could separate is one of the others, as it is written.
    fn read(value: &Value) -> Self {
        let number = |number: Rational, pi: Rational| LinearForm {
            number,
            pi,
            others: Value::zero(),
        };
        let form = match value {
            Value::Rational(r) => Some(number(r.clone(), Rational::ZERO)),
            Value::Pi => Some(number(Rational::ZERO, Rational::ONE)),
            Value::Neg(a) => LinearForm::read(a).scaled(&Rational::from(-1)),
            Value::Add(a, b) => LinearForm::read(a).plus(LinearForm::read(b)),
            Value::Mul(a, b) => match (a.as_rational(), b.as_rational()) {
                (Some(k), _) => LinearForm::read(b).scaled(k),
                (_, Some(k)) => LinearForm::read(a).scaled(k),
                _ => None,
            },
            Value::Div(a, b) => match b.as_rational() {
                Some(k) if !k.is_zero() => LinearForm::read(a).scaled(&(Rational::ONE / k)),
                _ => None,
            },
            Value::Field(_) => None,
        };
        form.unwrap_or_else(|| LinearForm::opaque(value))
    }

    fn opaque(value: &Value) -> Self {
        LinearForm {
            number: Rational::ZERO,
            pi: Rational::ZERO,
            others: value.clone(),
        }
    }

    fn scaled(self, k: &Rational) -> Option<Self> {
        let is_short = is_short(&self.number, k) && is_short(&self.pi, k);
        is_short.then(|| LinearForm {
            number: self.number * k,
            pi: self.pi * k,
            others: self.others * Value::Rational(k.clone()),
        })
    }

    fn plus(self, other: Self) -> Option<Self> {
        let is_short = is_short(&self.number, &other.number) && is_short(&self.pi, &other.pi);
        is_short.then(|| LinearForm {
            number: self.number + other.number,
            pi: self.pi + other.pi,
            others: self.others + other.others,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{MOST_BITS, bit_length};

    fn rational(numerator: i64, denominator: u64) -> Value {
        Value::Rational(Rational::from_parts(numerator.into(), denominator.into()))
    }

    #[test]
    fn quarter_turns_are_exact() {
        let half_pi = Value::Pi * rational(1, 2);
        let cases = [
            (Value::zero(), 0),
            (half_pi.clone(), 1),
            (-half_pi.clone(), 3),
            (Value::Pi, 2),
            (Value::from_f64(FRAC_PI_2).unwrap(), 1),
            (rational(-15_707_963_268, 10_000_000_000), 3),
            (Value::Pi * rational(90, 180), 1),
        ];
        for (angle, quarter_turns) in cases {
            assert_eq!(
                Angle::new(&angle),
                Angle {
                    quarter_turns,
                    rest: None
                },
                "{angle:?}"
            );
        }
    }

    #[test]
    fn many_turns_are_counted_exactly() {
        let turns = |n: i64| Value::Pi * rational(n, 2);
        assert_eq!(
            Angle::new(&turns(4_000_000_000_000_000_001)).quarter_turns,
            1
        );
        assert_eq!(Angle::new(&turns(-1)).quarter_turns, 3);
        // Radians that are large are no multiple, whatever doubles say.
        let large = Value::Rational(Rational::from(10).pow(20));
        assert!(Angle::new(&large).rest.is_some());
    }

    #[test]
    fn other_angles_keep_a_rest() {
        let angle = Angle::new(&(Value::Pi * rational(2, 3)));
        assert_eq!(angle.quarter_turns, 1);
        let rest = angle.rest.unwrap().to_f64(&[]);
        assert!((rest - core::f64::consts::FRAC_PI_6).abs() < 1e-15);
        let angle = Angle::new(&rational(15708, 10000));
        assert_eq!(
            angle,
            Angle {
                quarter_turns: 0,
                rest: Some(rational(15708, 10000))
            }
        );
    }

    /// Axes that are parallel within 1e-9 rad exchange a little torque, and none where they are parallel.
    #[test]
    fn tiny_angles_are_not_zero() {
        let tiny = rational(1, 1_000_000_000);
        for angle in [tiny.clone(), -tiny.clone(), tiny * rational(1, 1_000)] {
            let expected = Angle {
                quarter_turns: 0,
                rest: Some(angle.clone()),
            };
            assert_eq!(Angle::new(&angle), expected);
        }
        let written_out = Value::Pi - rational(3_141_592_653_589_793, 1_000_000_000_000_000);
        assert_eq!(Angle::new(&written_out).rest, None);
    }

    /// Sums of multiples of pi by fractions that have nothing in common.
    #[test]
    fn long_numbers_are_left_as_they_are_written() {
        let mut angle = Value::zero();
        for k in 0..400_u64 {
            let denominator = Rational::from(2).pow(89) + Rational::from(2 * k + 1);
            angle = angle + Value::Pi * Value::Rational(Rational::ONE / denominator);
        }
        let rest = Angle::new(&angle).rest.expect("it is not zero");
        assert!((rest.to_f64(&[]) / angle.to_f64(&[]) - 1.0).abs() < 1e-12);
        let LinearForm { number, pi, .. } = LinearForm::read(&angle);
        assert!(bit_length(&number) + bit_length(&pi) <= MOST_BITS);
    }

    /// Whatever quarter turns are taken out of the two.
    #[test]
    fn an_angle_and_its_negative_are_opposite() {
        let fraction = || Value::Pi * rational(1, 3) + rational(1, 10);
        let angles = [
            rational(3, 10),
            Value::Pi * rational(1, 4),
            fraction(),
            Value::field(0) * rational(2, 7) + Value::Pi * rational(1, 2),
            -(fraction() - Value::field(0)),
        ];
        let read = |angle: &Value| Angle::new(angle).rest.expect("no quarter turn");
        for angle in &angles {
            let (rest, of_negative) = (read(angle), read(&-angle.clone()));
            assert!(Angle::are_opposite(&rest, &of_negative));
            assert!(Angle::are_opposite(&of_negative, &rest));
            assert!(!Angle::are_opposite(&rest, &rest));
        }
        assert!(!Angle::are_opposite(&read(&angles[0]), &read(&angles[1])));
    }

    #[test]
    fn parameters_are_kept_apart_from_quarter_turns() {
        let angle = Angle::new(&(Value::field(0) + Value::Pi * rational(1, 2)));
        assert_eq!(
            angle,
            Angle {
                quarter_turns: 1,
                rest: Some(Value::field(0))
            }
        );
    }
}
