//! What a file says, and what the functions of its robot are.

use std::fmt::Write as _;

use clap::ArgMatches;
use dynamics_symbolic::emit::description;
use dynamics_symbolic::formula::{Budget, Format, Formulas, MOST_JOINTS, TooLong};
use dynamics_symbolic::robot::{Convention, JointType, Robot, Row, Value};
use dynamics_symbolic::{Proven, Request};

use crate::failure::Failure;
use crate::load::{count, file_of, programs, read, requests};

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
        "{}: {}, {convention} convention, gravity {} m/s^2\n\n",
        robot.name,
        match robot.dof() {
            1 => "1 joint that moves".to_owned(),
            dof => format!("{dof} joints that move"),
        },
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
            let x = value.to_f64(&[]);
            let decimal = format!("{x:.6}");
            match x != 0.0 && !(1e-4..1e7).contains(&x.abs()) {
                true => format!("{x:.2e}"),
                false => decimal
                    .trim_end_matches('0')
                    .trim_end_matches('.')
                    .to_owned(),
            }
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
