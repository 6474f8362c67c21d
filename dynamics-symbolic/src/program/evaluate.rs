//! Evaluation of programs in any arithmetic: a prime field, high precision, doubles.

use super::{Instruction, Operand, Program};
use crate::exact::Rational;
use crate::robot::Symbol;

/// An arithmetic, and the values of the symbols in it.
pub trait Arithmetic {
    /// The numbers.
    type Number: Clone;

    /// The image of an exact number.
    fn rational(&mut self, x: &Rational) -> Self::Number;
    /// The value of a symbol.
    fn symbol(&mut self, symbol: &Symbol) -> Self::Number;
    /// -a
    fn neg(&mut self, a: Self::Number) -> Self::Number;
    /// a + b
    fn add(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    /// a * b
    fn mul(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    /// a / b
    fn div(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
}

impl Program {
    /// The values of the outputs.
    pub fn evaluate<A: Arithmetic>(&self, arithmetic: &mut A) -> Vec<A::Number> {
        let constants = self.constants.evaluate(arithmetic);
        let inputs: Vec<_> = self
            .inputs
            .iter()
            .map(|symbol| arithmetic.symbol(symbol))
            .collect();
        let mut results: Vec<A::Number> = Vec::with_capacity(self.instructions.len());
        let read = |results: &[A::Number], operand: Operand| match operand {
            Operand::Constant(id) => constants[id.index()].clone(),
            Operand::Input(index) => inputs[index as usize].clone(),
            Operand::Result(index) => results[index as usize].clone(),
        };
        for instruction in &self.instructions {
            let (a, b) = instruction.operands();
            let (a, b) = (read(&results, a), read(&results, b));
            results.push(match instruction {
                Instruction::Add(..) => arithmetic.add(a, b),
                Instruction::Sub(..) => {
                    let b = arithmetic.neg(b);
                    arithmetic.add(a, b)
                }
                Instruction::Mul(..) => arithmetic.mul(a, b),
                Instruction::Div(..) => arithmetic.div(a, b),
            });
        }
        let output = |output: &super::Output| {
            let value = read(&results, output.operand);
            if output.negative {
                arithmetic.neg(value)
            } else {
                value
            }
        };
        self.outputs.iter().map(output).collect()
    }
}
