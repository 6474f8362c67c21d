//! What is said of a function.

use super::{documentation, parameters};
use crate::formula::Formulas;
use crate::function::Request;
use crate::program::Proven;
use crate::robot::Robot;

/// What a function is, its units, what it costs, and the formula where it is short: lines of text.
pub fn description(robot: &Robot, request: &Request, proven: &Proven) -> Vec<String> {
    let refusal =
        "Refused where M(q) is not positive definite to working precision, or not finite.";
    lines(robot, request, proven, refusal)
}

/// The quantity, shapes and units, what it costs, and the formula where it is short; `refusal` says what
/// happens where M is singular.
pub(super) fn lines(
    robot: &Robot,
    request: &Request,
    proven: &Proven,
    refusal: &str,
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
    let formulas = Formulas::of_short_arm(robot, request.parts(), program);
    lines.extend(formulas.iter().flat_map(documentation::formula_lines));
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
    let lines = lines.map(|line| line.strip_prefix(' ').unwrap_or(&line).replace("*/", "* /"));
    lines.collect()
}

/// A comment of several lines, in the form that C and JavaScript share.
pub(super) fn comment(lines: &[String]) -> String {
    let mut text = "/**\n".to_owned();
    for line in lines {
        match line.is_empty() {
            true => text.push_str(" *\n"),
            false => text.push_str(&format!(" * {line}\n")),
        }
    }
    text.push_str(" */\n");
    text
}
