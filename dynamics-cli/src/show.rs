//! What a file says, and what the functions of its robot are.

use std::fmt::Write as _;

use clap::ArgMatches;
use dynamics_symbolic::emit::description;
use dynamics_symbolic::formula::{Budget, Format, Formulas};
use dynamics_symbolic::robot::{Convention, JointType, Robot, Row, Value};
use dynamics_symbolic::{Function, Proven, Request};

use crate::failure::Failure;
use crate::load::{model, programs};

/// What is multiplied out before a formula is given up.
const PRODUCTS_FOR_EACH_TERM: usize = 100;

/// The text of `show`.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let (robot, requests) = model(given)?;
    let series = Request::One(Function::TaylorSeries);
    let requests = requests.into_iter().filter(|request| *request != series);
    let programs = programs(&robot, requests)?;
    let format = given
        .get_one::<String>("format")
        .and_then(|name| match name.as_str() {
            "text" => Some(Format::Text),
            "latex" => Some(Format::Latex),
            "mathml" => Some(Format::MathMl),
            _ => None,
        });
    if let Some(format) = format {
        let terms = given
            .get_one::<u32>("terms")
            .map_or(100, |terms| *terms as usize);
        return Ok(formulas(&robot, &programs, format, terms));
    }
    let mut text = table(&robot);
    let _ = writeln!(
        text,
        "\n{:<32}{:>7}{:>7}{:>7}{:>9}",
        "function", "mul", "add", "div", "sin cos"
    );
    for (request, Proven { program, .. }) in &programs {
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
    for (request, proven) in &programs {
        let _ = writeln!(text, "\n{}", request.name());
        for line in description(&robot, request, proven) {
            let _ = writeln!(text, "{}", format!("    {line}").trim_end());
        }
    }
    Ok(text)
}

/// The formulas of up to so many terms, in a format.
fn formulas(robot: &Robot, programs: &[(Request, Proven)], format: Format, terms: usize) -> String {
    let budget = Budget {
        terms,
        products: PRODUCTS_FOR_EACH_TERM.saturating_mul(terms),
    };
    let mut text = String::new();
    for (request, proven) in programs {
        let formulas = Formulas::new(robot, request.parts(), &proven.program, budget);
        let equations = formulas.equations(terms);
        let long = formulas.shown(format, terms).len() - equations.len();
        let _ = writeln!(text, "{}", request.name());
        for equation in equations {
            let equation = match format {
                Format::Text => equation.text,
                Format::Latex => equation.latex,
                Format::MathMl => equation.mathml,
            };
            let _ = writeln!(text, "{equation}");
        }
        if long > 0 {
            let _ = writeln!(text, "{long} formulas have more than {terms} terms");
        }
        let legend = formulas.legend(terms);
        if !legend.is_empty() {
            let _ = writeln!(text, "with {}", legend.join(", "));
        }
        text.push('\n');
    }
    text
}

fn number(value: &Value) -> String {
    value.to_f64(&[]).to_string()
}

fn numbers(values: &[Value]) -> String {
    let numbers: Vec<_> = values.iter().map(number).collect();
    format!("[{}]", numbers.join(", "))
}

/// The cells of the table.
fn table(robot: &Robot) -> String {
    let convention = match robot.convention {
        Convention::Standard => "standard",
        Convention::Modified => "modified",
    };
    let mut text = format!(
        "{}: {} joints that move, {convention} convention, gravity {} m/s^2\n\n",
        robot.name,
        robot.dof(),
        numbers(&robot.gravity)
    );
    let widest = robot.rows.iter().map(|row| row.name.chars().count()).max();
    let width = widest.unwrap_or(0).max(5) + 2;
    let _ = writeln!(
        text,
        "{:<width$}{:<11}{:>10}{:>10}{:>10}{:>10}{:>10}  com",
        "joint", "type", "a", "alpha", "d", "theta", "mass"
    );
    for row in &robot.rows {
        let joint_type = match row.joint_type {
            JointType::Revolute => "revolute",
            JointType::Prismatic => "prismatic",
        };
        let cell = |value: &Value| {
            format!("{:.6}", value.to_f64(&[]))
                .trim_end_matches('0')
                .trim_end_matches('.')
                .to_owned()
        };
        let _ = writeln!(
            text,
            "{:<width$}{joint_type:<11}{:>10}{:>10}{:>10}{:>10}{:>10}  {}{}",
            row.name,
            cell(&row.a),
            cell(&row.alpha),
            cell(&row.d),
            cell(&row.theta),
            cell(&row.mass),
            numbers(&row.com),
            locked(row)
        );
    }
    text
}

fn locked(row: &Row) -> String {
    let locked = row.locked.as_ref();
    locked.map_or(String::new(), |position| {
        format!(", locked at {}", number(position))
    })
}
