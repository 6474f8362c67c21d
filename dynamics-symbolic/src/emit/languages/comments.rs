//! What is said of a function.

use super::documentation::{self, formula_lines, short_formula_lines};
use super::parameters;
use crate::formula::{Budget, Formulas, TooLong};
use crate::function::Request;
use crate::program::Proven;
use crate::robot::Robot;

/// What a function is, its units, what it costs, and the formulas of a short arm, of as many terms as the
/// budget has: lines of text. `longer` gives the line of a value whose formula has more, if there is one.
pub fn description(
    robot: &Robot,
    request: &Request,
    proven: &Proven,
    budget: Budget,
    longer: &mut dyn FnMut(&str, TooLong) -> Option<String>,
) -> Vec<String> {
    let refusal =
        "Refused where M(q) is not positive definite to working precision, or not finite.";
    let formulas = Formulas::of_short_arm(robot, request.parts(), &proven.program, budget);
    let formulas = formulas.map(|formulas| formula_lines(&formulas, budget.terms, longer));
    of_function(robot, request, proven, refusal, formulas)
}

/// The quantity, shapes and units, what it costs, and the formulas where they are short; `refusal` says what
/// happens where M is singular.
pub(super) fn lines(
    robot: &Robot,
    request: &Request,
    proven: &Proven,
    refusal: &str,
) -> Vec<String> {
    let program = &proven.program;
    let formulas = Formulas::of_short_arm(robot, request.parts(), program, Budget::UNASKED);
    let formulas = formulas.map(|formulas| short_formula_lines(&formulas));
    of_function(robot, request, proven, refusal, formulas)
}

fn of_function(
    robot: &Robot,
    request: &Request,
    proven: &Proven,
    refusal: &str,
    formulas: Option<Vec<String>>,
) -> Vec<String> {
    let Proven { program, constants } = proven;
    let mut lines = documentation::quantities(robot, request);
    lines.push(String::new());
    if !request.arguments().is_empty() {
        lines.extend([documentation::units(robot, request), String::new()]);
    }
    if request.is_about_base_parameters() {
        lines.extend(parameters::lines(robot));
    }
    if program.is_plain {
        lines.push("Written as the recursion of the equations of motion is.".to_owned());
    }
    lines.push(format!("Operations: {}.", program.operations()));
    lines.extend(documentation::structures(robot, request, program));
    lines.extend(formulas.into_iter().flatten());
    if request.refuses() {
        lines.extend([String::new(), refusal.to_owned()]);
        let unresisted = documentation::unresisted(robot, request, program, constants);
        if !unresisted.is_empty() {
            let names = unresisted.join(", ");
            lines.push(format!(
                "That is so at every state: nothing resists {names}."
            ));
        }
    }
    let fences = ["```text", "```"];
    let lines = lines.into_iter().map(|line| line.trim_end().to_owned());
    let lines = lines.filter(|line| !fences.contains(&line.trim()));
    let lines = lines.map(|line| line.strip_prefix(' ').unwrap_or(&line).to_owned());
    lines.collect()
}

/// A comment of several lines, in the form that C and JavaScript share. The marks of comments and the trigraphs of C that
/// stand in names are taken apart by spaces.
pub(super) fn comment(lines: &[String]) -> String {
    let mut text = "/**\n".to_owned();
    for line in lines {
        let mut line = line.replace("*/", "* /").replace("/*", "/ *");
        while line.contains("??") {
            line = line.replace("??", "? ?");
        }
        text.push_str(format!(" * {line}").trim_end());
        text.push('\n');
    }
    text.push_str(" */\n");
    text
}
