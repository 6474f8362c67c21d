//! How far rounding can take a function's values from the exact ones, wherever the joints are within their limits.
//!
//! One walk over the finished program in intervals ([`outputs_over`](crate::rounding)) bounds the error of every
//! output in double and in single precision: joints within the limits of the table, all other arguments from -1 to 1. Counted are
//! half a unit in the last place for each operation and for constants that the precision has not, and one unit for exponentials,
//! sines and cosines, which the runtime proves of its kernels. A product that is added without being rounded before is not worse.
//! Bounds are rounded outwards, by operations that every platform rounds alike.

mod degree;
mod inputs;
mod line;

pub use line::{Rounding, rounding};

use crate::mechanism::Mechanism;
use crate::program::Program;
use crate::robot::{Robot, Symbol};
use crate::rounding::{largest_subdivided, outputs_over, ranged};
use core::ops::Range;
use inputs::{Positions, input};

/// The largest error of each output in double and in single precision, with the constants as they are emitted, joints within their
/// limits and other arguments from -1 to 1. Infinite where there is no bound: of a quotient by what may be zero somewhere, of what
/// depends on the struct's fields or on the position of a joint that slides without limits.
///
/// `None` where there is nothing to say: no joint has limits, or nothing is read that changes.
pub fn over_limits(robot: &Robot, program: &Program, constants: &[f64]) -> Option<Vec<[f64; 2]>> {
    let arm = Mechanism::from(robot);
    let has_limits = arm.free().any(|i| arm.joints[i].limits.is_some());
    let mut arguments = program.inputs.iter().filter_map(Symbol::argument);
    if !has_limits || arguments.next().is_none() {
        return None;
    }
    let symbols = program.inputs.iter();
    let inputs: Vec<_> = symbols.map(|symbol| input(&arm, symbol)).collect();
    let outputs = outputs_over(program, constants, &inputs);
    Some(outputs.into_iter().map(|output| output.error).collect())
}

/// The largest of the errors of some outputs, which are `known` over all positions: positions are cut into parts where
/// that helps most.
fn largest_in_parts(
    robot: &Robot,
    program: &Program,
    constants: &[f64],
    outputs: Range<usize>,
    known: &[[f64; 2]],
) -> [f64; 2] {
    let arm = Mechanism::from(robot);
    let positions = Positions {
        arm: &arm,
        symbols: &program.inputs,
    };
    let constants = ranged(&program.constants, constants);
    largest_subdivided(program, &constants, &positions, outputs, known)
}
