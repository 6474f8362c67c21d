//! The content of a file, and the functions of its robot.

mod json;
mod table;

use std::fmt::Write as _;

use dynamics_export::description;
use dynamics_symbolic::formula::{Budget, Format, Formulas, MOST_JOINTS, TooLong};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Proven, Request};

use crate::arguments::{Show, Shown};
use crate::failure::Failure;
use crate::load::{for_command, programs, read_with_names, requests};
use json::json;
use table::table;

/// How far the formulas of one function are multiplied out before they are given up, for each term that a formula may
/// have: a fifth of a second for 1,000 terms.
const PRODUCTS_FOR_EACH_TERM: usize = 30;

/// The text of `show`.
pub(crate) fn run(given: &Show) -> Result<String, Failure> {
    let model = read_with_names(&given.robot)?;
    let robot = &model.robot;
    let programs = programs(&given.robot.file.path, robot, &requests(&model)?)?;
    let terms = given.terms;
    let budget = Budget {
        terms,
        products: PRODUCTS_FOR_EACH_TERM.saturating_mul(terms),
    };
    let mut left_out = LeftOut::default();
    match given.format {
        Some(Shown::Formulas(format)) => {
            let text = formulas(robot, &programs, format, budget, &mut left_out);
            return Ok(text + &left_out.sentence(terms));
        }
        Some(Shown::Json) => return Ok(json(robot, &programs)),
        None => {}
    }
    let mut text = table(robot);
    for note in &model.notes {
        let _ = writeln!(text, "\n{}", for_command(note));
    }
    text.push_str(&operations(&programs));
    if robot.freedoms().has_base() {
        text.push_str("\nformulas of robots on a base that moves: `--format text`\n");
    } else if robot.dof() > MOST_JOINTS {
        text.push_str("\nformulas of arms of more than three joints: `--format text`\n");
    }
    for (request, proven) in &programs {
        let _ = writeln!(text, "\n{}", request.name());
        let mut longer = |name: &str, too_long| {
            left_out.0.push((name.to_owned(), too_long));
            None
        };
        for line in description(robot, request, proven, budget, &mut longer) {
            let _ = writeln!(text, "{}", format!("    {line}").trim_end());
        }
    }
    if !left_out.0.is_empty() {
        text.push('\n');
    }
    Ok(text + &left_out.sentence(terms))
}

/// The values whose formulas have too many terms to be printed.
#[derive(Default)]
struct LeftOut(Vec<(String, TooLong)>);

impl LeftOut {
    /// The sentence about them all.
    fn sentence(&self, most_terms: usize) -> String {
        let Some(largest) = self.0.iter().map(|(_, too_long)| too_long.terms).max() else {
            return String::new();
        };
        let names: Vec<&str> = self.0.iter().map(|(name, _)| name.as_str()).collect();
        let enough = if self.0.iter().any(|(_, too_long)| too_long.or_more) {
            "a larger `--terms`".to_owned()
        } else {
            format!("`--terms {largest}`")
        };
        format!(
            "not printed, because of more than {most_terms} terms: {}; {enough} prints them\n",
            names.join(", ")
        )
    }
}

/// The operations of each function.
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

/// The formulas in a format, and which are longer than the budget.
fn formulas(
    robot: &Robot,
    programs: &[(Request, Proven)],
    format: Format,
    budget: Budget,
    left_out: &mut LeftOut,
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
        let shown = formulas.shown(Format::Text, budget.terms);
        if shown.is_empty() {
            let _ = writeln!(text, "{}", without_formulas(request));
        }
        let too_long = shown.into_iter();
        let too_long = too_long.filter_map(|shown| Some((shown.name, shown.formula.err()?)));
        left_out.0.extend(too_long);
        let legend = formulas.legend(budget.terms);
        if !legend.is_empty() {
            let _ = writeln!(text, "with {}", legend.join(", "));
        }
        text.push('\n');
    }
    text
}

/// Why a function has no formulas.
fn without_formulas(request: &Request) -> String {
    let reason = if request.refuses() {
        "it solves equations with M(q) step by step; `mass_matrix` and `inverse_dynamics` have formulas"
    } else {
        "its values have no letters by which a formula would name them"
    };
    format!("no formulas: {reason}")
}
