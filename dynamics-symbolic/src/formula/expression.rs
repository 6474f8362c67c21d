//! A formula as it is written: sums of products of powers, with common factors in front of sums.

use super::atom::Atom;
use crate::exact::Rational;
use crate::robot::Value;

/// A sum; an empty one is zero.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Expression(pub(super) Vec<Term>);

/// A number times factors, over divisors.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Term {
    pub(super) is_negative: bool,
    pub(super) number: Number,
    pub(super) factors: Vec<Factor>,
    pub(super) divisors: Vec<Factor>,
}

/// A number above zero.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Number {
    /// As it is.
    Exact(Rational),
    /// The double nearest to an irrational one.
    Rounded(f64),
}

/// A power.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Factor {
    pub(super) base: Base,
    pub(super) exponent: u32,
}

/// What a power is of.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Base {
    Atom(Atom),
    Sum(Expression),
}

impl Number {
    pub(super) const ONE: Number = Number::Exact(Rational::ONE);
}

impl Factor {
    /// A variable.
    pub(super) fn atom(atom: Atom) -> Self {
        Factor {
            base: Base::Atom(atom),
            exponent: 1,
        }
    }

    /// A sum in parentheses.
    pub(super) fn sum(sum: Expression) -> Self {
        Factor {
            base: Base::Sum(sum),
            exponent: 1,
        }
    }
}

impl Term {
    /// A number.
    fn number(x: &Rational) -> Self {
        let is_negative = *x < Rational::ZERO;
        let size = if is_negative { -x.clone() } else { x.clone() };
        Term {
            is_negative,
            number: Number::Exact(size),
            factors: Vec::new(),
            divisors: Vec::new(),
        }
    }

    /// A factor.
    fn factor(factor: Factor) -> Self {
        Term {
            is_negative: false,
            number: Number::ONE,
            factors: vec![factor],
            divisors: Vec::new(),
        }
    }
}

impl Expression {
    /// A cell of the table, as it was written.
    pub(super) fn of_value(value: &Value) -> Self {
        let of = Expression::of_value;
        match value {
            Value::Rational(x) if x.is_zero() => Expression(Vec::new()),
            Value::Rational(x) => Expression(vec![Term::number(x)]),
            Value::Pi => Expression(vec![Term::factor(Factor::atom(Atom::Pi))]),
            Value::Field(i) => Expression(vec![Term::factor(Factor::atom(Atom::Field(*i)))]),
            Value::Neg(a) => Expression(of(a).0.into_iter().map(negated).collect()),
            Value::Add(a, b) => Expression([of(a).0, of(b).0].concat()),
            Value::Mul(a, b) => {
                let (mut a, b) = (of(a).single(), of(b).single());
                a.is_negative ^= b.is_negative;
                a.factors.extend(b.factors);
                a.divisors.extend(b.divisors);
                a.times(b.number);
                Expression(vec![a])
            }
            Value::Div(a, b) => {
                let (mut a, b) = (of(a).single(), of(b).single());
                a.is_negative ^= b.is_negative;
                a.factors.extend(b.divisors);
                a.divisors.extend(b.factors);
                if let Number::Exact(x) = b.number {
                    a.times(Number::Exact(Rational::ONE / x));
                }
                Expression(vec![a])
            }
        }
    }

    /// As one term: a sum is a factor in parentheses.
    fn single(mut self) -> Term {
        match self.0.len() {
            1 => self.0.remove(0),
            _ => Term::factor(Factor::sum(self)),
        }
    }
}

impl Term {
    /// The numbers of cells are exact.
    fn times(&mut self, number: Number) {
        if let (Number::Exact(a), Number::Exact(b)) = (&self.number, number) {
            self.number = Number::Exact(a * b);
        }
    }
}

fn negated(term: Term) -> Term {
    Term {
        is_negative: !term.is_negative,
        ..term
    }
}
