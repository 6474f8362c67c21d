//! The constants of a program: exact until they are rounded, once, at emission.

use super::{Approximation, Arithmetic, Real};
use crate::exact::Rational;
use crate::robot::Symbol;

/// The index of a constant in its pool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ConstantId(u32);

impl ConstantId {
    /// The index as a number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// An exact constant: a number, a symbol, or an operation on earlier constants of its pool.
#[derive(Clone, Debug, PartialEq)]
pub enum Constant {
    /// A rational number.
    Rational(Rational),
    /// Pi, or the sine or cosine of a constant angle.
    Symbol(Symbol),
    /// The negative.
    Neg(ConstantId),
    /// The sum.
    Add(ConstantId, ConstantId),
    /// The product.
    Mul(ConstantId, ConstantId),
    /// The quotient.
    Div(ConstantId, ConstantId),
}

/// Constants, each defined from earlier ones.
#[derive(Clone, Debug, Default)]
pub struct ConstantPool(Vec<Constant>);

impl ConstantPool {
    /// Adds a constant.
    pub fn push(&mut self, constant: Constant) -> ConstantId {
        self.0.push(constant);
        ConstantId(self.0.len() as u32 - 1)
    }

    /// The constant of that index.
    pub fn get(&self, id: ConstantId) -> &Constant {
        &self.0[id.index()]
    }

    /// The values of all constants.
    pub fn evaluate<A: Arithmetic>(&self, arithmetic: &mut A) -> Vec<A::Number> {
        let mut values: Vec<A::Number> = Vec::with_capacity(self.0.len());
        for constant in &self.0 {
            let at = |id: &ConstantId| values[id.index()].clone();
            let value = match constant {
                Constant::Rational(x) => arithmetic.rational(x),
                Constant::Symbol(symbol) => arithmetic.symbol(symbol),
                Constant::Neg(a) => arithmetic.neg(at(a)),
                Constant::Add(a, b) => arithmetic.add(at(a), at(b)),
                Constant::Mul(a, b) => arithmetic.mul(at(a), at(b)),
                Constant::Div(a, b) => arithmetic.div(at(a), at(b)),
            };
            values.push(value);
        }
        values
    }

    /// The constants that `needed` asks for as correctly rounded doubles (the others as NaN).
    ///
    /// The precision is raised until every rounding is certain. A constant that
    /// is zero for a reason that the engine cannot know is never certain: it is
    /// within 2^-2000 of zero then, and rounds to zero.
    pub fn round(&self, needed: impl Fn(ConstantId) -> bool) -> Vec<f64> {
        let mut precision = 160;
        loop {
            let values = self.evaluate(&mut Real::new(precision));
            let last = precision > 2_000;
            let round = |(index, value): (usize, &Approximation)| match value.round() {
                _ if !needed(ConstantId(index as u32)) => Some(f64::NAN),
                None if last => Some(value.nearest()),
                rounded => rounded,
            };
            if let Some(rounded) = values.iter().enumerate().map(round).collect() {
                return rounded;
            }
            precision *= 2;
        }
    }
}
