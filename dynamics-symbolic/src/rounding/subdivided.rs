//! The largest error of a program's outputs, over a box of points that is cut where it matters.
//!
//! In a small box intervals lose little, so that the error of an output is bounded there by the roundings of all
//! operations times the ranges of its derivatives by them. The box with the largest bound is cut in two, along the
//! variable of which its bound depends most, until so much work is done.

use super::ranged::{Each, Ranged, each, plus, rounding, times};
use crate::interval::Interval;
use crate::program::{Instruction, Operand, Output, Program};
use core::cmp::Ordering;
use core::ops::Range;
use std::collections::BinaryHeap;

/// Variables with ranges, on which the inputs of a program depend.
pub(crate) trait Variables {
    /// The ranges of all of them.
    fn whole(&self) -> Vec<Interval>;
    /// The inputs of the program where the variables are in these ranges.
    fn inputs(&self, ranges: &[Interval]) -> Vec<Ranged>;
    /// The variable on which an input depends.
    fn of_input(&self, index: usize) -> Option<usize>;
}

/// The most instructions that are evaluated for one function: about a second's work.
const WORK: usize = 5_000_000;

/// The largest errors of some outputs wherever the variables are. `known` are the bounds over the whole box.
pub(crate) fn largest_subdivided(
    program: &Program,
    constants: &[Ranged],
    variables: &dyn Variables,
    outputs: Range<usize>,
    known: &[Each],
) -> Each {
    let slices = program.outputs[outputs].iter();
    let slices: Vec<_> = slices.map(|output| Slice::new(program, *output)).collect();
    let whole = |output| Part {
        output,
        error: known[output],
        ranges: variables.whole(),
        cut: Cut::Unseen,
    };
    let mut parts: BinaryHeap<_> = (0..slices.len()).map(whole).collect();
    let mut work = 0;
    while work < WORK
        && let Some(largest) = parts.peek()
        && !matches!(largest.cut, Cut::Nowhere)
        && let Some(largest) = parts.pop()
    {
        let slice = &slices[largest.output];
        for ranges in largest.halves() {
            work += slice.instructions.len();
            let inputs = variables.inputs(&ranges);
            let mut walk = slice.walk(constants, &inputs);
            let found = walk.error();
            parts.push(Part {
                output: largest.output,
                error: each(|k| found[k].min(largest.error[k])),
                cut: walk.cut(variables, &ranges),
                ranges,
            });
        }
    }
    let errors = parts.iter().map(|part| part.error);
    errors.fold([0.0; 2], |largest, error| {
        each(|k| largest[k].max(error[k]))
    })
}

/// How a part may be made smaller.
enum Cut {
    /// Nothing is known of it yet.
    Unseen,
    /// Along that variable.
    Along(usize),
    /// Its bound depends on no variable.
    Nowhere,
}

/// A part of the box, for one output.
struct Part {
    output: usize,
    error: Each,
    ranges: Vec<Interval>,
    cut: Cut,
}

impl Part {
    /// Its halves; the whole of one that was not looked at.
    fn halves(&self) -> Vec<Vec<Interval>> {
        let Cut::Along(variable) = self.cut else {
            return vec![self.ranges.clone()];
        };
        let half = |half| {
            let mut ranges = self.ranges.clone();
            ranges[variable] = half;
            ranges
        };
        self.ranges[variable].halves().map(half).into()
    }
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Part {}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Part {
    fn cmp(&self, other: &Self) -> Ordering {
        self.error[0].total_cmp(&other.error[0])
    }
}

/// The instructions on which one output depends.
struct Slice {
    /// Their operands are constants, inputs, and results of this list.
    instructions: Vec<Instruction>,
    output: Operand,
}

impl Slice {
    fn new(program: &Program, output: Output) -> Self {
        let mut is_read = vec![false; program.instructions.len()];
        let read = |operand: Operand, is_read: &mut Vec<bool>| {
            if let Operand::Result(index) = operand {
                is_read[index as usize] = true;
            }
        };
        read(output.operand, &mut is_read);
        for (index, instruction) in program.instructions.iter().enumerate().rev() {
            if is_read[index] {
                for operand in instruction.operands() {
                    read(operand, &mut is_read);
                }
            }
        }
        let mut places = vec![0; is_read.len()];
        let mut instructions = Vec::new();
        let moved = |operand: Operand, places: &[u32]| match operand {
            Operand::Result(index) => Operand::Result(places[index as usize]),
            other => other,
        };
        for (index, instruction) in program.instructions.iter().enumerate() {
            if is_read[index] {
                places[index] = instructions.len() as u32;
                instructions.push(instruction.map(|operand| moved(operand, &places)));
            }
        }
        Slice {
            instructions,
            output: moved(output.operand, &places),
        }
    }

    /// The values of all instructions.
    fn walk<'w>(&'w self, constants: &'w [Ranged], inputs: &'w [Ranged]) -> Walk<'w> {
        let mut walk = Walk {
            slice: self,
            constants,
            inputs,
            results: Vec::with_capacity(self.instructions.len()),
            of_inputs: vec![Interval::exact(0.0); inputs.len()],
        };
        for instruction in &self.instructions {
            let [a, b] = instruction.operands().map(|operand| walk.read(operand));
            walk.results.push(match instruction {
                Instruction::Add(..) => a + b,
                Instruction::Sub(..) => a + -b,
                Instruction::Mul(..) => a * b,
                Instruction::Div(..) => a / b,
            });
        }
        walk
    }
}

struct Walk<'w> {
    slice: &'w Slice,
    constants: &'w [Ranged],
    inputs: &'w [Ranged],
    results: Vec<Ranged>,
    /// The derivatives of the output by the inputs.
    of_inputs: Vec<Interval>,
}

impl Walk<'_> {
    fn read(&self, operand: Operand) -> Ranged {
        match operand {
            Operand::Constant(id) => self.constants[id.index()],
            Operand::Input(index) => self.inputs[index as usize],
            Operand::Result(index) => self.results[index as usize],
        }
    }

    /// The error of the output: of all that is found, the least.
    fn error(&mut self) -> Each {
        let forwards = self.read(self.slice.output).error;
        let backwards = self.by_derivatives();
        each(|k| forwards[k].min(backwards[k]))
    }

    /// The sum of all roundings times the derivatives of the output by what is rounded. With
    /// e_ab = a' e_b + b e_a, in which a' is computed, the sum is exact if derivatives are taken at numbers that are
    /// each computed or exact.
    fn by_derivatives(&mut self) -> Each {
        let zero = Interval::exact(0.0);
        let mut of_results = vec![zero; self.results.len()];
        let mut error = [0.0; 2];
        let mut contribute = |derivative: Interval, own: Each| {
            let size = derivative.size();
            error = each(|k| plus(error[k], times(size, own[k])));
        };
        match self.slice.output {
            Operand::Result(index) => of_results[index as usize] = Interval::exact(1.0),
            _ => return [f64::INFINITY; 2],
        }
        for index in (0..self.results.len()).rev() {
            let derivative = of_results[index];
            if derivative == zero {
                continue;
            }
            contribute(derivative, rounding(self.results[index].computed()));
            let instruction = &self.slice.instructions[index];
            let [a, b] = instruction.operands();
            let wide = |operand| self.read(operand).wide();
            let shares = match instruction {
                Instruction::Add(..) => [derivative, derivative],
                Instruction::Sub(..) => [derivative, -derivative],
                Instruction::Mul(..) => [derivative * wide(b), derivative * wide(a)],
                Instruction::Div(..) => {
                    let over = derivative.over(wide(b));
                    [over, -(over * wide(a).over(wide(b)))]
                }
            };
            for (operand, share) in [a, b].into_iter().zip(shares) {
                match operand {
                    Operand::Constant(id) => contribute(share, self.constants[id.index()].error),
                    Operand::Input(i) => {
                        self.of_inputs[i as usize] = self.of_inputs[i as usize] + share;
                    }
                    Operand::Result(i) => of_results[i as usize] = of_results[i as usize] + share,
                }
            }
        }
        for (derivative, input) in self.of_inputs.iter().zip(self.inputs) {
            contribute(*derivative, input.error);
        }
        error
    }

    /// Along the variable that widens the output most.
    fn cut(&self, variables: &dyn Variables, ranges: &[Interval]) -> Cut {
        let mut influence = vec![0.0; ranges.len()];
        for (index, input) in self.inputs.iter().enumerate() {
            if let Some(variable) = variables.of_input(index) {
                influence[variable] += self.of_inputs[index].size() * input.range.width();
            }
        }
        let most = influence.iter().copied().fold(0.0, f64::max);
        match influence.iter().position(|x| *x == most) {
            Some(variable) if most > 0.0 => Cut::Along(variable),
            _ => Cut::Nowhere,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::ConstantPool;
    use crate::robot::Symbol;

    /// An input that is a variable, and one that is any number up to 1.
    struct Line;

    impl Variables for Line {
        fn whole(&self) -> Vec<Interval> {
            vec![Interval::symmetric(1.0)]
        }

        fn inputs(&self, ranges: &[Interval]) -> Vec<Ranged> {
            [ranges[0], Interval::symmetric(1.0)]
                .map(Ranged::exact)
                .into()
        }

        fn of_input(&self, index: usize) -> Option<usize> {
            (index == 0).then_some(0)
        }
    }

    fn largest(instructions: Vec<Instruction>, outputs: &[Operand], known: Each) -> Each {
        let outputs: Vec<_> = outputs.iter().map(|x| Output::positive(*x)).collect();
        let known = vec![known; outputs.len()];
        let program = Program {
            inputs: vec![Symbol::Position(0), Symbol::Velocity(0)],
            constants: ConstantPool::default(),
            instructions,
            outputs,
            is_plain: false,
        };
        largest_subdivided(&program, &[], &Line, 0..known.len(), &known)
    }

    /// x (x - x^3) is 1/4 at most, where intervals say 2; its error falls by parts.
    #[test]
    fn parts_bound_less_than_the_whole() {
        use Instruction::{Mul, Sub};
        let x = Operand::Input(0);
        let result = Operand::Result;
        let instructions = vec![
            Mul(x, x),
            Mul(result(0), x),
            Sub(x, result(1)),
            Mul(x, result(2)),
        ];
        let unit = f64::EPSILON / 2.0;
        let [double, single] = largest(instructions, &[result(3)], [f64::INFINITY; 2]);
        // |x| (u x^2 |x| + u |x^3| + u |x - x^3|) + u |x (x - x^3)| = 2 u x^2, at most.
        assert!((2.0..2.1).contains(&(double / unit)), "{}", double / unit);
        let units = single / (f64::from(f32::EPSILON) / 2.0);
        assert!((2.0..2.1).contains(&units), "{units}");
    }

    /// Nothing is cut where no variable matters, and known bounds stay.
    #[test]
    fn outputs_without_variables_keep_their_bounds() {
        let v = Operand::Input(1);
        let instructions = vec![Instruction::Mul(v, v)];
        let unit = f64::EPSILON / 2.0;
        let bound = |known| largest(instructions.clone(), &[Operand::Result(0), v], known);
        assert!(bound([1.0; 2])[0] <= 1.01 * unit);
        assert_eq!(bound([1e-20; 2]), [1e-20; 2]);
    }
}
