//! Inverse kinematics in closed form as C99 and JavaScript, each in a file of its own with the functions that solve its
//! equations and choose among solutions. It is a loop over the solutions of each step inside that of the step before, as the Rust method has it.

mod c;
mod javascript;

pub use c::inverse_in_c;
pub use javascript::inverse_in_javascript;

use crate::body::Body;
use crate::comments::comment;
use crate::syntax::Syntax;
use dynamics_symbolic::emit::description_of_inverse;
use dynamics_symbolic::inverse::{ELBOW, Plan, Step, Target};
use dynamics_symbolic::robot::{Robot, Symbol};

/// How a language writes the steps.
struct Words {
    /// The list of the names of branches.
    branches: fn(&[String]) -> String,
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
    /// The part of a direction that says whether it is singular, and the one of a joint that says whether it is a second root.
    is_singular: &'static str,
    is_second: &'static str,
    /// The statements that keep a solution: its joints, whether it is singular besides, and the number of its branch.
    keep: fn(&[String], &str, &str) -> Vec<String>,
    /// The statements that return an elbow's angle: the entries of three vectors, and their size.
    elbow: fn([&[String]; 3], &str) -> Vec<String>,
}

struct Writer<'a> {
    plan: &'a Plan,
    words: &'a Words,
    syntax: &'a Syntax,
    body: Body<'a>,
    /// For each line the number of steps that must be done before it.
    stages: Vec<usize>,
}

/// The statements of a function.
fn statements(robot: &Robot, plan: &Plan, words: &Words, syntax: &Syntax) -> Vec<String> {
    let proven = plan.proven();
    let writer = Writer {
        plan,
        words,
        syntax,
        body: Body::new(robot, &proven, syntax),
        stages: plan.stages(),
    };
    let mut statements = vec![
        (words.branches)(&plan.branches.names),
        words.begin.to_owned(),
    ];
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

/// The statements of the function of seven joints that returns the angle of their elbow.
fn elbow_statements(
    robot: &Robot,
    plan: &Plan,
    words: &Words,
    syntax: &Syntax,
) -> Option<Vec<String>> {
    let proven = plan.proven_elbow()?;
    let body = Body::new(robot, &proven, syntax);
    let numbers: Vec<_> = (0..10).map(|k| body.output_of(k)).collect();
    let vectors = [&numbers[0..3], &numbers[3..6], &numbers[6..9]];
    let mut statements = body.inputs_that(|_| true);
    statements.extend(body.lines_that(|_| true));
    statements.extend((words.elbow)(vectors, &numbers[9]));
    Some(statements)
}

/// The comment on a function, in which lines about arguments and results follow.
fn description(frame: Option<&str>, plan: &Plan, conventions: &[String]) -> String {
    let first = description_of_inverse(frame, plan);
    let mut lines = vec![first.trim().replace('`', ""), String::new()];
    lines.extend_from_slice(conventions);
    comment(&lines)
}

/// The blocks of a text, apart by empty lines, that functions behind them need.
fn needed(text: &str, functions: &str) -> String {
    let mut code = functions.to_owned();
    let mut kept = Vec::new();
    for block in text
        .trim_end()
        .split("\n\n")
        .collect::<Vec<_>>()
        .into_iter()
        .rev()
    {
        let statement = match block.strip_prefix("/*") {
            Some(comment) => comment.split_once("*/").map_or("", |(_, rest)| rest),
            None => block,
        };
        if defined(statement.trim_start()).is_none_or(|name| has_word(&code, name)) {
            code.push_str(statement);
            kept.push(block);
        }
    }
    kept.reverse();
    kept.join("\n\n") + "\n"
}

/// The name that a statement of C or JavaScript gives something that only its own file knows.
fn defined(statement: &str) -> Option<&str> {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let first = |text: &'_ str| text.find(|c| !is_letter(c)).unwrap_or(text.len());
    let (word, rest) = statement.split_once(' ')?;
    match word {
        "#define" | "const" => Some(&rest[..first(rest)]),
        "typedef" | "enum" => Some(statement.trim_end_matches(';').rsplit(' ').next()?),
        "static" | "function" | "function*" => {
            let head = rest.split(['(', '[']).next()?;
            head.split(|c| !is_letter(c)).rfind(|name| !name.is_empty())
        }
        _ => None,
    }
}

/// Whether a text has a word.
fn has_word(text: &str, word: &str) -> bool {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.match_indices(word).any(|(at, _)| {
        !text[..at].ends_with(is_letter) && !text[at + word.len()..].starts_with(is_letter)
    })
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
            let [sine, cosine] = [ELBOW, ELBOW + 1].map(|place| self.number(place));
            inputs.extend(self.syntax.sine_and_cosine("elbow", [&sine, &cosine]));
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
            push((self.words.keep)(&joints, &singular, &self.branch()));
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

    /// The number of the branch: each joint with two roots adds one bit.
    fn branch(&self) -> String {
        let joints = self.plan.branches.joints.iter().enumerate();
        let bits = joints.map(|(k, number)| {
            format!(
                "({}.{} ? {} : 0)",
                joint(*number),
                self.words.is_second,
                1 << k
            )
        });
        let bits: Vec<_> = bits.collect();
        match &bits[..] {
            [] => "0".to_owned(),
            bits => bits.join(" + "),
        }
    }

    /// Parts of the solution of a step, where they are read.
    fn bound(&self, step: Step, of: &str) -> Vec<String> {
        let declare = |(index, part): (usize, &str)| {
            (self.syntax.declare)(self.body.input_name(index), &format!("{of}.{part}"))
        };
        self.plan.inputs_of(step).map(declare).collect()
    }
}

/// An entry of the pose that is taken, an array of rows.
fn entry_of_pose(_: &str, entry: usize) -> String {
    let (row, column) = Plan::place_in_pose(entry);
    format!("at[{row}][{column}]")
}
