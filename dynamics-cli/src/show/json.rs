//! The joints and the functions as JSON.

use dynamics_symbolic::bounds::rounding;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Proven, Request};

use crate::convert::quoted;

/// An object with a line for each function: its operations, and the bounds of its rounding errors.
pub(super) fn json(robot: &Robot, programs: &[(Request, Proven)]) -> String {
    let joints: Vec<_> = robot.joints().map(|row| quoted(&row.name)).collect();
    let functions: Vec<_> = programs
        .iter()
        .map(|(request, proven)| function(robot, request, proven))
        .collect();
    format!(
        "{{\n  \"name\": {},\n  \"dof\": {},\n  \"joints\": [{}],\n  \"functions\": [\n{}\n  ]\n}}\n",
        quoted(&robot.name),
        robot.dof(),
        joints.join(", "),
        functions.join(",\n")
    )
}

fn function(robot: &Robot, request: &Request, proven: &Proven) -> String {
    let operations = proven.program.operations();
    let found = rounding(robot, request, proven);
    let [double, single] = found.map_or([f64::INFINITY; 2], |found| found.largest());
    let bound = |bound: f64| match bound.is_finite() {
        true => format!("{bound:e}"),
        false => "null".to_owned(),
    };
    format!(
        "    {{\"name\": {}, \"multiplications\": {}, \"additions\": {}, \"divisions\": {}, \"sin_cos\": {}, \
         \"rounding\": {{\"double\": {}, \"single\": {}}}}}",
        quoted(request.name()),
        operations.multiplications,
        operations.additions,
        operations.divisions,
        operations.sin_cos,
        bound(double),
        bound(single)
    )
}
