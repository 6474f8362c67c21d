//! Robots from files are those whose table stands in the call.

mod tables;

use dynamics_codegen::files::{Format, table};
use dynamics_symbolic::robot::Robot;

/// The engine's robot that a text describes.
fn robot(name: &str, text: &str, format: Format) -> Robot {
    let table = table(name, text, format).unwrap_or_else(|errors| panic!("{name}: {errors:#?}"));
    let model = dynamics_codegen::check(&table);
    let model = model.unwrap_or_else(|errors| panic!("{name}: {errors:#?}"));
    model.robot
}

/// The text of a file of `tests/data`.
fn text(path: &str) -> String {
    let path = format!("{}/../data/{path}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}
