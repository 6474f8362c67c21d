//! The proof of an expansion: the program that is emitted, and the textbook definition read from the raw table,
//! are evaluated at a pseudo-random point of a prime field and must agree.
//!
//! Sines and cosines are points of the unit circle, constants are exact. The point is drawn from a hash of the
//! table and the program. Two different rational functions of degree d agree at a random point with a
//! probability of at most d/p (Schwartz 1980, Zippel 1979); `tests/suite/degrees.rs` counts the degrees. Nothing
//! of the derivations, the graph or the simplifications is used on the textbook's side, and the prime is another
//! than the graph's.
//!
//! The prime is 2^62 - 57. The same table gives the same point on every platform. If something divides by zero there,
//! another point is drawn, three at most. A wrong program that was not made for the purpose passes with a probability
//! of at most 1e-12 for arms of up to seven joints and 1e-10 for arms of up to twelve joints. Two things are outside
//! of that count: the hash is taken for random, and the prime is fixed, so that constants which are wrong by
//! multiples of it pass. For base parameters of arms whose joints follow others by symbolic factors, 4e-10 is added,
//! because relations between the factors are looked for in the field, too (`exact::common_angles`).
//!
//! Forward dynamics is judged by the equations of motion that its result must satisfy, and by its pivots. Derivatives
//! are those of the Euler-Lagrange equations by dual numbers over dual numbers. Derivatives of forward dynamics solve
//! the differentiated equations of motion.
//!
//! `tests/suite/damage.rs` changes every single operation of the programs of five robots, and every change is
//! refused. `random_tables.rs` proves every function of random tables with symbolic cells anywhere. `invariances.rs`
//! compares arms whose difference is known. The proof does not cover the reading of cells, the rounding and printing
//! of constants, and the writing of tokens: golden files, reference values of 25 digits and the numeric Newton-Euler
//! check cover these.

mod assignment;
mod definition;
mod dual;
mod inverse;

pub use assignment::{Assignment, Number};
pub use definition::Definition;
pub use inverse::prove_inverse;

use crate::exact::SplitMix64;
use crate::function::{Freedoms, Function, Part, spans};
use crate::program::Program;
use crate::robot::Robot;
use core::fmt;

/// How many points are drawn at most: another one where a division by zero leaves nothing to compare.
pub const DRAWS: usize = 3;

/// A program that is not shown to be equal to the textbook definition: a defect of the engine, which must not
/// reach a user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProofFailure {
    /// The function.
    pub function: Function,
    /// The reason.
    pub cause: Cause,
}

/// Why a program is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// The definition has another number of outputs.
    Count,
    /// The first output that differs, counted from 0.
    Output(usize),
    /// The program or the table divides by zero at each point that was drawn, or a number of the table has no
    /// image in the field.
    Undefined,
}

impl fmt::Display for ProofFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.function.name();
        write!(f, "the program derived for `{name}` ")?;
        let difference = match self.cause {
            Cause::Count => "number of outputs".to_owned(),
            Cause::Output(output) => format!("output {}", output + 1),
            Cause::Undefined => {
                return write!(
                    f,
                    "cannot be compared with the textbook Lagrangian, because one of them divides by zero at \
                     {DRAWS} points: is a divisor in the table zero, or a number in it a multiple of 2^62 - 57? \
                     Otherwise this is a defect of robot-dynamics, please report it with the table"
                );
            }
        };
        write!(
            f,
            "is not equal to the textbook Lagrangian ({difference}); \
             this is a defect of robot-dynamics, please report it with the table"
        )
    }
}

impl std::error::Error for ProofFailure {}

/// Proves that a program computes its function, of a frame where it is about one.
///
/// # Errors
///
/// The first output that differs from the definition, if one does. A table that
/// divides by zero defines nothing: no program is proven for it.
pub fn prove(robot: &Robot, part: impl Into<Part>, program: &Program) -> Result<(), ProofFailure> {
    prove_together(robot, &[part.into()], program)
}

/// Proves that a program computes some functions, the outputs of one after those of the other: each of
/// them by its own definition.
///
/// # Errors
///
/// As [`prove`], for the first function that fails.
pub fn prove_together(
    robot: &Robot,
    parts: &[Part],
    program: &Program,
) -> Result<(), ProofFailure> {
    prove_at(robot, parts, program, seeds(robot, parts, program))
}

/// Compares at the first of these points at which nothing divides by zero.
fn prove_at(
    robot: &Robot,
    parts: &[Part],
    program: &Program,
    seeds: [u64; DRAWS],
) -> Result<(), ProofFailure> {
    let compare = |seed: &u64| Proof::at(robot, parts, *seed).holds(program);
    let [first, others @ ..] = &seeds;
    others
        .iter()
        .fold(compare(first), |result, seed| match result {
            Err(failure) if failure.cause == Cause::Undefined => compare(seed),
            result => result,
        })
}

/// The seeds of the points, from a hash of all that is compared: the cells of the table, each as its value at
/// a fixed point of the field, the functions with their frames, and the constants and instructions of the program.
fn seeds(robot: &Robot, parts: &[Part], program: &Program) -> [u64; DRAWS] {
    let mut fixed = Assignment::new(robot, 0);
    Definition::read(&mut fixed, robot);
    let frame = |part: &Part| part.frame.map_or(0, |frame| frame as u64 + 1);
    fixed.note(
        parts
            .iter()
            .map(|part| part.function as u64 + (frame(part) << 32)),
    );
    fixed.note_program(program);
    core::array::from_fn(|draw| SplitMix64::number(fixed.digest(), draw as u64))
}

/// The proof of any number of programs of the same functions at one point: their definitions are evaluated once.
pub struct Proof {
    freedoms: Freedoms,
    parts: Vec<Part>,
    point: Assignment,
    definition: Definition,
    /// The right outputs of each function, unless they depend on those that were computed; `None` inside if the
    /// table defines none.
    expected: Vec<Option<Option<Vec<Number>>>>,
}

impl Proof {
    /// At the first point that is drawn for a program.
    pub fn new(robot: &Robot, parts: &[Part], program: &Program) -> Self {
        Proof::at(robot, parts, seeds(robot, parts, program)[0])
    }

    fn at(robot: &Robot, parts: &[Part], seed: u64) -> Self {
        let mut point = Assignment::new(robot, seed);
        let definition = Definition::new(&mut point, robot);
        let expected =
            |part: &Part| (!part.function.row().refuses).then(|| definition.expected(*part, &[]));
        Proof {
            freedoms: robot.freedoms(),
            parts: parts.to_vec(),
            expected: parts.iter().map(expected).collect(),
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
        let spans = spans(&self.parts, self.freedoms, computed.len());
        for (number, (&part, span)) in self.parts.iter().zip(spans).enumerate() {
            // The last one has to have all that is left.
            let is_last = number + 1 == self.parts.len();
            let count = if is_last {
                rest.len()
            } else {
                span.len().min(rest.len())
            };
            let (own, others) = rest.split_at(count);
            rest = others;
            let judged;
            let expected = match &self.expected[number] {
                Some(expected) => expected,
                None => {
                    judged = self.definition.expected(part, own);
                    &judged
                }
            };
            let function = part.function;
            compare(own, expected.as_deref()).map_err(|cause| ProofFailure { function, cause })?;
        }
        Ok(())
    }
}

/// Compares the outputs of one function with the right ones, `None` if the table defines none.
fn compare(computed: &[Option<Number>], expected: Option<&[Number]>) -> Result<(), Cause> {
    let expected = expected.ok_or(Cause::Undefined)?;
    if computed.len() != expected.len() {
        return Err(Cause::Count);
    }
    if computed.contains(&None) {
        return Err(Cause::Undefined);
    }
    let differs = |(computed, expected): (&Option<Number>, &Number)| *computed != Some(*expected);
    let first = computed.iter().zip(expected).position(differs);
    first.map_or(Ok(()), |output| Err(Cause::Output(output)))
}

#[cfg(test)]
mod tests {
    use super::assignment::HALF;
    use super::*;
    use crate::exact::Rational;
    use crate::program::{Constant, ConstantPool, Instruction, Operand, Output};
    use crate::robot::{
        Base, Body, Carrier, Convention, Frame, JointType, Placement, Row, Symbol, Value,
    };

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
            frames: Vec::new(),
            neglected: None,
            bounds: Default::default(),
            base: None,
            tool: None,
        }
    }

    fn origin() -> Placement {
        Placement {
            xyz: [0; 3].map(Value::integer),
            rpy: [0; 3].map(Value::integer),
        }
    }

    fn loaded_frame() -> Frame {
        Frame {
            name: "hand".to_owned(),
            on: Some(0),
            places: vec![origin()],
            body: Some(Body {
                mass: Value::integer(1),
                com: [0; 3].map(Value::integer),
                inertia: [0; 6].map(Value::integer),
            }),
        }
    }

    fn program(instructions: Vec<Instruction>, constants: &[u64], outputs: &[Operand]) -> Program {
        let mut pool = ConstantPool::default();
        for &x in constants {
            pool.push(Constant::Rational(Rational::from(x)));
        }
        let output = |&operand: &Operand| Output {
            operand,
            negative: false,
        };
        Program {
            inputs: vec![Symbol::Position(0), Symbol::Velocity(0)],
            constants: pool,
            instructions,
            outputs: outputs.iter().map(output).collect(),
            is_plain: false,
        }
    }

    /// One joint has no Coriolis coefficients: a program without outputs is right.
    #[test]
    fn a_function_without_outputs() {
        let function = Function::CoriolisCoefficients;
        let robot = one_joint(Value::integer(1));
        let empty = program(Vec::new(), &[], &[]);
        assert_eq!(prove(&robot, function, &empty), Ok(()));
    }

    #[test]
    fn nothing_is_proven_for_a_table_that_divides_by_zero() {
        let zero = Value::Pi * Value::Pi - Value::Pi * Value::Pi;
        let robot = one_joint(Value::integer(1).checked_div(zero).unwrap());
        let empty = program(Vec::new(), &[], &[]);
        for function in Function::ALL {
            let cause = Cause::Undefined;
            let failure = ProofFailure { function, cause };
            assert!(failure.to_string().contains("divides by zero at 3 points"));
            assert_eq!(prove(&robot, function, &empty), Err(failure));
        }
    }

    /// M is 1, here computed as (q - k + shift)/(q - k), where k is the position at one of the points.
    #[test]
    fn another_point_is_drawn_where_a_program_divides_by_zero() {
        let robot = Robot {
            rows: vec![Row {
                mass: Value::integer(1),
                com: [1, 0, 0].map(Value::integer),
                ..Row::new("joint", JointType::Revolute)
            }],
            ..one_joint(Value::zero())
        };
        let position = |seed| Assignment::new(&robot, seed).joints()[0].q;
        let result = |k: Number, seeds, shift| {
            let (q, zero) = (Operand::Input(0), Operand::Result(0));
            let mut program = program(Vec::new(), &[], &[Operand::Result(2)]);
            let mut constant = |x| {
                let constant = Constant::Rational(Rational::from(x));
                Operand::Constant(program.constants.push(constant))
            };
            let [k, shift] = [k.get(), shift].map(&mut constant);
            program.instructions = vec![
                Instruction::Sub(q, k),
                Instruction::Add(zero, shift),
                Instruction::Div(Operand::Result(1), zero),
            ];
            let parts = [Function::MassMatrix.into()];
            let result = prove_at(&robot, &parts, &program, seeds);
            result.map_err(|failure| failure.cause)
        };
        assert_eq!(result(position(5), [5, 6, 7], 0), Ok(()));
        assert_eq!(result(position(5), [5, 5, 7], 0), Ok(()));
        assert_eq!(result(position(5), [5, 5, 5], 0), Err(Cause::Undefined));
        assert_eq!(result(position(5), [5, 6, 7], 1), Err(Cause::Output(0)));
        assert_eq!(result(position(5), [6, 5, 7], 1), Err(Cause::Output(0)));
    }

    /// The same seed everywhere and always, and another one if anything that is compared changes.
    #[test]
    fn the_point_is_drawn_from_table_and_program() {
        let table = one_joint(Value::integer(1));
        let functions = [Function::MassMatrix].map(Part::from);
        let [q, qd] = [0, 1].map(Operand::Input);
        let sound = program(vec![Instruction::Add(q, qd)], &[3], &[Operand::Result(0)]);
        let mut known = vec![seeds(&table, &functions, &sound)[0]];
        assert_eq!(known, [12_860_224_314_083_942_366]);
        let renamed = Robot {
            name: "Rod".to_owned(),
            ..table.clone()
        };
        assert_eq!(seeds(&renamed, &functions, &sound)[0], known[0]);
        known.push(seeds(&table, &[Function::BiasForce.into()], &sound)[0]);
        let of_frame = |function, frame| {
            [Part {
                function,
                frame: Some(frame),
            }]
        };
        for frame in [0, 1] {
            known.push(seeds(&table, &of_frame(Function::MassMatrix, frame), &sound)[0]);
        }
        let mut of_program = |change: fn(&mut Program)| {
            let mut program = sound.clone();
            change(&mut program);
            known.push(seeds(&table, &functions, &program)[0]);
        };
        of_program(|p| p.instructions[0] = Instruction::Sub(Operand::Input(0), Operand::Input(1)));
        of_program(|p| p.instructions[0] = Instruction::Add(Operand::Input(0), Operand::Input(0)));
        of_program(|p| p.outputs[0].negative = true);
        of_program(|p| p.outputs[0].operand = Operand::Input(0));
        of_program(|p| p.inputs[1] = Symbol::Acceleration(0));
        of_program(|p| {
            p.constants.push(Constant::Symbol(Symbol::Pi));
        });
        let mut of_table = |change: fn(&mut Robot)| {
            let mut robot = table.clone();
            change(&mut robot);
            known.push(seeds(&robot, &functions, &sound)[0]);
        };
        of_table(|robot| robot.convention = Convention::Modified);
        of_table(|robot| robot.gravity[1] = Value::Pi);
        of_table(|robot| robot.rows[0].joint_type = JointType::Prismatic);
        of_table(|robot| robot.rows[0].mass = Value::integer(2));
        of_table(|robot| robot.rows[0].theta = Value::integer(2));
        of_table(|robot| robot.rows[0].alpha = Value::Pi);
        of_table(|robot| robot.rows.push(Row::new("", JointType::Revolute)));
        of_table(|robot| {
            let on = Carrier::Base;
            robot.rows.push(Row {
                on,
                ..Row::new("", JointType::Revolute)
            });
        });
        of_table(|robot| robot.rows[0].at.push(origin()));
        of_table(|robot| robot.frames.push(loaded_frame()));
        for mass in [1, 2] {
            let body = loaded_frame().body.map(|body| Body {
                mass: Value::integer(mass),
                ..body
            });
            let robot = Robot {
                base: body.map(Base::Floating),
                ..table.clone()
            };
            known.push(seeds(&robot, &functions, &sound)[0]);
        }
        let count = known.len();
        known.sort_unstable();
        known.dedup();
        assert_eq!(known.len(), count);
    }

    #[test]
    fn two_halves_are_one() {
        assert_eq!(HALF + HALF, Number::ONE);
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
