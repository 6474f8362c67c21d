//! Closed forms in JavaScript.

use super::super::javascript::JAVASCRIPT;
use super::super::{Language, indented, snake_case};
use super::{Words, description, entry_of_pose, statements};
use crate::function::inverse_method;
use crate::inverse::{Plan, Target};
use crate::robot::Robot;

/// The functions that solve equations in one joint.
const SOLVERS: &str = include_str!("solvers.mjs");

const WORDS: Words = Words {
    language: Language {
        entry: entry_of_pose,
        ..JAVASCRIPT
    },
    conventions: &[
        "pose is an array of rows, as forward_kinematics returns it. Returns an array of objects { q, isSingular }: angles",
        "above -pi and up to pi, rad, or m; empty if the pose is out of reach, or not finite where it is read. isSingular where two",
        "angles cannot be told apart within 1e-7 rad.",
    ],
    turning: ["const turning = [", "];"],
    begin: "const solutions = [];",
    result: "solutions",
    joint: "const",
    direction: "const",
    is_singular: "isSingular",
    each: |name, call| vec![format!("for (const {name} of {call}) {{")],
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
