//! Values that grow with a power of an argument.
//!
//! Where everything on the way to an output is homogeneous in its one argument beside q, its error grows with the
//! same power.

use crate::program::{Instruction, Operand, Program};
use crate::robot::Symbol;

/// The power of an argument with which some outputs grow, and their errors and bounds with them (underflow apart): if the
/// argument is multiplied by s, they and all results on the way to them are multiplied by a power of s. `None` if a sum
/// has terms of different powers. `is_entry` tells the argument's entries, `outputs` are those that count.
pub(super) fn degree(
    program: &Program,
    outputs: core::ops::Range<usize>,
    is_entry: impl Fn(&Symbol) -> bool,
) -> Option<u32> {
    // `None` is the power of a sum whose terms have different powers.
    let mut results: Vec<Option<u32>> = Vec::with_capacity(program.instructions.len());
    let read = |results: &[Option<u32>], operand: Operand| match operand {
        Operand::Constant(_) => Some(0),
        Operand::Input(index) => Some(u32::from(is_entry(&program.inputs[index as usize]))),
        Operand::Result(index) => results[index as usize],
    };
    for instruction in &program.instructions {
        let [a, b] = instruction.operands();
        let both = read(&results, a).zip(read(&results, b));
        results.push(both.and_then(|(a, b)| match instruction {
            Instruction::Add(..) | Instruction::Sub(..) => (a == b).then_some(a),
            Instruction::Mul(..) => Some(a + b),
            Instruction::Div(..) => a.checked_sub(b),
        }));
    }
    let outputs = program.outputs[outputs].iter().map(|output| output.operand);
    // Constants among them are the same for any argument: those that vanish, and no others where the rest grows.
    let grows = |operand: &Operand| !matches!(operand, Operand::Constant(_));
    let mut degrees = outputs.filter(grows).map(|operand| read(&results, operand));
    let first = degrees.next()??;
    degrees.all(|degree| degree == Some(first)).then_some(first)
}
