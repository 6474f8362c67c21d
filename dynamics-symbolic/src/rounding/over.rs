//! The outputs of a program over a box of points.

use super::pairs::{Length, Pairs, SumOfProducts, turned};
use super::ranged::{Ranged, each, norm, plus, rounding, sum};
use crate::exact::negate_if;
use crate::interval::Interval;
use crate::program::{Constant, ConstantPool, Instruction, Operand, Program};
use crate::robot::Symbol;

/// The outputs of a program over all points at which its inputs are in these ranges, with its constants as they are
/// emitted.
pub(crate) fn outputs_over(program: &Program, constants: &[f64], inputs: &[Ranged]) -> Vec<Ranged> {
    let mut walk = Walk {
        program,
        constants: ranged(&program.constants, constants),
        inputs,
        results: Vec::with_capacity(program.instructions.len()),
        pairs: Pairs::default(),
    };
    walk.circles();
    for instruction in &program.instructions {
        let result = walk.result(instruction);
        walk.results.push(result);
    }
    let outputs = program.outputs.iter();
    outputs
        .map(|output| negate_if(walk.read(output.operand), output.negative))
        .collect()
}

/// The constants of a program, each an exact number that was rounded to a double. Constants that are doubles are
/// exact.
fn ranged(constants: &ConstantPool, doubles: &[f64]) -> Vec<Ranged> {
    let ranged = |(constant, &double): (&Constant, &f64)| match constant {
        Constant::Rational(x) => Ranged::rational(x, double),
        // One that is zero is written only where it is zero exactly.
        _ if double == 0.0 => Ranged::exact(Interval::exact(double)),
        _ => Ranged::rounded(double),
    };
    constants.iter().zip(doubles).map(ranged).collect()
}

struct Walk<'p> {
    program: &'p Program,
    constants: Vec<Ranged>,
    inputs: &'p [Ranged],
    results: Vec<Ranged>,
    pairs: Pairs,
}

impl Walk<'_> {
    fn read(&self, operand: Operand) -> Ranged {
        match operand {
            Operand::Constant(id) => self.constants[id.index()],
            Operand::Input(index) => self.inputs[index as usize],
            Operand::Result(index) => self.results[index as usize],
        }
    }

    /// A sine and its cosine are on the unit circle.
    fn circles(&mut self) {
        let place = |symbol: &Symbol| self.program.inputs.iter().position(|other| other == symbol);
        for (sine, symbol) in self.program.inputs.iter().enumerate() {
            if let Symbol::Sine(i) = symbol
                && let Some(cosine) = place(&Symbol::Cosine(*i))
            {
                let [sine, cosine] = [sine, cosine].map(|place| Operand::Input(place as u32));
                let [s, c] = [sine, cosine].map(|place| self.read(place).error);
                let error = each(|k| norm(s[k], c[k]));
                self.pairs.set(sine, cosine, Length { size: 1.0, error });
            }
        }
    }

    fn result(&mut self, instruction: &Instruction) -> Ranged {
        match *instruction {
            Instruction::Add(a, b) => self.sum(a, b, false),
            Instruction::Sub(a, b) => self.sum(a, b, true),
            Instruction::Mul(a, b) => self.product(a, b),
            Instruction::Div(a, b) => self.read(a) / self.read(b),
        }
    }

    /// The operand of the instruction that comes next.
    fn next(&self) -> Operand {
        Operand::Result(self.results.len() as u32)
    }

    fn product(&mut self, a: Operand, b: Operand) -> Ranged {
        let product = self.read(a) * self.read(b);
        let rounded = rounding(product.computed());
        let lengths = [a, b].map(|operand| Length {
            size: self.read(operand).range.size(),
            error: self.read(operand).error,
        });
        let next = self.next();
        self.pairs.product([a, b], lengths, next, rounded);
        product
    }

    fn sum(&mut self, a: Operand, b: Operand, is_difference: bool) -> Ranged {
        let (x, y) = (self.read(a), self.read(b));
        let result = x + negate_if(y, is_difference);
        let products = self.program.product(a).zip(self.program.product(b));
        let Some((first, second)) = products else {
            return result;
        };
        let products = SumOfProducts {
            first,
            second,
            is_difference,
        };
        let turns = products.turns().map(|turn| {
            let (coefficients, vector) = (self.length(turn.coefficients), self.length(turn.vector));
            (turn, turned(coefficients, vector))
        });
        let (mut range, mut error) = (result.range, sum(x.error, y.error));
        for (_, (length, roundings)) in &turns {
            range = range.within(length.size);
            let turned = sum(length.error, *roundings);
            error = each(|k| error[k].min(turned[k]));
        }
        let last = rounding(error.map(|error| plus(range.size(), error)));
        for (turn, (length, roundings)) in turns {
            self.pairs
                .component(self.next(), turn, length, sum(roundings, last));
        }
        Ranged::from_operands(range, error)
    }

    /// The length of a pair: what is known of it, or else of each.
    fn length(&self, (a, b): (Operand, Operand)) -> Length {
        let (x, y) = (self.read(a), self.read(b));
        let mut length = Length {
            size: norm(x.range.size(), y.range.size()),
            error: each(|k| norm(x.error[k], y.error[k])),
        };
        if let Some(known) = self.pairs.length(a, b) {
            length.size = length.size.min(known.size);
            length.error = each(|k| length.error[k].min(known.error[k]));
        }
        length
    }
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
