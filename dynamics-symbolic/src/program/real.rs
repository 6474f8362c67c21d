//! Real numbers in binary high precision, with a bound on their error, and one correct rounding to double.
//!
//! A constant is rounded once, to the nearest double. If that lies in the middle between two singles, the constant's
//! text has the nearest single beside it (`rounded_once`). Constants are rational, or polynomials over rationals in
//! pi and the sines and cosines of constant angles. `sqrt`, `sin` and `cos` in a value of the table give rationals
//! too: the exact value if it is one, else a rational within 1e-60 of it, for which everything is proven.

use super::Arithmetic;
use crate::exact::{Rational, negate_if};
use crate::robot::{Symbol, Value};
use core::cmp::Ordering;
use dashu_float::round::mode::HalfEven;
use dashu_float::{Context, FBig, FpResult};
use dashu_int::{IBig, Sign};

type Float = FBig<HalfEven, 2>;

/// Arithmetic in `precision` bits.
pub struct Real {
    context: Context<HalfEven>,
    precision: usize,
}

/// An approximation of a real number, which is within `error` of `value`.
#[derive(Clone, Debug)]
pub struct Approximation {
    value: Float,
    error: Float,
}

/// Nothing where too little is known of a number: a quotient whose divisor cannot be told from zero, or the sine of an
/// angle that is not known to a radian.
type Known = Option<Approximation>;

impl Real {
    /// Arithmetic in that many bits.
    pub fn new(precision: usize) -> Self {
        Real {
            context: Context::new(precision),
            precision,
        }
    }

    /// A result that was rounded once, from operands that contribute `error`.
    fn rounded(&self, result: FpResult<Float>, error: Float) -> Known {
        let result = result.ok()?;
        let is_exact = result.error_ref().is_none();
        let value = result.value();
        let mut bound = error;
        if !is_exact {
            bound += absolute(&value) >> (self.precision as isize - 1);
        }
        let error = coarse(bound);
        Some(Approximation { value, error })
    }

    fn integer(&self, n: IBig) -> Known {
        self.rounded(Ok(self.context.convert_int(n)), Float::ZERO)
    }

    /// Sine or cosine, whose slope is at most 1.
    fn turned(
        &mut self,
        angle: &Value,
        function: impl Fn(&Context<HalfEven>, &Float) -> FpResult<Float>,
    ) -> Known {
        let angle = self.angle(angle).filter(|angle| angle.error < Float::ONE)?;
        self.rounded(function(&self.context, &angle.value), angle.error)
    }

    /// A constant angle, less the whole turns that are nearest to it.
    pub(super) fn less_turns(&mut self, angle: &Value) -> Known {
        let (angle, pi) = (self.angle(angle), self.symbol(&Symbol::Pi));
        let turn = self.add(pi.clone(), pi);
        let turns = self.div(angle.clone(), turn.clone())?;
        let turns = self.integer(-turns.value.to_int().value());
        let whole = self.mul(turns, turn);
        self.add(angle, whole)
    }

    /// A constant angle as it was written.
    pub(super) fn angle(&mut self, angle: &Value) -> Known {
        match angle {
            Value::Rational(x) => self.rational(x),
            Value::Pi => self.symbol(&Symbol::Pi),
            Value::Field(_) => unreachable!("the angle is constant"),
            Value::Neg(a) => {
                let a = self.angle(a);
                self.neg(a)
            }
            Value::Add(a, b) | Value::Mul(a, b) | Value::Div(a, b) => {
                let (a, b) = (self.angle(a), self.angle(b));
                match angle {
                    Value::Add(..) => self.add(a, b),
                    Value::Mul(..) => self.mul(a, b),
                    _ => self.div(a, b),
                }
            }
        }
    }
}

fn absolute(x: &Float) -> Float {
    negate_if(x.clone(), x.sign() == Sign::Negative)
}

/// An error bound needs few digits: rounded to 32 bits and enlarged to stay a bound.
fn coarse(error: Float) -> Float {
    let short = error.with_precision(32).value();
    let slack = short.clone() >> 30;
    short + slack
}

impl Arithmetic for Real {
    type Number = Known;

    fn rational(&mut self, x: &Rational) -> Known {
        let numerator = self.integer(x.numerator().clone());
        let denominator = self.integer(x.denominator().clone().into());
        self.div(numerator, denominator)
    }

    fn symbol(&mut self, symbol: &Symbol) -> Known {
        match symbol {
            Symbol::Pi => self.rounded(Ok(self.context.pi(None)), Float::ZERO),
            Symbol::AngleSine(angle) => {
                self.turned(angle, |context, angle| context.sin(angle.repr(), None))
            }
            Symbol::AngleCosine(angle) => {
                self.turned(angle, |context, angle| context.cos(angle.repr(), None))
            }
            other => unreachable!("{other:?} is no constant"),
        }
    }

    fn neg(&mut self, a: Known) -> Known {
        let Approximation { value, error } = a?;
        let value = -value;
        Some(Approximation { value, error })
    }

    fn add(&mut self, a: Known, b: Known) -> Known {
        let (a, b) = a.zip(b)?;
        let sum = self.context.add(a.value.repr(), b.value.repr());
        self.rounded(sum, a.error + b.error)
    }

    fn mul(&mut self, a: Known, b: Known) -> Known {
        let (a, b) = a.zip(b)?;
        let product = self.context.mul(a.value.repr(), b.value.repr());
        let error =
            absolute(&a.value) * &b.error + absolute(&b.value) * &a.error + a.error * b.error;
        self.rounded(product, error)
    }

    fn div(&mut self, a: Known, b: Known) -> Known {
        let (a, b) = a.zip(b)?;
        let room = absolute(&b.value) - &b.error;
        if room <= Float::ZERO {
            return None;
        }
        let quotient = self.context.div(a.value.repr(), b.value.repr());
        let value = quotient.as_ref().ok()?.value_ref();
        // |a/b - a'/b'| <= (ea + |a'/b'| eb) / (|b'| - eb)
        let error = (a.error + absolute(value) * b.error) / room;
        self.rounded(quotient, error)
    }
}

impl Approximation {
    /// The double nearest to every number within the error: the correct rounding, where the error is small enough to
    /// tell. Infinite beyond the largest double.
    pub fn round(&self) -> Option<f64> {
        let Approximation { value, error } = self;
        // Without a limit to the digits: the ends must not be rounded inwards.
        let exact = Context::<HalfEven>::new(0);
        let low = exact.sub(value.repr(), error.repr()).ok()?;
        let high = exact.add(value.repr(), error.repr()).ok()?;
        let low = low.value().to_f64().value();
        let high = high.value().to_f64().value();
        // Zero has one sign: -0 + 0 = 0.
        (low == high).then_some(high + 0.0)
    }

    /// How the number compares with a finite double; nothing where the error is too large to tell.
    pub(super) fn compare(&self, x: f64) -> Option<Ordering> {
        let Approximation { value, error } = self;
        let exact = Context::<HalfEven>::new(0);
        let x = Float::try_from(x).ok()?;
        let distance = exact.sub(value.repr(), x.repr()).ok()?.value();
        if absolute(&distance) > *error {
            return distance.partial_cmp(&Float::ZERO);
        }
        (distance == Float::ZERO && *error == Float::ZERO).then_some(Ordering::Equal)
    }

    /// The approximation itself, where its error is below 2^-bits.
    pub(super) fn rational(&self, bits: usize) -> Option<Rational> {
        let Approximation { value, error } = self;
        let bound = Float::ONE >> bits as isize;
        if *error >= bound {
            return None;
        }
        let significand = Rational::from(value.repr().significand().clone());
        let exponent = value.repr().exponent();
        let power = Rational::from(IBig::ONE << exponent.unsigned_abs());
        Some(if exponent < 0 {
            significand / power
        } else {
            significand * power
        })
    }

    /// The correct rounding of what is known of a number. Where that does not tell it and `is_last`, the double that is
    /// nearest, infinity where nothing is known.
    pub(super) fn rounded(known: &Option<Self>, is_last: bool) -> Option<f64> {
        let nearest = |known: &Self| known.value.to_f64().value() + 0.0;
        let uncertain = || is_last.then(|| known.as_ref().map_or(f64::INFINITY, nearest));
        known.as_ref().and_then(Self::round).or_else(uncertain)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rational(numerator: &str, denominator: &str) -> Rational {
        let [numerator, denominator] = [numerator, denominator].map(|x| x.parse::<IBig>().unwrap());
        Rational::from(numerator) / Rational::from(denominator)
    }

    fn power_of_two(exponent: i32) -> Rational {
        let power = Rational::from(IBig::ONE << exponent.unsigned_abs() as usize);
        if exponent < 0 {
            Rational::ONE / power
        } else {
            power
        }
    }

    fn value(x: &Rational) -> Value {
        Value::Rational(x.clone())
    }

    fn round(x: &Rational) -> Option<f64> {
        Real::new(160).rational(x)?.round()
    }

    fn sine(angle: Value, precision: usize) -> Option<f64> {
        Real::new(precision)
            .symbol(&Symbol::AngleSine(angle))?
            .round()
    }

    fn cosine(angle: Value, precision: usize) -> Option<f64> {
        Real::new(precision)
            .symbol(&Symbol::AngleCosine(angle))?
            .round()
    }

    #[test]
    fn rationals_round_as_the_compiler_rounds_decimals() {
        let cases = [
            ("1", "10", 0.1),
            ("-1", "3", -1.0 / 3.0),
            ("981", "100", 9.81),
            (
                "15707963267948966",
                "10000000000000000",
                core::f64::consts::FRAC_PI_2,
            ),
            (
                "123456789012345678901234567890",
                "7",
                1.763_668_414_462_081e28,
            ),
        ];
        for (numerator, denominator, expected) in cases {
            assert_eq!(round(&rational(numerator, denominator)), Some(expected));
        }
    }

    /// A tie is certain where nothing was rounded before, and goes to the even double.
    #[test]
    fn ties_go_to_even() {
        let ulp = power_of_two(-52);
        let half = power_of_two(-53);
        assert_eq!(round(&(Rational::ONE + &half)), Some(1.0));
        assert_eq!(
            round(&(Rational::ONE + &ulp + &half)),
            Some(1.0 + 2.0 * f64::EPSILON)
        );
        assert_eq!(
            round(&(Rational::ONE + &half + power_of_two(-140))),
            Some(1.0 + f64::EPSILON)
        );
        // The sum of a third and the rest of the tie is known to 160 bits only.
        let mut real = Real::new(160);
        let third = rational("1", "3");
        let (a, b) = (
            real.rational(&third),
            real.rational(&(Rational::ONE + half - third)),
        );
        assert_eq!(real.add(a, b).unwrap().round(), None);
    }

    #[test]
    fn numbers_that_no_double_can_hold() {
        assert_eq!(round(&power_of_two(1024)), Some(f64::INFINITY));
        assert_eq!(round(&-power_of_two(5000)), Some(f64::NEG_INFINITY));
        assert_eq!(round(&power_of_two(1023)), Some(2.0_f64.powi(1023)));
        assert_eq!(round(&power_of_two(-1074)), Some(f64::from_bits(1)));
        assert_eq!(
            round(&(power_of_two(-1073) + power_of_two(-1074))),
            Some(f64::from_bits(3))
        );
        let zero = round(&-power_of_two(-5000)).unwrap();
        assert!(zero == 0.0 && zero.is_sign_positive());
    }

    /// The least double, exactly halved, is a tie; less than half of it is zero.
    #[test]
    fn numbers_below_the_least_double() {
        assert_eq!(round(&power_of_two(-1075)), Some(0.0));
        assert_eq!(round(&power_of_two(-1076)), Some(0.0));
        assert_eq!(round(&power_of_two(-1080)), Some(0.0));
        let more_than_half = power_of_two(-1075) + power_of_two(-1076) + power_of_two(-1077);
        assert_eq!(round(&more_than_half), Some(f64::from_bits(1)));
    }

    #[test]
    fn integers_longer_than_the_precision() {
        let (long, longer) = (
            power_of_two(400) + Rational::ONE,
            power_of_two(401) - Rational::ONE,
        );
        let quotient = Real::new(160).rational(&(long / longer));
        let quotient = quotient.unwrap();
        assert_eq!(quotient.round(), Some(0.5));
        let Approximation { value, error } = quotient;
        assert!(
            error > Float::ZERO && error < (Float::ONE >> 150),
            "{value} {error}"
        );
    }

    #[test]
    fn cancellation_is_noticed() {
        let mut real = Real::new(160);
        let tiny = power_of_two(-155);
        let third = rational("1", "3");
        let (a, b) = (real.rational(&(&third + &tiny)), real.rational(&-third));
        let difference = real.add(a, b);
        assert_eq!(Approximation::rounded(&difference, false), None);
        let nearest = Approximation::rounded(&difference, true).unwrap();
        assert!((nearest / 2.0_f64.powi(-155) - 1.0).abs() < 0.1);
    }

    /// A small error is not lost where the sum is exact: the interval reaches past the tie.
    #[test]
    fn the_ends_of_the_interval_are_not_rounded() {
        let tie = Approximation {
            value: Float::ONE + (Float::ONE >> 53),
            error: Float::ONE >> 500,
        };
        assert_eq!(tie.round(), None);
    }

    #[test]
    fn sines_of_known_angles() {
        let pi = || Value::Pi;
        let of = |numerator, denominator| value(&rational(numerator, denominator));
        assert_eq!(sine(of("1", "1"), 160), Some(0.841_470_984_807_896_5));
        assert_eq!(cosine(of("1", "1"), 160), Some(0.540_302_305_868_139_8));
        assert_eq!(sine(of("-1", "10"), 160), Some(-0.099_833_416_646_828_15));
        let eighth = pi() * of("1", "4");
        assert_eq!(
            sine(eighth.clone(), 160),
            Some(core::f64::consts::FRAC_1_SQRT_2)
        );
        assert_eq!(cosine(eighth, 160), Some(core::f64::consts::FRAC_1_SQRT_2));
        // sin(10^22), a classic of argument reduction.
        let far = of("10000000000000000000000", "1");
        assert_eq!(sine(far, 160), Some(-0.852_200_849_767_188_8));
        // The operations of an angle: pi/3 - 1/(2 pi).
        let angle = pi() * of("1", "3") - of("1", "2").checked_div(pi()).unwrap();
        let expected = angle.to_f64(&[]).sin();
        assert!((sine(angle, 160).unwrap() - expected).abs() < 1e-15);
    }

    /// No arithmetic knows that sin(pi/6) is 1/2, but it is far from a tie.
    #[test]
    fn a_hidden_rational_is_certain() {
        let angle = Value::Pi * value(&rational("1", "6"));
        assert_eq!(sine(angle, 160), Some(0.5));
    }

    /// An angle of 400 bits needs as many bits before it is known to a radian.
    #[test]
    fn sines_of_huge_angles() {
        let huge = value(&(power_of_two(400) / Rational::from(3)));
        assert_eq!(sine(huge.clone(), 160), None);
        let sine = [640, 1280].map(|precision| sine(huge.clone(), precision));
        assert!(sine[0].is_some() && sine[0] == sine[1]);
    }

    #[test]
    fn a_divisor_that_may_be_zero_gives_nothing() {
        let zero = Value::Pi * Value::Pi - Value::Pi * Value::Pi;
        let quotient = Value::integer(1).checked_div(zero.clone()).unwrap();
        assert_eq!(sine(zero, 2_560), Some(0.0));
        assert_eq!(sine(quotient, 2_560), None);
        let mut real = Real::new(160);
        let third = rational("1", "3");
        let (a, b) = (
            real.rational(&third),
            real.rational(&(-third - power_of_two(-165))),
        );
        let (one, maybe_zero) = (real.rational(&Rational::ONE), real.add(a, b));
        let nothing = real.div(one.clone(), maybe_zero);
        let rounded = [false, true].map(|is_last| Approximation::rounded(&nothing, is_last));
        assert_eq!(rounded, [None, Some(f64::INFINITY)]);
        let negative = real.neg(nothing.clone());
        assert!(real.add(negative, one.clone()).is_none());
        assert!(real.mul(nothing, one).is_none());
    }
}
