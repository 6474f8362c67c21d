//! How long operations take, in cycles: today's processors differ by a few, and only the proportions matter.

use super::{Instruction, Line, Operand, Program, Rest};
use crate::robot::Symbol;

pub(super) const ADD: u32 = 3;
pub(super) const MULTIPLY: u32 = 3;
pub(super) const FUSED: u32 = 4;
pub(super) const DIVIDE: u32 = 13;
const SINE: u32 = 60;
const EXPONENTIAL: u32 = 60;
const SIGN: u32 = 6;

/// When an input is ready.
pub(super) fn of_input(input: &Symbol) -> u32 {
    match input {
        Symbol::Sine(_) | Symbol::Cosine(_) | Symbol::AngleSine(_) | Symbol::AngleCosine(_) => SINE,
        Symbol::VelocitySign(_) => SIGN,
        Symbol::Stribeck(_) => EXPONENTIAL,
        _ => 0,
    }
}

/// When the result of each line is ready; zero for products that are written into sums.
pub(super) fn ready_times(program: &Program, lines: &[Option<Line>]) -> Vec<u32> {
    let mut ready = Vec::with_capacity(lines.len());
    for line in lines {
        let of_operand = |operand| match operand {
            Operand::Constant(_) => 0,
            Operand::Input(index) => of_input(&program.inputs[index as usize]),
            Operand::Result(index) => ready[index as usize],
        };
        let end = |line: &Line| {
            let operands = line.operands().into_iter().map(of_operand);
            operands.max().unwrap_or(0) + of_line(line)
        };
        let time = line.as_ref().map_or(0, end);
        ready.push(time);
    }
    ready
}

fn of_line(line: &Line) -> u32 {
    match line {
        Line::Single(Instruction::Add(..) | Instruction::Sub(..)) => ADD,
        Line::Single(Instruction::Mul(..)) => MULTIPLY,
        Line::Single(Instruction::Div(..)) => DIVIDE,
        Line::Fused { rest, .. } => match rest {
            Rest::Product(..) => MULTIPLY + FUSED,
            Rest::Plus(_) | Rest::Minus(_) => FUSED,
        },
    }
}
