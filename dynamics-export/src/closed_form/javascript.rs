//! Closed forms in JavaScript.

use super::{Words, description, elbow_statements, entry_of_pose, needed, statements};
use crate::comments::comment;
use crate::javascript::JAVASCRIPT;
use crate::names::snake_case;
use crate::syntax::{Angle, Syntax, indented};
use dynamics_symbolic::function::{ELBOW_METHODS, elbow_method, inverse_method};
use dynamics_symbolic::inverse::{Plan, Target};
use dynamics_symbolic::robot::{JointType, Robot, Value};

/// The functions that solve equations in one joint, and those that choose among solutions.
const SOLVERS: &str = include_str!("solvers.mjs");

/// Sines are those of the module.
const OF_JOINTS: Syntax = Syntax {
    of_angles: Some(|angles| angles.iter().map(sine_and_cosine).collect()),
    ..JAVASCRIPT
};

const OF_POSES: Syntax = Syntax {
    entry: entry_of_pose,
    ..OF_JOINTS
};

const CONVENTIONS: [&str; 6] = [
    "pose is an array of rows, as forward_kinematics returns it. Returns an array of objects { q, isSingular, branch }: angles",
    "above -pi and up to pi, rad, or m. Its property count is how many there are; -1 if the pose is out of reach, -2 if it is",
    "none: a number is not finite that is read, the last row is not 0, 0, 0, 1, or the rotation is none to 1e-3. The nearest",
    "rotation is taken. isSingular where two angles cannot be told apart within 1e-7 rad; one that is free is the nearest to",
    "zero in reach. Solutions have the digits of a Rust build without fused instructions, if fields have no angles and the",
    "elbow's is below 1e5 rad.",
];

const WORDS: Words = Words {
    branches: |names| format!("const branches = {names:?};"),
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
    is_second: "isSecond",
    each: |name, call| vec![format!("for (const {name} of {call}) {{")],
    noted: |call| format!("noted({call}, tries)"),
    family: |name, call| {
        vec![format!(
            "for (const {name} of family({call}, solutions, tries)) {{"
        )]
    },
    keep: |joints, singular, branch| {
        let joints = joints.join(", ");
        vec![format!(
            "keep(solutions, [{joints}], {singular}, branches[{branch}]);"
        )]
    },
    elbow: |vectors, size| {
        let vectors = vectors.map(|vector| format!("[{}]", vector.join(", ")));
        vec![format!(
            "return angle_of_elbow({}, {size});",
            vectors.join(", ")
        )]
    },
};

fn sine_and_cosine(angle: &Angle) -> String {
    let name = |name: &Option<String>| name.clone().unwrap_or_default();
    let [sine, cosine] = [&angle.sine, &angle.cosine].map(name);
    format!(
        "const [{sine}, {cosine}] = sine_and_cosine({});",
        angle.value
    )
}

/// Name and text of the module of inverse kinematics for frames, or for the tip, each with its plan.
pub fn inverse_in_javascript(robot: &Robot, plans: &[(Option<&str>, Plan)]) -> (String, String) {
    let bodies: String = plans
        .iter()
        .map(|(frame, plan)| functions(robot, *frame, plan))
        .collect();
    let name = format!("{}_inverse.mjs", snake_case(&robot.name));
    let solvers = needed(SOLVERS, &bodies);
    (name, format!("{}\n{solvers}{bodies}", of_joints(robot)))
}

/// The joints that turn, and the ranges of all.
fn of_joints(robot: &Robot) -> String {
    let turn = robot
        .joints()
        .map(|row| row.joint_type == JointType::Revolute);
    let range = |limits: &Option<[Value; 2]>| match limits {
        None => "null".to_owned(),
        Some([lower, upper]) => format!("[{:?}, {:?}]", lower.to_f64(&[]), upper.to_f64(&[])),
    };
    let ranges: Vec<_> = robot.joints().map(|row| range(&row.limits)).collect();
    format!(
        "const TURNING = {:?};\n\n\
         /** Ranges of the joints' positions, lower ends first, rad or m, where the table has them. */\n\
         export const JOINT_LIMITS = [{}];\n",
        turn.collect::<Vec<_>>(),
        ranges.join(", ")
    )
}

/// The functions of a frame, or of the tip.
fn functions(robot: &Robot, frame: Option<&str>, plan: &Plan) -> String {
    let arm = if robot.fields.is_empty() { "" } else { "arm, " };
    let has_elbow = plan.target == Target::PoseAndElbow;
    let elbow = if has_elbow { ", elbow" } else { "" };
    let method = inverse_method(frame);
    let inverse = format!(
        "\n{}export function {method}({arm}pose{elbow}) {{\n{}}}\n",
        description(frame, plan, &CONVENTIONS.map(str::to_owned)),
        indented(&statements(robot, plan, &WORDS, &OF_POSES), 2)
    );
    let angle = elbow_statements(robot, plan, &WORDS, &OF_JOINTS).map(|lines| {
        format!(
            "\n{}export function {}({arm}q) {{\n{}}}\n",
            comment(&[format!(
                "The angle of the elbow, rad, by which {method} finds these joint positions."
            )]),
            elbow_method(ELBOW_METHODS[0], frame),
            indented(&lines, 2)
        )
    });
    inverse + &angle.unwrap_or_default()
}
