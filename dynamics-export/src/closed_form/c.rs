//! Closed forms in C99.

use super::{Words, description, entry_of_pose, statements};
use crate::c::precision::OF_DOUBLE;
use crate::names::snake_case;
use crate::syntax::{Syntax, indented};
use dynamics_symbolic::function::inverse_method;
use dynamics_symbolic::inverse::{Plan, Target};
use dynamics_symbolic::robot::Robot;

/// The functions that solve equations in one joint.
const SOLVERS: &str = include_str!("solvers.c");

const WORDS: Words = Words {
    syntax: Syntax {
        entry: entry_of_pose,
        sine: "sin",
        cosine: "cos",
        fused: None,
        ..OF_DOUBLE
    },
    conventions: &[
        "pose has rows, as forward_kinematics writes them; q angles, above -pi and up to pi, rad, or m. Returns the number of",
        "solutions, whose joint positions it writes into the rows of q; -1 if the pose is out of reach, -2 if it is none: a number is",
        "not finite that is read, the last row is not 0, 0, 0, 1, or the rotation is none to 1e-3. The nearest rotation is taken.",
        "is_singular is 1 where two angles cannot be told apart within 1e-7 rad; one that is free is the nearest to zero in reach.",
        "Nothing is allocated, no state is kept.",
        "Sines, arc tangents and roots are those of math.h.",
    ],
    turning: ["static const int turning[] = {", "};"],
    begin: "int count = 0;",
    begin_tries: "double miss = NO_TRY;",
    pose: |reads_rotation, elbow| {
        let reads = u8::from(reads_rotation);
        let elbow = elbow.map_or(String::new(), |elbow| format!(" || !isfinite({elbow})"));
        vec![
            "double at[4][4];".to_owned(),
            format!("if (!nearest_pose(pose, {reads}, at){elbow}) return -2;"),
        ]
    },
    end: "return count > 0 ? count : -1;",
    joint: "const found",
    direction: "const direction_of",
    is_singular: "is_singular",
    each: |name, call| {
        vec![
            format!("const roots {name}_roots = {call};"),
            format!("for (int {name}_k = 0; {name}_k < {name}_roots.count; ++{name}_k) {{"),
            format!("  const found {name} = {name}_roots.both[{name}_k];"),
        ]
    },
    noted: |call| format!("noted({call}, &miss)"),
    family: |name, call| {
        vec![
            format!("family {name}_family = family_of({call});"),
            format!("while (next(&{name}_family, &count, &miss)) {{"),
            format!("  const found {name} = {name}_family.joint;"),
        ]
    },
    keep: |joints, singular| {
        vec![
            format!(
                "const found joints[{}] = {{{}}};",
                joints.len(),
                joints.join(", ")
            ),
            format!(
                "count += keep(joints, turning, {}, {singular}, q[count], &is_singular[count]);",
                joints.len()
            ),
        ]
    },
};

/// Names and texts of the header and of the source of inverse kinematics for frames, or for the tip, each with its plan.
pub fn inverse_in_c(robot: &Robot, plans: &[(Option<&str>, Plan)]) -> [(String, String); 2] {
    let name = snake_case(&robot.name);
    let upper = name.to_uppercase();
    let has_fields = !robot.fields.is_empty();
    let include = has_fields.then(|| format!("#include \"{name}.h\"\n\n"));
    let declarations: String = plans
        .iter()
        .map(|(frame, plan)| {
            let comment = description(*frame, plan, &WORDS);
            format!("\n{comment}{};\n", signature(robot, &name, *frame, plan))
        })
        .collect();
    let header = format!(
        "#ifndef {upper}_INVERSE_H\n#define {upper}_INVERSE_H\n\n{}#ifdef __cplusplus\nextern \"C\" {{\n#endif\n{declarations}\n\
         #ifdef __cplusplus\n}}\n#endif\n\n#endif\n",
        include.unwrap_or_default()
    );
    let bodies: String = plans
        .iter()
        .map(|(frame, plan)| function(robot, &name, *frame, plan))
        .collect();
    let source = format!("#include \"{name}_inverse.h\"\n{SOLVERS}{bodies}");
    [
        (format!("{name}_inverse.h"), header),
        (format!("{name}_inverse.c"), source),
    ]
}

fn signature(robot: &Robot, name: &str, frame: Option<&str>, plan: &Plan) -> String {
    let arm = (!robot.fields.is_empty()).then(|| format!("const {name}_fields *arm, "));
    let elbow = (plan.target == Target::PoseAndElbow).then_some("double elbow, ");
    let (joints, most) = (plan.joints, plan.most());
    format!(
        "int {name}_{}({}const double pose[4][4], {}double q[{most}][{joints}], int is_singular[{most}])",
        inverse_method(frame),
        arm.unwrap_or_default(),
        elbow.unwrap_or_default()
    )
}

fn function(robot: &Robot, name: &str, frame: Option<&str>, plan: &Plan) -> String {
    format!(
        "\n{}\n{{\n{}}}\n",
        signature(robot, name, frame, plan),
        indented(&statements(robot, plan, &WORDS), 4)
    )
}
