//! Real numbers in binary high precision, with a bound on their error, and one
//! correct rounding to double.

use super::Arithmetic;
use crate::exact::Rational;
use crate::robot::{Symbol, Value};
use dashu_float::round::mode::HalfEven;
use dashu_float::{Context, FBig};

type Float = FBig<HalfEven, 2>;

/// Arithmetic in `precision` bits.
pub struct Real {
    context: Context<HalfEven>,
    precision: usize,
}

/// An approximation: the true number is within `error` of `value`.
#[derive(Clone, Debug)]
pub struct Approximation {
    value: Float,
    error: Float,
}

impl Real {
    /// Arithmetic in that many bits.
    pub fn new(precision: usize) -> Self {
        Real {
            context: Context::new(precision),
            precision,
        }
    }

    /// A result that was rounded once, from operands that contribute `error`.
    fn rounded(&self, value: Float, error: Float) -> Approximation {
        let ulp = absolute(&value) >> (self.precision as isize - 1);
        Approximation {
            error: coarse(error + ulp),
            value,
        }
    }

    fn exact(&self, x: &Rational) -> Float {
        let numerator = self.context.convert_int::<2>(x.numerator().clone()).value();
        let denominator = self
            .context
            .convert_int::<2>(x.denominator().clone().into())
            .value();
        self.context
            .div(numerator.repr(), denominator.repr())
            .expect("a positive denominator")
            .value()
    }

    fn angle(&mut self, angle: &Value) -> Approximation {
        match angle {
            Value::Rational(x) => self.rational(x),
            Value::Pi => self.symbol(&Symbol::Pi),
            Value::Field(_) => unreachable!("the angle is constant"),
            Value::Neg(a) => {
                let a = self.angle(a);
                self.neg(a)
            }
            Value::Add(a, b) => {
                let (a, b) = (self.angle(a), self.angle(b));
                self.add(a, b)
            }
            Value::Mul(a, b) => {
                let (a, b) = (self.angle(a), self.angle(b));
                self.mul(a, b)
            }
            Value::Div(a, b) => {
                let (a, b) = (self.angle(a), self.angle(b));
                self.div(a, b)
            }
        }
    }
}

fn absolute(x: &Float) -> Float {
    if x.sign() == dashu_int::Sign::Negative {
        -x.clone()
    } else {
        x.clone()
    }
}

/// An error bound needs few digits: rounded to 32 bits and enlarged to stay a bound.
fn coarse(error: Float) -> Float {
    let short = error.with_precision(32).value();
    let slack = short.clone() >> 30;
    short + slack
}

impl Arithmetic for Real {
    type Number = Approximation;

    fn rational(&mut self, x: &Rational) -> Approximation {
        let value = self.exact(x);
        self.rounded(value, Float::ZERO)
    }

    fn symbol(&mut self, symbol: &Symbol) -> Approximation {
        match symbol {
            Symbol::Pi => {
                let value = self.context.pi::<2>(None).value();
                self.rounded(value, Float::ZERO)
            }
            Symbol::AngleSine(angle) => {
                let angle = self.angle(angle);
                let value = angle.value.sin();
                self.rounded(value, angle.error)
            }
            Symbol::AngleCosine(angle) => {
                let angle = self.angle(angle);
                let value = angle.value.cos();
                self.rounded(value, angle.error)
            }
            other => unreachable!("{other:?} is no constant"),
        }
    }

    fn neg(&mut self, a: Approximation) -> Approximation {
        Approximation {
            value: -a.value,
            error: a.error,
        }
    }

    fn add(&mut self, a: Approximation, b: Approximation) -> Approximation {
        let value = self
            .context
            .add(a.value.repr(), b.value.repr())
            .expect("finite")
            .value();
        self.rounded(value, a.error + b.error)
    }

    fn mul(&mut self, a: Approximation, b: Approximation) -> Approximation {
        let value = self
            .context
            .mul(a.value.repr(), b.value.repr())
            .expect("finite")
            .value();
        let error =
            absolute(&a.value) * &b.error + absolute(&b.value) * &a.error + a.error * b.error;
        self.rounded(value, error)
    }

    fn div(&mut self, a: Approximation, b: Approximation) -> Approximation {
        let value = self
            .context
            .div(a.value.repr(), b.value.repr())
            .expect("a nonzero divisor")
            .value();
        // |a/b - a'/b'| <= (ea + |a'/b'| eb) / (|b'| - eb)
        let room = absolute(&b.value) - &b.error;
        let error = (a.error + absolute(&value) * b.error) / room;
        self.rounded(value, error)
    }
}

impl Approximation {
    /// The double nearest to every number within the error: the correct
    /// rounding, where the error is small enough to tell.
    pub fn round(&self) -> Option<f64> {
        let low = (self.value.clone() - &self.error).to_f64().value();
        let high = (self.value.clone() + &self.error).to_f64().value();
        (low == high).then_some(low)
    }

    /// The double nearest to the approximation.
    pub fn nearest(&self) -> f64 {
        self.value.to_f64().value()
    }
}
