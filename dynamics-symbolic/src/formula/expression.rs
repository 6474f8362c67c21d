//! A formula as it is written: sums of products of powers, with common factors in front of sums.

use super::atom::Atom;
use crate::exact::{Rational, negate_if};
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

/// The base of a power.
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
    /// A number with its sign, times factors.
    pub(super) fn new(is_negative: bool, number: Number, factors: Vec<Factor>) -> Self {
        Term {
            is_negative,
            number,
            factors,
            divisors: Vec::new(),
        }
    }

    fn factor(factor: Factor) -> Self {
        Term::new(false, Number::ONE, vec![factor])
    }

    /// The product of the numbers, both with their signs: those of cells are exact.
    fn times(&mut self, is_negative: bool, number: Number) {
        self.is_negative ^= is_negative;
        if let (Number::Exact(a), Number::Exact(b)) = (&self.number, number) {
            self.number = Number::Exact(a * b);
        }
    }
}

impl Expression {
    /// A cell of the table, as it was written.
    pub(super) fn of_value(value: &Value) -> Self {
        let terms = |value| Expression::of_value(value).0;
        let single = |value| Expression::of_value(value).single();
        let factor = |atom| Expression(vec![Term::factor(Factor::atom(atom))]);
        match value {
            Value::Rational(x) if x.is_zero() => Expression(Vec::new()),
            Value::Rational(x) => {
                let is_negative = *x < Rational::ZERO;
                let size = Number::Exact(negate_if(x.clone(), is_negative));
                Expression(vec![Term::new(is_negative, size, Vec::new())])
            }
            Value::Pi => factor(Atom::Pi),
            Value::Field(i) => factor(Atom::Field(*i)),
            Value::Neg(a) => Expression(terms(a).into_iter().map(negated).collect()),
            Value::Add(a, b) => Expression([terms(a), terms(b)].concat()),
            Value::Mul(a, b) => {
                let (mut a, b) = (single(a), single(b));
                a.factors.extend(b.factors);
                a.divisors.extend(b.divisors);
                a.times(b.is_negative, b.number);
                Expression(vec![a])
            }
            Value::Div(a, b) => {
                let (mut a, b) = (single(a), single(b));
                a.factors.extend(b.divisors);
                a.divisors.extend(b.factors);
                let inverse = match b.number {
                    Number::Exact(x) => Number::Exact(Rational::ONE / x),
                    rounded => rounded,
                };
                a.times(b.is_negative, inverse);
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

fn negated(term: Term) -> Term {
    Term {
        is_negative: !term.is_negative,
        ..term
    }
}
