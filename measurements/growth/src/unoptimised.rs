//! The engine as users have it who set nothing: cargo compiles macros without optimisation.

use std::process::Stdio;

use crate::chain::Outcome;
use crate::compile::cargo;

/// Seconds of the expansion of the default set, for each number of joints.
pub(crate) fn expansion_times(joints: &[usize]) -> Outcome<Vec<f64>> {
    let output = cargo()
        .args(["run", "--quiet", "--profile", "unoptimised"])
        .args([
            "-p",
            "dynamics-symbolic",
            "--example",
            "expansion_time",
            "--",
        ])
        .args(joints.iter().map(usize::to_string))
        .stderr(Stdio::inherit())
        .output()?;
    let text = String::from_utf8(output.stdout)?;
    let times: Vec<f64> = text.lines().filter_map(median).collect();
    match times.len() == joints.len() {
        true => Ok(times),
        false => Err("expansion_time: a line for each chain was expected".into()),
    }
}

/// The third column after the name of a chain.
fn median(line: &str) -> Option<f64> {
    let mut columns = line.split_whitespace();
    columns
        .next()
        .filter(|name| name.starts_with("generic_chain"))?;
    columns.nth(1)?.parse().ok()
}
