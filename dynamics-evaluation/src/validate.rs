//! Whether a description can be evaluated.

use dynamics_symbolic::robot::{Quantity, Robot, Value};

use crate::error::BuildError;

/// Refuses an arm without joints that move, and cells with fields that the robot does not have.
pub(crate) fn validate(robot: &Robot) -> Result<(), BuildError> {
    match unknown_field(robot) {
        Some(index) => Err(BuildError::NoSuchField(index)),
        None if robot.dof() == 0 => Err(BuildError::NoJoints),
        None => Ok(()),
    }
}

/// A field in a cell of the description that the robot does not have.
fn unknown_field(robot: &Robot) -> Option<usize> {
    let mut unknown = None;
    let mut visit = |value: &Value, _: Quantity| {
        value.visit_fields(&mut |index| {
            if index >= robot.fields.len() {
                unknown = Some(index);
            }
        });
    };
    for value in &robot.gravity {
        visit(value, Quantity::Number);
    }
    for row in &robot.rows {
        row.map(&mut visit);
    }
    robot.base.as_ref().map(|base| base.map(&mut visit));
    robot.tool.as_ref().map(|tool| tool.map(&mut visit));
    for frame in &robot.frames {
        frame.map(&mut visit);
    }
    unknown
}
