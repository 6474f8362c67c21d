//! The description of a function as a comment.

use dynamics_symbolic::bounds::rounding;
use dynamics_symbolic::emit::{facts, formula_lines, short_formula_lines, shown, unresisted};
use dynamics_symbolic::formula::{Budget, Formulas, TooLong};
use dynamics_symbolic::function::Request;
use dynamics_symbolic::program::Proven;
use dynamics_symbolic::robot::Robot;

/// The quantity, its units, its operations, and the formulas of a short arm within a budget: lines of text. `longer`
/// gives the line of a value whose formula has more terms, if there is one.
pub fn description(
    robot: &Robot,
    request: &Request,
    proven: &Proven,
    budget: Budget,
    longer: &mut dyn FnMut(&str, TooLong) -> Option<String>,
) -> Vec<String> {
    let refusal =
        "Refused where M(q) is not positive definite to working precision, or not finite.";
    let short = Formulas::of_short_arm(robot, request.parts(), &proven.program, budget);
    let formulas = short.map(|formulas| formula_lines(&formulas, budget.terms, longer));
    function_lines(robot, request, proven, refusal, formulas)
}

/// The same with formulas that are short; `refusal` says what the function does if M is singular.
pub(crate) fn lines(
    robot: &Robot,
    request: &Request,
    proven: &Proven,
    refusal: &str,
) -> Vec<String> {
    let (parts, budget) = (request.parts(), Budget::UNASKED);
    let short = Formulas::of_short_arm(robot, parts, &proven.program, budget);
    let formulas = short.map(|formulas| short_formula_lines(&formulas));
    function_lines(robot, request, proven, refusal, formulas)
}

fn function_lines(
    robot: &Robot,
    request: &Request,
    proven: &Proven,
    refusal: &str,
    formulas: Option<Vec<String>>,
) -> Vec<String> {
    let recursion = || "Written as the recursion of the equations of motion is.".to_owned();
    let plain = proven.program.is_plain.then(recursion);
    let rounding = rounding(robot, request, proven).map(|rounding| rounding.line());
    let notes = plain.into_iter().chain(rounding).collect();
    let mut lines = facts(robot, request, &proven.program, notes);
    lines.extend(formulas.into_iter().flatten());
    if request.refuses() {
        lines.extend([String::new(), refusal.to_owned()]);
        let unresisted = unresisted(robot, request, proven);
        if !unresisted.is_empty() {
            let names = unresisted.join(", ");
            lines.push(format!(
                "That is so at every state: nothing resists {names}."
            ));
        }
    }
    lines.retain(|line| !["```text", "```"].contains(&line.trim()));
    let texts = lines.iter().map(|line| line.trim_end());
    texts
        .map(|text| text.strip_prefix(' ').unwrap_or(text).to_owned())
        .collect()
}

/// The comment at the top of a file: `conventions` has the lines that differ between languages.
pub(crate) fn title(robot: &Robot, conventions: [&str; 2]) -> String {
    comment(&title_lines(robot, conventions))
}

/// The lines of that comment.
pub(crate) fn title_lines(robot: &Robot, conventions: [&str; 2]) -> [String; 4] {
    let first = format!(
        "Equations of motion of `{}`, written by robot-dynamics.",
        robot.name
    );
    let [second, third] = conventions.map(str::to_owned);
    [first, String::new(), second, third]
}

/// A comment of several lines, in the form that C and JavaScript share. The marks of comments and the trigraphs of C that
/// stand in names are taken apart by spaces.
pub(crate) fn comment(lines: &[String]) -> String {
    let mut text = "/**\n".to_owned();
    for line in lines {
        let mut line = shown(line).replace("*/", "* /").replace("/*", "/ *");
        while line.contains("??") {
            line = line.replace("??", "? ?");
        }
        text.push_str(format!(" * {line}").trim_end());
        text.push('\n');
    }
    text.push_str(" */\n");
    text
}
