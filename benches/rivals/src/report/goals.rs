//! The times that the project has set itself, and which of them are missed.

use std::fmt::Write;

use super::tables::three_digits;
use crate::candidates::GENERATED;
use measuring::records::Records;

/// Derivatives: the function, the goal, ns, and what Pinocchio takes.
const DERIVATIVES: [(&str, f64, f64); 2] = [
    ("inverse_dynamics_derivatives", 150.0, 1000.0),
    ("forward_dynamics_derivatives", 350.0, 1500.0),
];

/// What stands in front of these times and behind them: the one place of this text, for the document is written anew.
const BEFORE: &str = include_str!("goals/before.txt");
const AFTER: &str = include_str!("goals/after.txt");

/// The section, from the lines of the native build.
pub(super) fn section(native: &Records) -> String {
    let mut text = format!("{BEFORE}\n");
    for (function, goal, pinocchio) in DERIVATIVES {
        let time = native
            .median(["time", "puma560", function, GENERATED])
            .expect("measured");
        let time = marked(time, goal);
        writeln!(
            text,
            "- `{function}`: {time} / about {pinocchio:.0} / {goal:.0}"
        )
        .unwrap();
    }
    text + AFTER
}

/// A time that misses its goal by more than two hundredths is bold.
fn marked(time: f64, goal: f64) -> String {
    let digits = three_digits(time);
    if time > 1.02 * goal {
        format!("**{digits}**")
    } else {
        digits
    }
}
