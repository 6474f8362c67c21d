//! The outputs of a program over a box of points.

use super::ranged::Ranged;
use super::walk::{Node, Operation, Walk};
use crate::exact::negate_if;
use crate::interval::Interval;
use crate::program::{Constant, ConstantPool, Instruction, Operand, Program};
use crate::robot::Symbol;

/// The outputs of a program over all points at which its inputs are in these ranges, with its constants as they are
/// emitted.
pub(crate) fn outputs_over(program: &Program, constants: &[f64], inputs: &[Ranged]) -> Vec<Ranged> {
    let (walk, nodes) = Nodes::walked(program, constants, inputs);
    let outputs = program.outputs.iter();
    outputs
        .map(|output| negate_if(walk.value(nodes.of(output.operand)), output.negative))
        .collect()
}

/// The nodes of a program: its constants, its inputs, its instructions.
struct Nodes {
    constants: Vec<Node>,
    inputs: Vec<Node>,
    results: Vec<Node>,
}

impl Nodes {
    /// The walk over a whole program.
    fn walked(program: &Program, constants: &[f64], inputs: &[Ranged]) -> (Walk, Self) {
        let mut walk = Walk::default();
        let constants = ranged(&program.constants, constants);
        let mut nodes = Nodes {
            constants: constants.into_iter().map(|x| walk.given(x)).collect(),
            inputs: inputs.iter().map(|x| walk.given(*x)).collect(),
            results: Vec::new(),
        };
        nodes.circles(program, &mut walk);
        for instruction in &program.instructions {
            let [a, b] = instruction.operands().map(|operand| nodes.of(operand));
            let operation = match instruction {
                Instruction::Add(..) => Operation::Add(a, b),
                Instruction::Sub(..) => Operation::Sub(a, b),
                Instruction::Mul(..) => Operation::Mul(a, b),
                Instruction::Div(..) => Operation::Div(a, b),
            };
            nodes.results.push(walk.compute(operation));
        }
        (walk, nodes)
    }

    fn of(&self, operand: Operand) -> Node {
        match operand {
            Operand::Constant(id) => self.constants[id.index()],
            Operand::Input(index) => self.inputs[index as usize],
            Operand::Result(index) => self.results[index as usize],
        }
    }

    /// A sine and its cosine are on the unit circle.
    fn circles(&self, program: &Program, walk: &mut Walk) {
        let place = |symbol: &Symbol| program.inputs.iter().position(|other| other == symbol);
        for (sine, symbol) in program.inputs.iter().enumerate() {
            if let Symbol::Sine(i) = symbol
                && let Some(cosine) = place(&Symbol::Cosine(*i))
            {
                walk.circle([sine, cosine].map(|index| self.inputs[index]));
            }
        }
    }
}

/// The constants of a program, each an exact number that was rounded to a double. Constants that are doubles are
/// exact.
pub(crate) fn ranged(constants: &ConstantPool, doubles: &[f64]) -> Vec<Ranged> {
    let ranged = |(constant, &double): (&Constant, &f64)| match constant {
        Constant::Rational(x) => Ranged::rational(x, double),
        // One that is zero is written only where it is zero exactly.
        _ if double == 0.0 => Ranged::exact(Interval::exact(double)),
        _ => Ranged::rounded(double),
    };
    constants.iter().zip(doubles).map(ranged).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Output;

    /// Sine and cosine of an angle that may be any, and numbers up to 1.
    fn inputs(count: usize) -> (Vec<Symbol>, Vec<Ranged>) {
        let mut symbols = vec![
            Symbol::Sine(0),
            Symbol::Cosine(0),
            Symbol::Sine(1),
            Symbol::Cosine(1),
        ];
        symbols.extend((0..count).map(Symbol::Velocity));
        let ranges = vec![Ranged::exact(Interval::symmetric(1.0)); symbols.len()];
        (symbols, ranges)
    }

    fn outputs(count: usize, instructions: Vec<Instruction>, outputs: &[u32]) -> Vec<Ranged> {
        let (symbols, ranges) = inputs(count);
        let outputs = outputs
            .iter()
            .map(|index| Output::positive(Operand::Result(*index)));
        let program = Program {
            inputs: symbols,
            constants: ConstantPool::default(),
            instructions,
            outputs: outputs.collect(),
            is_plain: false,
        };
        outputs_over(&program, &[], &ranges)
    }

    /// (x, y) turned by the angle of the inputs `angle` and `angle` + 1, six instructions from `first`.
    fn turn(angle: u32, [x, y]: [Operand; 2], first: u32) -> [Instruction; 6] {
        use Instruction::{Add, Mul, Sub};
        let [s, c] = [angle, angle + 1].map(Operand::Input);
        let result = |k| Operand::Result(first + k);
        [
            Mul(s, x),
            Mul(y, c),
            Add(result(1), result(0)),
            Mul(c, x),
            Mul(s, y),
            Sub(result(3), result(4)),
        ]
    }

    /// Twenty turns of a vector: by its components alone it would be a thousand times as long.
    #[test]
    fn a_turned_vector_is_as_long_as_it_was() {
        let mut vector = [4, 5].map(Operand::Input);
        let mut instructions = Vec::new();
        for k in 0..20 {
            let first = instructions.len() as u32;
            instructions.extend(turn(2 * (k % 2), vector, first));
            vector = [first + 2, first + 5].map(Operand::Result);
        }
        let last = instructions.len() as u32 - 1;
        for output in outputs(2, instructions, &[last - 3, last]) {
            assert!((1.4..1.5).contains(&output.range.size()), "{output:?}");
            assert!(output.error[0] < 20.0 * 4.0 * f64::EPSILON, "{output:?}");
            assert!(
                output.error[1] < 20.0 * 4.0 * f64::from(f32::EPSILON),
                "{output:?}"
            );
        }
    }

    /// Twenty turns about two axes in turn: by its pairs alone the vector would be a thousand times as long.
    #[test]
    fn a_vector_that_is_turned_about_two_axes_is_as_long_as_it_was() {
        let mut vector = [4, 5, 6].map(Operand::Input);
        let mut instructions = Vec::new();
        for k in 0..20 {
            let first = instructions.len() as u32;
            let turned = [k % 2, k % 2 + 1].map(|k| vector[k as usize]);
            instructions.extend(turn(2 * (k % 2), turned, first));
            let results = [first + 2, first + 5].map(Operand::Result);
            vector[k as usize % 2] = results[0];
            vector[k as usize % 2 + 1] = results[1];
        }
        let last = instructions.len() as u32 - 1;
        for output in outputs(3, instructions, &[last - 3, last]) {
            assert!((1.7..1.8).contains(&output.range.size()), "{output:?}");
            assert!(output.error[0] < 20.0 * 6.0 * f64::EPSILON, "{output:?}");
        }
    }

    /// A chain of sums is as long as the program: it is followed back only so far.
    #[test]
    fn lengths_of_long_sums_end() {
        use Instruction::{Add, Mul};
        let [s, c, x, y] = [0, 1, 4, 5].map(Operand::Input);
        let mut instructions = vec![Add(x, y), Add(y, x)];
        for k in 0..20_000 {
            instructions.push(Add(Operand::Result(k), x));
        }
        let [a, b] = [20_000, 20_001].map(Operand::Result);
        let first = instructions.len() as u32;
        instructions.extend(turn(0, [a, b], first));
        instructions.extend([Mul(s, c)]);
        let [sum] = outputs(2, instructions, &[first + 2])[..] else {
            unreachable!("one output")
        };
        assert!((10_000.0..20_000.0).contains(&sum.range.size()), "{sum:?}");
    }

    /// (s x + c y, c x + s y) is no turned vector: both may be 1 and more at once.
    #[test]
    fn two_sums_are_no_turn() {
        use Instruction::{Add, Mul};
        let vector = [4, 5].map(Operand::Input);
        let mut instructions = turn(0, vector, 0).to_vec();
        instructions[5] = Add(Operand::Result(3), Operand::Result(4));
        // The sum of their squares, which is 4 where all are 1 / sqrt 2 or 1.
        let [u, v] = [2, 5].map(Operand::Result);
        instructions.extend([
            Mul(u, u),
            Mul(v, v),
            Add(Operand::Result(6), Operand::Result(7)),
        ]);
        let [sum] = outputs(2, instructions, &[8])[..] else {
            unreachable!("one output")
        };
        assert!(sum.range.size() >= 4.0, "{sum:?}");
    }

    /// s t and c t are a pair of length |t|.
    #[test]
    fn a_scaled_pair_is_as_long_as_its_factor() {
        use Instruction::Mul;
        let [s, c, t] = [0, 1, 4].map(Operand::Input);
        let mut instructions = vec![Mul(s, t), Mul(t, c)];
        instructions.extend(turn(2, [0, 1].map(Operand::Result), 2));
        for output in outputs(1, instructions, &[4, 7]) {
            assert!(output.range.size() < 1.0 + 1e-14, "{output:?}");
        }
    }
}
