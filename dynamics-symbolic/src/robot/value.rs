//! A cell of the table: a constant expression over exact numbers, pi and symbolic parameters.

use crate::exact::Rational;

/// A constant expression, exact: operations on two rational numbers are carried out at once.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// An exact rational number.
    Rational(Rational),
    /// The circle's ratio.
    Pi,
    /// The symbolic parameter of that index in [`super::Robot::fields`].
    Field(usize),
    /// Minus the value.
    Neg(Box<Value>),
    /// The sum.
    Add(Box<Value>, Box<Value>),
    /// The product.
    Mul(Box<Value>, Box<Value>),
    /// The quotient.
    Div(Box<Value>, Box<Value>),
}

impl Value {
    /// The number zero.
    pub fn zero() -> Self {
        Value::Rational(Rational::ZERO)
    }

    /// An integer.
    pub fn integer(n: i64) -> Self {
        Value::Rational(Rational::from(n))
    }

    /// The exact value of a finite double.
    pub fn from_f64(x: f64) -> Option<Self> {
        Rational::try_from(x).ok().map(Value::Rational)
    }

    /// The symbolic parameter of that index.
    pub fn field(index: usize) -> Self {
        Value::Field(index)
    }

    /// The rational number that this value is, where it holds neither pi nor a parameter.
    pub fn as_rational(&self) -> Option<&Rational> {
        match self {
            Value::Rational(r) => Some(r),
            _ => None,
        }
    }

    /// Whether the value is the number zero.
    pub fn is_zero(&self) -> bool {
        self.as_rational().is_some_and(|r| r.is_zero())
    }

    /// Whether this is a number below zero.
    pub fn is_negative(&self) -> bool {
        match self.as_rational() {
            Some(rational) => *rational < Rational::ZERO,
            None => self.is_number() && self.to_f64(&[]) < 0.0,
        }
    }

    /// Whether the value depends on no symbolic parameter.
    pub fn is_number(&self) -> bool {
        match self {
            Value::Rational(_) | Value::Pi => true,
            Value::Field(_) => false,
            Value::Neg(a) => a.is_number(),
            Value::Add(a, b) | Value::Mul(a, b) | Value::Div(a, b) => {
                a.is_number() && b.is_number()
            }
        }
    }

    /// Calls `visit` with the index of every symbolic parameter in the value.
    pub fn visit_fields(&self, visit: &mut impl FnMut(usize)) {
        match self {
            Value::Rational(_) | Value::Pi => {}
            Value::Field(i) => visit(*i),
            Value::Neg(a) => a.visit_fields(visit),
            Value::Add(a, b) | Value::Mul(a, b) | Value::Div(a, b) => {
                a.visit_fields(visit);
                b.visit_fields(visit);
            }
        }
    }

    /// The value in double precision, rounded after each operation; `fields` are the
    /// parameters' values.
    pub fn to_f64(&self, fields: &[f64]) -> f64 {
        match self {
            Value::Rational(r) => r.to_f64().value(),
            Value::Pi => core::f64::consts::PI,
            Value::Field(i) => fields[*i],
            Value::Neg(a) => -a.to_f64(fields),
            Value::Add(a, b) => a.to_f64(fields) + b.to_f64(fields),
            Value::Mul(a, b) => a.to_f64(fields) * b.to_f64(fields),
            Value::Div(a, b) => a.to_f64(fields) / b.to_f64(fields),
        }
    }

    /// The quotient, or `None` where the divisor is the number zero.
    pub fn checked_div(self, divisor: Value) -> Option<Value> {
        match (self, divisor) {
            (_, b) if b.is_zero() => None,
            (Value::Rational(a), Value::Rational(b)) => Some(Value::Rational(a / b)),
            (a, b) if b.as_rational().is_some_and(|b| b.is_one()) => Some(a),
            (a, _) if a.is_zero() => Some(a),
            (a, b) => Some(Value::Div(Box::new(a), Box::new(b))),
        }
    }
}

impl core::ops::Neg for Value {
    type Output = Value;

    fn neg(self) -> Value {
        match self {
            Value::Rational(r) => Value::Rational(-r),
            Value::Neg(a) => *a,
            a => Value::Neg(Box::new(a)),
        }
    }
}

impl core::ops::Add for Value {
    type Output = Value;

    fn add(self, other: Value) -> Value {
        match (self, other) {
            (Value::Rational(a), Value::Rational(b)) => Value::Rational(a + b),
            (a, b) if b.is_zero() => a,
            (a, b) if a.is_zero() => b,
            (a, b) => Value::Add(Box::new(a), Box::new(b)),
        }
    }
}

impl core::ops::Sub for Value {
    type Output = Value;

    fn sub(self, other: Value) -> Value {
        self + -other
    }
}

impl core::ops::Mul for Value {
    type Output = Value;

    fn mul(self, other: Value) -> Value {
        match (self, other) {
            (Value::Rational(a), Value::Rational(b)) => Value::Rational(a * b),
            (a, b) if a.is_zero() || b.as_rational().is_some_and(|b| b.is_one()) => a,
            (a, b) if b.is_zero() || a.as_rational().is_some_and(|a| a.is_one()) => b,
            (a, b) => Value::Mul(Box::new(a), Box::new(b)),
        }
    }
}
