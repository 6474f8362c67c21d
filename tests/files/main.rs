//! Robots from files are those whose table stands in the call.

mod bounds;
mod compiled;
mod floating;
mod generated;
mod mimic;
mod sizes;
mod tables;
mod trees;
mod urdf;

use dynamics_codegen::description::{Entry, Expr, Place};
use dynamics_codegen::files::{Format, Request, table};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Robot, Value};

/// The engine's robot that a text describes.
fn robot(name: &str, text: &str, format: Format) -> Robot {
    check(name, text, format, &Request::default())
}

fn check(name: &str, text: &str, format: Format, request: &Request) -> Robot {
    let table = table(name, text, format, request);
    let mut table = table.unwrap_or_else(|errors| panic!("{name}: {errors:#?}"));
    if format == Format::Urdf {
        let gravity = [0.0, 0.0, -9.81].map(|g| Some(number(g)));
        table.entries.push(Entry::Gravity(Some(gravity)));
    }
    let model = dynamics_codegen::check(&table);
    let model = model.unwrap_or_else(|errors| panic!("{name}: {errors:#?}"));
    model.robot
}

fn number(x: f64) -> Expr {
    let number = Value::Rational(Rational::try_from(x).expect("a number"));
    Expr::known(number, Place::File { line: 1, column: 1 })
}

/// The text of a file of `tests/data`.
fn text(path: &str) -> String {
    let path = format!("{}/../data/{path}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}
