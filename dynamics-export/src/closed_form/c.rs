//! Closed forms in C99.

use super::{Words, description, elbow_statements, entry_of_pose, needed, statements};
use crate::body::opposite;
use crate::c::precision::Precision;
use crate::c::{CNumbers, DEVICE, string};
use crate::comments::comment;
use crate::names::snake_case;
use crate::syntax::{Syntax, indented};
use dynamics_symbolic::function::{ELBOW_METHODS, elbow_method, inverse_method};
use dynamics_symbolic::inverse::{Plan, Target};
use dynamics_symbolic::robot::{JointType, Robot, Row};

/// The functions that solve equations in one joint, and those that choose among solutions.
const SOLVERS: &str = include_str!("solvers.c");

/// The declarations of the functions that choose.
const CHOICE: &str = include_str!("choice.h");

const WORDS: Words = Words {
    branches: |names| {
        let names: Vec<_> = names.iter().map(|name| string(name)).collect();
        format!(
            "static const char *const branches[] = {{{}}};",
            names.join(", ")
        )
    },
    begin: "int count = 0;",
    begin_tries: "REAL miss = NO_TRY;",
    pose: |reads_rotation, elbow| {
        let reads = u8::from(reads_rotation);
        let elbow = elbow.map_or(String::new(), |elbow| format!(" || !is_finite({elbow})"));
        vec![
            "REAL at[4][4];".to_owned(),
            format!("if (!nearest_pose(pose, {reads}, at){elbow}) return -2;"),
        ]
    },
    end: "return count > 0 ? count : -1;",
    joint: "const found",
    direction: "const direction_of",
    is_singular: "is_singular",
    is_second: "is_second",
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
            format!("family {name}_family;"),
            format!("family_of(&{name}_family, {call});"),
            format!("while (next(&{name}_family, &count, &miss)) {{"),
            format!("  const found {name} = {name}_family.joint;"),
        ]
    },
    keep: |joints, singular, branch| {
        let (count, joints) = (joints.len(), joints.join(", "));
        vec![
            format!("const found joints[{count}] = {{{joints}}};"),
            format!("if (branch) branch[count] = branches[{branch}];"),
            format!("count += keep(joints, {singular}, q[count], &is_singular[count]);"),
        ]
    },
    elbow: |vectors, size| {
        let names = ["line", "elbow", "axis"].into_iter().zip(vectors);
        let arrays = names.map(|(name, vector)| {
            let constant = if name == "line" { "" } else { "const " };
            format!("{constant}REAL {name}[3] = {{{}}};", vector.join(", "))
        });
        let returned = format!("return angle_of_elbow(line, elbow, axis, {size});");
        arrays.chain([returned]).collect()
    },
};

/// The numbers of a precision. The first three are the runtime's: angles that cannot be told apart, how nearly a pose is reached, and
/// a last row 0, 0, 0, 1. Then come the distance from 1 to the next number and the largest number. The last is one and a half times
/// the number from which on all are integers.
struct Numbers {
    precision: &'static Precision,
    words: [(&'static str, &'static str); 6],
    arc_tangent: &'static str,
    infinity: &'static str,
}

impl Numbers {
    fn new(numbers: CNumbers) -> Self {
        let precision = numbers.precision();
        if precision.syntax.is_single {
            return Numbers {
                precision,
                words: [
                    ("AS_APART", "1e-3f"),
                    ("AS_REACHED", "1e-4f"),
                    ("AS_LAST_ROW", "1e-3f"),
                    ("AS_EPSILON", "1.1920929e-7f"),
                    ("AS_LARGEST", "3.4028235e38f"),
                    ("AS_ROUNDER", "12582912.0f"),
                ],
                arc_tangent: include_str!("arc_tangent_single.c"),
                infinity: "HUGE_VALF",
            };
        }
        Numbers {
            precision,
            words: [
                ("AS_APART", "1e-7"),
                ("AS_REACHED", "1e-9"),
                ("AS_LAST_ROW", "1e-6"),
                ("AS_EPSILON", "2.220446049250313e-16"),
                ("AS_LARGEST", "1.7976931348623157e308"),
                ("AS_ROUNDER", "6755399441055744.0"),
            ],
            arc_tangent: include_str!("arc_tangent.c"),
            infinity: "HUGE_VAL",
        }
    }

    fn syntax(&self) -> &'static Syntax {
        &self.precision.syntax
    }

    /// The lines of a function's comment about its arguments and its results.
    fn conventions(&self) -> Vec<String> {
        let apart = if self.syntax().is_single {
            "1e-3"
        } else {
            "1e-7"
        };
        let sines = match self.syntax().of_angles.is_some() {
            true => {
                "Solutions have the digits of Rust's in a build for the same processor. Nothing is allocated, no state is kept."
            }
            false => "Sines are those of the C library. Nothing is allocated, no state is kept.",
        };
        let lines = [
            "pose has rows, as forward_kinematics writes them; q angles, above -pi and up to pi, rad, or m. Returns the number of",
            "solutions, whose joint positions it writes into the rows of q; -1 if the pose is out of reach, -2 if it is none: a number is",
            "not finite that is read, the last row is not 0, 0, 0, 1, or the rotation is none to 1e-3. The nearest rotation is taken.",
            &format!(
                "is_singular is 1 where two angles cannot be told apart within {apart} rad; one that is free is the nearest to zero in"
            ),
            "reach.",
            sines,
        ];
        lines.map(str::to_owned).to_vec()
    }

    /// The functions that others need, in this precision.
    fn solvers(&self, bodies: &str, robot: &Robot, name: &str) -> String {
        let sines = self.syntax().sine_and_cosine("by", ["s", "c"]).join(" ");
        let root = match self.syntax().is_single {
            true => "ROBOT_DYNAMICS_SQRTF",
            false => "ROBOT_DYNAMICS_SQRT",
        };
        let text = self.precision.text(&(self.of_joints(robot) + SOLVERS));
        let text = text.replace("ARC_TANGENT\n", self.arc_tangent);
        let text = of_robot(&text.replace("SQRT(", &format!("{root}(")), robot, name);
        let text = text.replace("SINES", &sines);
        let words = self.words.iter();
        let text = words.fold(text, |text, (word, own)| text.replace(word, own));
        needed(&text, bodies)
    }

    /// The list of the joints that turn.
    fn of_joints(&self, robot: &Robot) -> String {
        let joints = robot.joints();
        let turn = joints.map(|row| u8::from(row.joint_type == JointType::Revolute).to_string());
        let turn: Vec<_> = turn.collect();
        format!(
            "/* The joints that turn. */\nstatic const int turning[] = {{{}}};\n\n",
            turn.join(", ")
        )
    }

    /// The definition of the joints' ranges.
    fn limits(&self, robot: &Robot, upper: &str) -> String {
        let rows: Vec<_> = robot.joints().map(|row| self.range(row)).collect();
        let infinite = if rows.iter().any(|row| row.contains(self.infinity)) {
            format!(
                ": infinite, by {} of math.h, where the table has none",
                self.infinity
            )
        } else {
            String::new()
        };
        format!(
            "/** Ranges of the joints' positions, lower ends first, rad or m{infinite}. */\n\
             #define {upper}_JOINT_LIMITS {{{}}}\n",
            rows.join(", ")
        )
    }

    fn range(&self, row: &Row) -> String {
        let infinity = self.infinity.to_owned();
        let [lower, upper] = match &row.limits {
            Some(limits) => limits
                .each_ref()
                .map(|limit| (self.syntax().number)(limit.to_f64(&[]))),
            None => [opposite(&infinity), infinity],
        };
        format!("{{{lower}, {upper}}}")
    }
}

/// A text with the number of joints, and the name of the robot.
fn of_robot(text: &str, robot: &Robot, name: &str) -> String {
    text.replace("JOINTS", &robot.dof().to_string())
        .replace("NAME_", &format!("{name}_"))
}

/// Names and texts of the header and of the source of inverse kinematics for frames, or for the tip, each with its plan.
pub fn inverse_in_c(
    robot: &Robot,
    plans: &[(Option<&str>, Plan)],
    numbers: CNumbers,
) -> [(String, String); 2] {
    let name = snake_case(&robot.name);
    let upper = name.to_uppercase();
    let numbers = Numbers::new(numbers);
    let functions = plans.iter().map(|(frame, plan)| Function {
        robot,
        name: &name,
        frame: *frame,
        plan,
        numbers: &numbers,
    });
    let functions: Vec<_> = functions.collect();
    let include = (!robot.fields.is_empty()).then(|| format!("#include \"{name}.h\"\n\n"));
    let limits = numbers.limits(robot, &upper);
    let declarations: String = functions.iter().map(Function::declarations).collect();
    let choice = numbers.precision.text(&of_robot(CHOICE, robot, &name));
    let header = format!(
        "#ifndef {upper}_INVERSE_H\n#define {upper}_INVERSE_H\n\n{}{limits}\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\
         {declarations}{choice}\n#ifdef __cplusplus\n}}\n#endif\n\n#endif\n",
        include.unwrap_or_default()
    );
    let bodies: String = functions.iter().map(Function::definitions).collect();
    let bodies = numbers.precision.text(&bodies);
    let solvers = numbers.solvers(&bodies, robot, &name);
    let library = numbers.precision.functions(&(solvers.clone() + &bodies));
    let device = match library.contains("ROBOT_DYNAMICS_DEVICE") {
        true => DEVICE,
        false => "",
    };
    let source = format!("#include \"{name}_inverse.h\"\n\n{device}{library}\n{solvers}{bodies}");
    [
        (format!("{name}_inverse.h"), header),
        (format!("{name}_inverse.c"), source),
    ]
}

/// The functions of a frame, or of the tip.
struct Function<'a> {
    robot: &'a Robot,
    name: &'a str,
    frame: Option<&'a str>,
    plan: &'a Plan,
    numbers: &'a Numbers,
}

impl Function<'_> {
    /// The first argument, which has fields: its type, and its name.
    fn arm(&self) -> [String; 2] {
        match self.robot.fields.is_empty() {
            true => ["", ""].map(str::to_owned),
            false => [format!("const {}_fields *", self.name), "arm, ".to_owned()],
        }
    }

    /// The signatures without names of branches and with these.
    fn signatures(&self) -> [String; 2] {
        let (joints, most) = (self.plan.joints, self.plan.most());
        let word = self.numbers.precision.word;
        let elbow = match self.plan.target {
            Target::PoseAndElbow => format!("{word} elbow, "),
            _ => String::new(),
        };
        let arm = self.arm().concat();
        let written = format!(
            "{arm}const {word} pose[4][4], {elbow}{word} q[{most}][{joints}], int is_singular[{most}]"
        );
        let method = inverse_method(self.frame);
        let name = self.name;
        [
            format!("int {name}_{method}({written})"),
            format!("int {name}_{method}_with_branches({written}, const char *branch[{most}])"),
        ]
    }

    fn signature_of_elbow(&self) -> Option<String> {
        let method = elbow_method(ELBOW_METHODS[0], self.frame);
        let (name, arm, word) = (self.name, self.arm().concat(), self.numbers.precision.word);
        self.plan
            .elbow
            .as_ref()
            .map(|_| format!("{word} {name}_{method}({arm}const {word} q[7])"))
    }

    fn declarations(&self) -> String {
        let lines = description(self.frame, self.plan, &self.numbers.conventions());
        let [plain, with_branches] = self.signatures();
        let elbow = self.signature_of_elbow().map(|signature| {
            let method = inverse_method(self.frame);
            let comment = comment(&[format!(
                "The angle of the elbow, rad, by which {method} finds these joint positions."
            )]);
            format!("\n{comment}{signature};\n")
        });
        format!(
            "\n{lines}{plain};\n\n/** The same, with the name of each solution's branch. */\n{with_branches};\n{}",
            elbow.unwrap_or_default()
        )
    }

    fn definitions(&self) -> String {
        let [plain, with_branches] = self.signatures();
        let of_elbow = matches!(self.plan.target, Target::PoseAndElbow);
        let (name, method, [_, arm]) = (self.name, inverse_method(self.frame), self.arm());
        let elbow = if of_elbow { "elbow, " } else { "" };
        let syntax = Syntax {
            entry: entry_of_pose,
            ..*self.numbers.syntax()
        };
        let body = indented(&statements(self.robot, self.plan, &WORDS, &syntax), 4);
        let signature = self.signature_of_elbow();
        let angle = signature.zip(elbow_statements(
            self.robot,
            self.plan,
            &WORDS,
            self.numbers.syntax(),
        ));
        let angle = angle
            .map(|(signature, lines)| format!("\n{signature}\n{{\n{}}}\n", indented(&lines, 4)));
        format!(
            "\n{with_branches}\n{{\n{body}}}\n\n{plain}\n{{\n    \
             return {name}_{method}_with_branches({arm}pose, {elbow}q, is_singular, 0);\n}}\n{}",
            angle.unwrap_or_default()
        )
    }
}
