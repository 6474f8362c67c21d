//! Time and rounding of each function.

use std::fmt::Write as _;
use std::time::Instant;

use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::DoubleDouble;

use crate::arguments::Measure;
use crate::failure::Failure;
use crate::load::{arm, read_on_any_base, requests};
use crate::progress::Progress;
use crate::state::poses_of;

/// States at which functions are evaluated.
const STATES: usize = 256;

/// Seconds that are spent on each time.
const SECONDS: f64 = 0.05;

/// The table of `measure`.
pub(crate) fn run(given: &Measure) -> Result<String, Failure> {
    let model = read_on_any_base(&given.robot)?;
    let arm = arm(&given.robot.file.path, &model.robot, &requests(&model)?)?;
    let mut text = format!(
        "{:<32}{:>11}{:>17}{:>11}{:>15}\n",
        "function", "operations", "interpreted, ns", "batch, ns", "largest error"
    );
    let names: Vec<String> = arm.function_names().map(str::to_owned).collect();
    let progress = Progress::new(names.len());
    for (index, name) in names.iter().enumerate() {
        progress.doing(name);
        progress.done(index);
        let measured = measure(&arm, name)?;
        let operations = arm.operations(name)?.total();
        let _ = writeln!(
            text,
            "{name:<32}{operations:>11}{:>17.0}{:>11.1}{:>15.1e}",
            measured.single, measured.batch, measured.error
        );
    }
    Ok(text)
}

struct Measured {
    /// Time of a single evaluation, ns.
    single: f64,
    /// Time of a state in a batch, ns.
    batch: f64,
    /// The largest error, over the largest entry of the same state.
    error: f64,
}

fn measure(arm: &RuntimeRobot, name: &str) -> Result<Measured, Failure> {
    let widths: Vec<usize> = arm.arguments(name)?.map(|(_, width)| width).collect();
    let arguments: Vec<Vec<f64>> = arm
        .arguments(name)?
        .enumerate()
        .map(|(seed, (argument, width))| entries(argument, STATES * width, seed))
        .collect();
    let all: Vec<&[f64]> = arguments.iter().map(Vec::as_slice).collect();
    let at = |state: usize| -> Vec<&[f64]> {
        let slices = all.iter().zip(&widths);
        slices
            .map(|(entries, width)| &entries[state * width..(state + 1) * width])
            .collect()
    };
    let mut results = vec![0.0; STATES * arm.entries(name)?];
    let batch = seconds(|| arm.batch(name, &all, &mut results))? / STATES as f64;
    let states: Vec<_> = (0..STATES).map(at).collect();
    let single = seconds(|| {
        states
            .iter()
            .try_for_each(|state| arm.evaluate(name, state).map(drop))
    })?;
    let mut error = 0.0_f64;
    for state in &states {
        error = error.max(rounding(arm, name, state)?);
    }
    Ok(Measured {
        single: 1e9 * single / STATES as f64,
        batch: 1e9 * batch,
        error,
    })
}

/// The error of a state's values against the same program in 31 digits.
fn rounding(arm: &RuntimeRobot, name: &str, state: &[&[f64]]) -> Result<f64, Failure> {
    let values: Vec<f64> = arm.evaluate_in(name, state)?;
    let precise = |entries: &&[f64]| entries.iter().map(|x| DoubleDouble::from(*x)).collect();
    let arguments: Vec<Vec<DoubleDouble>> = state.iter().map(precise).collect();
    let slices: Vec<&[DoubleDouble]> = arguments.iter().map(Vec::as_slice).collect();
    let exact_values: Vec<DoubleDouble> = arm.evaluate_in(name, &slices)?;
    if values.iter().any(|x| !x.is_finite()) {
        let message = format!(
            "`{name}` is not finite at a state of the measurement: the numbers of the robot are too large"
        );
        return Err(Failure::after(String::new(), message));
    }
    let size = values.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    let differences = values.iter().zip(exact_values);
    let worst = differences
        .map(|(x, exact)| (DoubleDouble::from(*x) - exact).to_f64().abs())
        .fold(0.0, f64::max);
    Ok(if size > 0.0 { worst / size } else { worst })
}

/// The least time of a call.
fn seconds<E>(mut call: impl FnMut() -> Result<(), E>) -> Result<f64, E> {
    let start = Instant::now();
    let mut least = f64::INFINITY;
    while start.elapsed().as_secs_f64() < SECONDS {
        let before = Instant::now();
        call()?;
        least = least.min(before.elapsed().as_secs_f64());
    }
    Ok(least)
}

/// Entries of an argument: within pi of positions, some per second of rates; twelve for each pose of a base.
fn entries(argument: &str, count: usize, seed: usize) -> Vec<f64> {
    if argument == "base" {
        return poses_of(&entries("turn", count / 4, seed));
    }
    let range = if argument == "q" {
        core::f64::consts::PI
    } else {
        5.0
    };
    (0..count)
        .map(|i| range * ((17 * seed + 5 * i) as f64 * 0.37).sin())
        .collect()
}
