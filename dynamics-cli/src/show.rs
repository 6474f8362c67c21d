//! What a file says, and what the functions of its robot are.

mod table;

use std::fmt::Write as _;

use clap::ArgMatches;
use dynamics_symbolic::emit::description;
use dynamics_symbolic::formula::{Budget, Format, Formulas, MOST_JOINTS, TooLong};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Proven, Request};

use crate::failure::Failure;
use crate::load::{count, file_of, programs, read, requests};
use table::table;

/// What is multiplied out before a formula is given up.
const PRODUCTS_FOR_EACH_TERM: usize = 100;

/// The text of `show`.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let path = file_of(given);
    let model = read(path, given)?;
    let robot = &model.robot;
    let programs = programs(path, robot, &requests(&model)?)?;
    let terms = count(given, "terms");
    let budget = Budget {
        terms,
        products: PRODUCTS_FOR_EACH_TERM.saturating_mul(terms),
    };
    if let Some(format) = format(given) {
        return Ok(formulas(robot, &programs, format, budget));
    }
    let mut text = table(robot);
    text.push_str(&operations(&programs));
    if robot.dof() > MOST_JOINTS {
        text.push_str("\nformulas of arms of more than three joints: `--format text`\n");
    }
    for (request, proven) in &programs {
        let _ = writeln!(text, "\n{}", request.name());
        for line in description(robot, request, proven, budget, &longer) {
            let _ = writeln!(text, "{}", format!("    {line}").trim_end());
        }
    }
    Ok(text)
}

/// The format in which formulas alone are asked for.
fn format(given: &ArgMatches) -> Option<Format> {
    match given.get_one::<String>("format")?.as_str() {
        "text" => Some(Format::Text),
        "latex" => Some(Format::Latex),
        _ => Some(Format::MathMl),
    }
}

/// What each function costs.
fn operations(programs: &[(Request, Proven)]) -> String {
    let mut text = format!(
        "\n{:<32}{:>7}{:>7}{:>7}{:>9}\n",
        "function", "mul", "add", "div", "sin cos"
    );
    for (request, Proven { program, .. }) in programs {
        let operations = program.operations();
        let _ = writeln!(
            text,
            "{:<32}{:>7}{:>7}{:>7}{:>9}",
            request.name(),
            operations.multiplications,
            operations.additions,
            operations.divisions,
            operations.sin_cos
        );
    }
    text
}

/// The formulas in a format; of those that are longer than the budget, how long they are.
fn formulas(
    robot: &Robot,
    programs: &[(Request, Proven)],
    format: Format,
    budget: Budget,
) -> String {
    let mut text = String::new();
    for (request, proven) in programs {
        let formulas = Formulas::new(robot, request.parts(), &proven.program, budget);
        let _ = writeln!(text, "{}", request.name());
        for equation in formulas.equations(budget.terms) {
            let equation = match format {
                Format::Text => equation.text,
                Format::Latex => equation.latex,
                Format::MathMl => equation.mathml,
            };
            let _ = writeln!(text, "{equation}");
        }
        for shown in formulas.shown(Format::Text, budget.terms) {
            if let Err(too_long) = shown.formula {
                let _ = writeln!(text, "{}: {}", shown.name, longer(too_long));
            }
        }
        let legend = formulas.legend(budget.terms);
        if !legend.is_empty() {
            let _ = writeln!(text, "with {}", legend.join(", "));
        }
        text.push('\n');
    }
    text
}

/// What is said of a formula that is not printed.
fn longer(TooLong { terms, or_more }: TooLong) -> String {
    match or_more {
        true => format!("more than {terms} terms: a larger `--terms` prints them"),
        false => format!("{terms} terms: `--terms {terms}` prints them"),
    }
}
