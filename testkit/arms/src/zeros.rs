//! Entries that are identically zero.

use dynamics_symbolic::function::Part;
use dynamics_symbolic::program::{Constant, Operand, Program};
use dynamics_symbolic::prove::Assignment;
use dynamics_symbolic::robot::Robot;

/// An output that vanishes at a random point of a prime field vanishes identically: it has to be the
/// constant 0, without a sign, so that it is 0.0 for every input, to the bit.
#[track_caller]
pub fn assert_zeros_are_constants(robot: &Robot, part: impl Into<Part>, program: &Program) {
    let part = part.into();
    let values = program.evaluate(&mut Assignment::new(robot, 0x7a65_726f));
    for (index, (value, output)) in values.iter().zip(&program.outputs).enumerate() {
        if !value.is_some_and(|x| x.is_zero()) {
            continue;
        }
        let is_zero = match output.operand {
            Operand::Constant(id) => {
                matches!(program.constants.get(id), Constant::Rational(x) if x.is_zero())
            }
            _ => false,
        };
        assert!(
            is_zero && !output.negative,
            "output {index} of {} of {robot:#?}",
            robot.name_of(part)
        );
    }
}
