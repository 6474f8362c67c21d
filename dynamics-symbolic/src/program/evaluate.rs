//! Evaluation of programs in any arithmetic: a prime field, high precision, doubles.

use super::{Arithmetic, Instruction, Operand, Program};

impl Program {
    /// The values of the outputs.
    pub fn evaluate<A: Arithmetic>(&self, arithmetic: &mut A) -> Vec<A::Number> {
        let constants = self.constants.evaluate(arithmetic);
        self.evaluate_with(constants, arithmetic)
    }

    /// The values of the outputs, with these values of the constants in the order of the pool.
    pub fn evaluate_with<A: Arithmetic>(
        &self,
        constants: Vec<A::Number>,
        arithmetic: &mut A,
    ) -> Vec<A::Number> {
        let symbols = self.inputs.iter();
        let inputs: Vec<_> = symbols.map(|symbol| arithmetic.symbol(symbol)).collect();
        let mut results: Vec<A::Number> = Vec::with_capacity(self.instructions.len());
        let read = |results: &[A::Number], operand: Operand| match operand {
            Operand::Constant(id) => constants[id.index()].clone(),
            Operand::Input(index) => inputs[index as usize].clone(),
            Operand::Result(index) => results[index as usize].clone(),
        };
        for instruction in &self.instructions {
            let [a, b] = instruction.operands();
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::Rational;
    use crate::program::{Constant, ConstantPool, Output, by_operators};
    use crate::robot::Symbol;

    /// Exact numbers: the position of joint i is i + 2, pi is 3.
    struct Exact;

    impl Arithmetic for Exact {
        type Number = Rational;

        fn rational(&mut self, x: &Rational) -> Rational {
            x.clone()
        }

        fn symbol(&mut self, symbol: &Symbol) -> Rational {
            match symbol {
                Symbol::Pi => Rational::from(3),
                Symbol::Position(i) => Rational::from(i + 2),
                other => panic!("{other:?}"),
            }
        }

        by_operators!(Rational);
    }

    /// One instruction on the inputs 2 and 3, put out as it is and negated.
    fn outputs(instruction: fn(Operand, Operand) -> Instruction) -> [Rational; 2] {
        let operand = Operand::Result(0);
        let program = Program {
            inputs: vec![Symbol::Position(0), Symbol::Position(1)],
            constants: ConstantPool::default(),
            instructions: vec![instruction(Operand::Input(0), Operand::Input(1))],
            outputs: [false, true]
                .map(|negative| Output { operand, negative })
                .to_vec(),
            is_plain: false,
        };
        program.evaluate(&mut Exact).try_into().unwrap()
    }

    fn rational(numerator: i64, denominator: u64) -> Rational {
        Rational::from_parts(numerator.into(), denominator.into())
    }

    #[test]
    fn every_instruction() {
        assert_eq!(outputs(Instruction::Add), [rational(5, 1), rational(-5, 1)]);
        assert_eq!(outputs(Instruction::Sub), [rational(-1, 1), rational(1, 1)]);
        assert_eq!(outputs(Instruction::Mul), [rational(6, 1), rational(-6, 1)]);
        assert_eq!(outputs(Instruction::Div), [rational(2, 3), rational(-2, 3)]);
    }

    #[test]
    fn every_constant() {
        let mut constants = ConstantPool::default();
        let half = constants.push(Constant::Rational(rational(1, 2)));
        let pi = constants.push(Constant::Symbol(Symbol::Pi));
        let negative = constants.push(Constant::Neg(half));
        let sum = constants.push(Constant::Add(negative, pi));
        let product = constants.push(Constant::Mul(sum, pi));
        constants.push(Constant::Div(product, half));
        let expected = [(1, 2), (3, 1), (-1, 2), (5, 2), (15, 2), (15, 1)];
        let expected = expected.map(|(numerator, denominator)| rational(numerator, denominator));
        assert_eq!(constants.evaluate(&mut Exact), expected);
    }

    #[test]
    fn instructions_read_earlier_results() {
        let mut constants = ConstantPool::default();
        let ten = constants.push(Constant::Rational(Rational::from(10)));
        let program = Program {
            inputs: vec![Symbol::Position(0)],
            constants,
            instructions: vec![
                Instruction::Mul(Operand::Input(0), Operand::Constant(ten)),
                Instruction::Sub(Operand::Result(0), Operand::Input(0)),
            ],
            outputs: [
                Operand::Result(1),
                Operand::Constant(ten),
                Operand::Input(0),
            ]
            .map(|operand| Output {
                operand,
                negative: false,
            })
            .to_vec(),
            is_plain: false,
        };
        assert_eq!(
            program.evaluate(&mut Exact),
            [18, 10, 2].map(Rational::from)
        );
    }
}
