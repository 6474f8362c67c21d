//! Closed forms in JavaScript.

use super::{Words, description, entry_of_pose, statements};
use crate::javascript::JAVASCRIPT;
use crate::names::snake_case;
use crate::syntax::{Syntax, indented};
use dynamics_symbolic::function::inverse_method;
use dynamics_symbolic::inverse::{Plan, Target};
use dynamics_symbolic::robot::Robot;

/// The functions that solve equations in one joint.
const SOLVERS: &str = include_str!("solvers.mjs");

const WORDS: Words = Words {
    syntax: Syntax {
        entry: entry_of_pose,
        ..JAVASCRIPT
    },
    conventions: &[
        "pose is an array of rows, as forward_kinematics returns it. Returns an array of objects { q, isSingular }: angles",
        "above -pi and up to pi, rad, or m. Its property count is how many there are; -1 if the pose is out of reach, -2 if it is",
        "none: a number is not finite that is read, the last row is not 0, 0, 0, 1, or the rotation is none to 1e-3. The nearest",
        "rotation is taken. isSingular where two angles cannot be told apart within 1e-7 rad; one that is free is the nearest to",
        "zero in reach.",
    ],
    turning: ["const turning = [", "];"],
    begin: "const solutions = [];",
    begin_tries: "const tries = { miss: NO_TRY };",
    pose: |reads_rotation, elbow| {
        let elbow = elbow.map_or(String::new(), |elbow| {
            format!(" || !Number.isFinite({elbow})")
        });
        vec![
            format!("const at = nearest_pose(pose, {reads_rotation});"),
            format!("if (!at{elbow}) return counted(solutions, -2);"),
        ]
    },
    end: "return counted(solutions, -1);",
    joint: "const",
    direction: "const",
    is_singular: "isSingular",
    each: |name, call| vec![format!("for (const {name} of {call}) {{")],
    noted: |call| format!("noted({call}, tries)"),
    family: |name, call| {
        vec![format!(
            "for (const {name} of family({call}, solutions, tries)) {{"
        )]
    },
    keep: |joints, singular| {
        vec![format!(
            "keep(solutions, [{}], turning, {singular});",
            joints.join(", ")
        )]
    },
};

/// Name and text of the module of inverse kinematics for frames, or for the tip, each with its plan.
pub fn inverse_in_javascript(robot: &Robot, plans: &[(Option<&str>, Plan)]) -> (String, String) {
    let bodies: String = plans
        .iter()
        .map(|(frame, plan)| function(robot, *frame, plan))
        .collect();
    let name = format!("{}_inverse.mjs", snake_case(&robot.name));
    (name, format!("{SOLVERS}{bodies}"))
}

fn function(robot: &Robot, frame: Option<&str>, plan: &Plan) -> String {
    let arm = if robot.fields.is_empty() { "" } else { "arm, " };
    let has_elbow = plan.target == Target::PoseAndElbow;
    let elbow = if has_elbow { ", elbow" } else { "" };
    format!(
        "\n{}export function {}({arm}pose{elbow}) {{\n{}}}\n",
        description(frame, plan, &WORDS),
        inverse_method(frame),
        indented(&statements(robot, plan, &WORDS), 2)
    )
}
