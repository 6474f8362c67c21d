//! The proof of an expansion: the program that is emitted, and the textbook
//! definition read from the raw table, are evaluated at a random point of a
//! prime field and must agree.
//!
//! Sines and cosines are random points of the unit circle, constants are
//! exact. Two different rational functions of degree d agree with probability
//! below d/p, here about 10^3 / 2^62 (Schwartz 1980, Zippel 1979): one point
//! decides. Nothing of the derivations, the graph or the simplifications is
//! used on the textbook's side, and the prime is another than the graph's.

mod assignment;
mod definition;
mod dual;

pub use assignment::{Assignment, Number};
pub use definition::Definition;

use crate::function::Function;
use crate::program::Program;
use crate::robot::Robot;
use core::fmt;

/// A program that is not equal to the textbook definition: a defect of the
/// engine, which must not reach a user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProofFailure {
    /// The function.
    pub function: Function,
    /// The first output that differs, counted from 0, or `None` where the count of outputs is wrong.
    pub output: Option<usize>,
}

impl fmt::Display for ProofFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the program derived for `{}` is not equal to the textbook Lagrangian",
            self.function.name()
        )?;
        if let Some(output) = self.output {
            write!(f, " (output {})", output + 1)?;
        }
        write!(
            f,
            "; this is a defect of robot-dynamics, please report it with the table"
        )
    }
}

impl std::error::Error for ProofFailure {}

/// The point at which programs are compared. Fixed: the same table gives the same expansion.
const SEED: u64 = 0x0070_726f_6f66;

/// Proves that a program computes its function.
pub fn prove(robot: &Robot, function: Function, program: &Program) -> Result<(), ProofFailure> {
    let mut assignment = Assignment::new(robot, SEED);
    let computed = program.evaluate(&mut assignment);
    let expected = Definition::new(&mut assignment, robot).expected(function, &computed);
    if computed.len() != expected.len() {
        return Err(ProofFailure {
            function,
            output: None,
        });
    }
    let differs = |(computed, expected): (&Option<Number>, &Number)| *computed != Some(*expected);
    match computed.iter().zip(&expected).position(differs) {
        Some(output) => Err(ProofFailure {
            function,
            output: Some(output),
        }),
        None => Ok(()),
    }
}
