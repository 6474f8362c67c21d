//! Inverse kinematics in closed form as C99 and JavaScript, each in a file of its own with the functions that solve its
//! equations. It is a loop over the solutions of each step inside that of the step before, as the Rust method has it.

mod c;
mod javascript;

pub use c::inverse_in_c;
pub use javascript::inverse_in_javascript;

use crate::body::Body;
use crate::comments::comment;
use crate::syntax::Syntax;
use dynamics_symbolic::emit::description_of_inverse;
use dynamics_symbolic::inverse::{ELBOW, Plan, Step, Target};
use dynamics_symbolic::robot::{JointType, Robot, Symbol};

/// How a language writes the steps.
struct Words {
    syntax: Syntax,
    /// The lines of a function's comment about its arguments and its results.
    conventions: &'static [&'static str],
    /// The text around the list of joints that turn, with 1 for each that does.
    turning: [&'static str; 2],
    /// The declaration of the result, and of what families note besides.
    begin: &'static str,
    begin_tries: &'static str,
    /// The statements that read the pose, and return if it is none: whether its rotation is read, and the name of the elbow's
    /// angle if there is one.
    pose: fn(bool, Option<&str>) -> Vec<String>,
    /// The statement that returns the result.
    end: &'static str,
    /// The beginning of the declaration of a joint that was found, and of a direction.
    joint: &'static str,
    direction: &'static str,
    /// The beginning of a loop in which the joint of that name is each of the solutions of a call.
    each: fn(&str, &str) -> Vec<String>,
    /// A call for roots of which is noted how far it is from having one.
    noted: fn(&str) -> String,
    /// The beginning of a loop over the family of a joint, which is the value of a call.
    family: fn(&str, &str) -> Vec<String>,
    /// The part of a direction that says whether it is singular.
    is_singular: &'static str,
    /// The statements that keep a solution: its joints, and whether it is singular besides.
    keep: fn(&[String], &str) -> Vec<String>,
}

struct Writer<'a> {
    plan: &'a Plan,
    words: &'a Words,
    body: Body<'a>,
    /// For each line the number of steps that must be done before it.
    stages: Vec<usize>,
}

/// The statements of a function.
fn statements(robot: &Robot, plan: &Plan, words: &Words) -> Vec<String> {
    let proven = plan.proven();
    let writer = Writer {
        plan,
        words,
        body: Body::new(robot, &proven, &words.syntax),
        stages: plan.stages(),
    };
    let joints = robot.joints();
    let turning = joints.map(|row| u8::from(row.joint_type == JointType::Revolute).to_string());
    let turning: Vec<_> = turning.collect();
    let [before, behind] = words.turning;
    let turning = format!("{before}{}{behind}", turning.join(", "));
    let mut statements = vec![turning, words.begin.to_owned()];
    if plan.has_families() {
        statements.push(words.begin_tries.to_owned());
    }
    let elbow = (plan.target == Target::PoseAndElbow).then_some("elbow");
    statements.extend((words.pose)(plan.target != Target::Position, elbow));
    statements.extend(writer.inputs());
    writer.from(0, &[], 0, &mut statements);
    statements.push(words.end.to_owned());
    statements
}

/// The comment on a function.
fn description(frame: Option<&str>, plan: &Plan, words: &Words) -> String {
    let first = description_of_inverse(frame, plan);
    let mut lines = vec![first.trim().replace('`', ""), String::new()];
    lines.extend(words.conventions.iter().map(|line| (*line).to_owned()));
    comment(&lines)
}

/// The name of a joint that was found.
fn joint(number: usize) -> String {
    format!("joint_{}", number + 1)
}

impl Writer<'_> {
    /// Fields, sines of angles that are made of them, and what is read of the arguments.
    fn inputs(&self) -> Vec<String> {
        let is_known = |symbol: &Symbol| match symbol {
            Symbol::Sine(_) | Symbol::Cosine(_) | Symbol::Position(_) => false,
            Symbol::Entry(_, place) => *place < ELBOW,
            _ => true,
        };
        let mut inputs = self.body.inputs_that(is_known);
        if self.plan.target == Target::PoseAndElbow {
            let Syntax { sine, cosine, .. } = self.words.syntax;
            for (place, function) in [(ELBOW, sine), (ELBOW + 1, cosine)] {
                let value = format!("{function}(elbow)");
                inputs.push((self.words.syntax.declare)(&self.number(place), &value));
            }
        }
        inputs
    }

    /// The variable of a number behind the entries of the pose.
    fn number(&self, place: usize) -> String {
        format!("pose_{}", place + 1)
    }

    /// A step and all behind it, so many blocks deep. `singular` has conditions by which a solution is marked.
    fn from(&self, step: usize, singular: &[String], depth: usize, text: &mut Vec<String>) {
        let indent = "  ".repeat(depth);
        let mut push = |lines: Vec<String>| {
            text.extend(lines.into_iter().map(|line| format!("{indent}{line}")));
        };
        push(self.body.lines_that(|line| self.stages[line] == step));
        let Some(&current) = self.plan.steps.get(step) else {
            let joints: Vec<_> = (0..self.plan.joints).map(joint).collect();
            let singular = match singular {
                [] => "0".to_owned(),
                _ => singular.join(" || "),
            };
            push((self.words.keep)(&joints, &singular));
            return;
        };
        let outputs = self.plan.outputs_of(step);
        let coefficients: Vec<_> = outputs.map(|k| self.body.output_of(k)).collect();
        let call = format!("{}({})", current.name(), coefficients.join(", "));
        match current {
            Step::Condition => push(vec![format!("if ({call}) {{")]),
            Step::Direction(place) => {
                let name = format!("direction_{}", place + 1);
                push(vec![format!("{} {name} = {call};", self.words.direction)]);
                push(self.bound(current, &name));
                let mark = format!("{name}.{}", self.words.is_singular);
                let singular = [singular, &[mark]].concat();
                return self.from(step + 1, &singular, depth, text);
            }
            Step::Joint(number, _) => {
                let name = joint(number);
                let bound = self.bound(current, &name);
                let inner = |lines: Vec<String>| lines.into_iter().map(|line| format!("  {line}"));
                let has_family = self.plan.has_family(step);
                let is_single = current.solutions() == 1;
                if is_single && !has_family {
                    push(vec![format!("{} {name} = {call};", self.words.joint)]);
                    push(bound);
                    return self.from(step + 1, singular, depth, text);
                }
                let call = match self.plan.families_before(step)[..] {
                    [] => call,
                    _ => (self.words.noted)(&call),
                };
                if has_family && !is_single {
                    // A loop over roots, and over the family of each.
                    let root = format!("root_{}", number + 1);
                    push((self.words.each)(&root, &call));
                    push(inner((self.words.family)(&name, &root)).collect());
                    push(inner(bound).map(|line| format!("  {line}")).collect());
                    self.from(step + 1, singular, depth + 2, text);
                    text.extend([format!("{indent}  }}"), format!("{indent}}}")]);
                    return;
                }
                let words = self.words;
                let each = if is_single { words.family } else { words.each };
                push(each(&name, &call));
                push(inner(bound).collect());
            }
        }
        self.from(step + 1, singular, depth + 1, text);
        text.push(format!("{indent}}}"));
    }

    /// Parts of the solution of a step, where they are read.
    fn bound(&self, step: Step, of: &str) -> Vec<String> {
        let declare = |(index, part): (usize, &str)| {
            (self.words.syntax.declare)(self.body.input_name(index), &format!("{of}.{part}"))
        };
        self.plan.inputs_of(step).map(declare).collect()
    }
}

/// An entry of the pose that is taken, an array of rows.
fn entry_of_pose(_: &str, entry: usize) -> String {
    let (row, column) = Plan::place_in_pose(entry);
    format!("at[{row}][{column}]")
}
