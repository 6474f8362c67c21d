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

use crate::function::{Function, spans};
use crate::program::Program;
use crate::robot::Robot;
use core::fmt;

/// A program that is not equal to the textbook definition: a defect of the
/// engine, which must not reach a user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProofFailure {
    /// The function.
    pub function: Function,
    /// The first output that differs, counted from 0, or `None` where the count
    /// of outputs is wrong, or a number of the table has no image in the field.
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
///
/// # Errors
///
/// The first output that differs from the definition, if one does. A table that
/// divides by zero defines nothing: no program is proven for it.
pub fn prove(robot: &Robot, function: Function, program: &Program) -> Result<(), ProofFailure> {
    prove_together(robot, &[function], program)
}

/// Proves that a program computes some functions, the outputs of one after those of the other: each of
/// them by its own definition.
///
/// # Errors
///
/// As [`prove`], for the first function that fails.
pub fn prove_together(
    robot: &Robot,
    functions: &[Function],
    program: &Program,
) -> Result<(), ProofFailure> {
    Proof::new(robot, functions).holds(program)
}

/// The proof of any number of programs of the same functions: their definitions are evaluated once.
pub struct Proof {
    dof: usize,
    functions: Vec<Function>,
    point: Assignment,
    definition: Definition,
    /// What the outputs of each function must be, unless that is judged by what was computed; `None`
    /// inside where the table defines nothing.
    expected: Vec<Option<Option<Vec<Number>>>>,
}

impl Proof {
    /// That of some functions of a robot.
    pub fn new(robot: &Robot, functions: &[Function]) -> Self {
        let mut point = Assignment::new(robot, SEED);
        let definition = Definition::new(&mut point, robot);
        let expected = functions
            .iter()
            .map(|&function| (!function.row().refuses).then(|| definition.expected(function, &[])));
        Proof {
            dof: robot.dof(),
            functions: functions.to_vec(),
            expected: expected.collect(),
            point,
            definition,
        }
    }

    /// Compares a program with the definitions.
    ///
    /// # Errors
    ///
    /// As [`prove_together`].
    pub fn holds(&mut self, program: &Program) -> Result<(), ProofFailure> {
        let computed = program.evaluate(&mut self.point);
        let mut rest = &computed[..];
        let spans = spans(&self.functions, self.dof, computed.len());
        for (number, (&function, span)) in self.functions.iter().zip(spans).enumerate() {
            // The last one has to have all that is left.
            let count = match number + 1 == self.functions.len() {
                true => rest.len(),
                false => span.len().min(rest.len()),
            };
            let (own, others) = rest.split_at(count);
            rest = others;
            let judged;
            let expected = match &self.expected[number] {
                Some(expected) => expected,
                None => {
                    judged = self.definition.expected(function, own);
                    &judged
                }
            };
            compare(function, own, expected.as_deref())?;
        }
        Ok(())
    }
}

/// The outputs of one function beside what they must be: `None` where the table defines nothing.
fn compare(
    function: Function,
    computed: &[Option<Number>],
    expected: Option<&[Number]>,
) -> Result<(), ProofFailure> {
    let failure = |output| ProofFailure { function, output };
    let expected = expected.ok_or_else(|| failure(None))?;
    if computed.len() != expected.len() {
        return Err(failure(None));
    }
    let differs = |(computed, expected): (&Option<Number>, &Number)| *computed != Some(*expected);
    match computed.iter().zip(expected).position(differs) {
        Some(output) => Err(failure(Some(output))),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::ConstantPool;
    use crate::robot::{Convention, JointType, Row, Value};

    fn one_joint(mass: Value) -> Robot {
        let zero = Value::zero;
        let row = Row {
            a: Value::integer(1),
            mass,
            gear_ratio: Value::integer(1),
            ..Row::new("joint", JointType::Revolute)
        };
        Robot {
            name: "Pendulum".to_owned(),
            fields: Vec::new(),
            convention: Convention::Standard,
            gravity: [(); 3].map(|()| zero()),
            rows: vec![row],
            neglected: None,
            base: None,
            tool: None,
        }
    }

    fn empty_program() -> Program {
        Program {
            inputs: Vec::new(),
            constants: ConstantPool::default(),
            instructions: Vec::new(),
            outputs: Vec::new(),
            is_plain: false,
        }
    }

    /// One joint has no Coriolis coefficients: a program without outputs is right.
    #[test]
    fn a_function_without_outputs() {
        let function = Function::CoriolisCoefficients;
        let robot = one_joint(Value::integer(1));
        assert_eq!(prove(&robot, function, &empty_program()), Ok(()));
    }

    #[test]
    fn nothing_is_proven_for_a_table_that_divides_by_zero() {
        let zero = Value::Pi * Value::Pi - Value::Pi * Value::Pi;
        let robot = one_joint(Value::integer(1).checked_div(zero).unwrap());
        for function in Function::ALL {
            let failure = ProofFailure {
                function,
                output: None,
            };
            assert_eq!(prove(&robot, function, &empty_program()), Err(failure));
        }
    }

    /// Inverses exist because 2^62 - 57 is prime. Fermat: b^(p-1) = 1.
    #[test]
    fn the_modulus_passes_fermats_test() {
        const P: u64 = (1 << 62) - 57;
        for base in 2..40 {
            let mut power = Number::ONE;
            for bit in (0..62).rev() {
                power = power * power;
                if (P - 1) >> bit & 1 == 1 {
                    power = power * Number::new(base);
                }
            }
            assert_eq!(power, Number::ONE);
        }
    }
}
