//! Closed forms in JavaScript.

use super::super::comments::comment;
use super::super::javascript::JAVASCRIPT;
use super::super::{Language, indented, snake_case};
use super::{Words, description, entry_of_pose, statements};
use crate::emit::inverse::turning;
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
    joint: "const",
    direction: "const",
    is_singular: "isSingular",
    each: |name, call| vec![format!("for (const {name} of {call}) {{")],
    keep: |joints, singular| {
        let singular = if singular.is_empty() {
            "false"
        } else {
            singular
        };
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

const CONVENTIONS: [&str; 3] = [
    "pose is an array of rows, as forward_kinematics returns it. Returns an array of objects { q, isSingular }: angles",
    "from -pi to pi, rad, or m; empty if the pose is out of reach, or not finite where it is read. isSingular where two",
    "angles cannot be told apart within 1e-7 rad.",
];

fn function(robot: &Robot, frame: Option<&str>, plan: &Plan) -> String {
    let turning: Vec<_> = turning(robot).map(|turns| turns.to_string()).collect();
    let mut lines = vec![
        format!("const turning = [{}];", turning.join(", ")),
        "const solutions = [];".to_owned(),
    ];
    if plan.target != Target::Position {
        lines.push("if (!is_rotation(pose)) return solutions;".to_owned());
    }
    lines.extend(statements(robot, plan, &WORDS));
    lines.push("return solutions;".to_owned());
    let mut text = description(frame, plan);
    text.push(String::new());
    text.extend(CONVENTIONS.map(str::to_owned));
    let arm = if robot.fields.is_empty() { "" } else { "arm, " };
    let elbow = if plan.target == Target::PoseAndElbow {
        ", elbow"
    } else {
        ""
    };
    format!(
        "\n{}export function {}({arm}pose{elbow}) {{\n{}}}\n",
        comment(&text),
        inverse_method(frame),
        indented(&lines, 2)
    )
}
