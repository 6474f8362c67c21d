//! What grows with the number of joints, and how fast: expansion time, program length, rustc time
//! and time of a call, for generic chains with full tensors.
//!
//! ```text
//! cargo run --release -p growth
//! taskset -c 1 cargo run --release -p growth -- --full
//! ```
//!
//! The first is a look at a few chains, in which one of 30 axes expands and compiles. The second
//! measures up to 30 joints, in an unoptimised engine as well, and writes `docs/GROWTH.md`. Both
//! write plots to `examples/output/`.

use std::error::Error;

use dynamics_symbolic::{Function, expand, robot::Robot};
use quote::quote;

mod compile;
mod document;
mod fit;
mod plot;
mod series;
mod source;
mod unoptimised;

use document::document;
use plot::plots;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Result<(), Box<dyn Error>> {
    let effort = match std::env::args().nth(1).as_deref() {
        None => Effort::QUICK,
        Some("--full") => Effort::FULL,
        Some(other) => return Err(format!("`{other}` is not known: --full, or nothing").into()),
    };
    let chains = measure(&effort)?;
    plots(&chains)?;
    let document = document(&chains)?;
    println!("{document}");
    if effort.is_full {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/GROWTH.md");
        std::fs::write(path, document)?;
        println!("written: docs/GROWTH.md");
    }
    Ok(())
}

/// How many chains are measured.
struct Effort {
    /// Numbers of joints.
    joints: &'static [usize],
    /// Whether the unoptimised engine is measured too, and the results become `docs/GROWTH.md`.
    is_full: bool,
}

impl Effort {
    /// Well under a minute.
    const QUICK: Effort = Effort {
        joints: &[3, 6, 12, 30],
        is_full: false,
    };
    /// Some minutes.
    const FULL: Effort = Effort {
        joints: &[
            1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20, 22, 24, 27, 30,
        ],
        is_full: true,
    };
}

/// The functions that are listed one by one, with the symbols of their values.
const LISTED: [(Function, &str); 5] = [
    (Function::InverseDynamics, "tau"),
    (Function::MassMatrix, "M"),
    (Function::CoriolisVector, "V"),
    (Function::GravityVector, "G"),
    (Function::ForwardDynamics, "qdd"),
];

/// What was measured of one chain.
struct Chain {
    joints: usize,
    /// Seconds on a processor from the table to tokens, default set of functions.
    expansion: f64,
    /// As `expansion`, in an engine that is compiled as cargo compiles macros.
    unoptimised: Option<f64>,
    /// Operations of the listed functions.
    operations: [f64; 5],
    /// Operations of the default set.
    length: f64,
    /// Seconds of rustc on a processor for the default set, release profile.
    release: f64,
    /// As `release`, dev profile with debug information.
    dev: f64,
    /// Nanoseconds of a call of the listed functions.
    calls: [f64; 5],
}

/// Measures all chains of an effort.
fn measure(effort: &Effort) -> Outcome<Vec<Chain>> {
    let compiler = compile::Compiler::new()?;
    let unoptimised = match effort.is_full {
        true => unoptimised::expansion_times(effort.joints)?
            .into_iter()
            .map(Some)
            .collect(),
        false => vec![None; effort.joints.len()],
    };
    let chains = effort.joints.iter().zip(unoptimised);
    chains
        .map(|(&joints, unoptimised)| {
            let chain = measure_chain(&compiler, joints, unoptimised)?;
            println!("{joints:2} joints measured");
            Ok(chain)
        })
        .collect()
}

fn measure_chain(
    compiler: &compile::Compiler,
    joints: usize,
    unoptimised: Option<f64>,
) -> Outcome<Chain> {
    let robot = arms::generic_chain(joints);
    let functions = Function::default_set(false);
    let (expansion, methods) = expansion(&robot, &functions)?;
    let source = source::library(joints, &functions, &methods);
    let dev = compiler.library(&source, &compile::DEV)?;
    let release = compiler.library(&source, &compile::RELEASE)?;
    let calls = compiler.run(&source::program(joints))?;
    let operations = |function| {
        let method = methods
            .iter()
            .find(|m| m.request.function() == Some(function));
        method.map_or(0.0, |method| f64::from(method.operations.total()))
    };
    Ok(Chain {
        joints,
        expansion,
        unoptimised,
        operations: LISTED.map(|(function, _)| operations(function)),
        length: functions.iter().map(|&function| operations(function)).sum(),
        release,
        dev,
        calls: calls.try_into().map_err(|_| "a time for each function")?,
    })
}

/// The median of three expansions in seconds, and the methods.
fn expansion(
    robot: &Robot,
    functions: &[Function],
) -> Outcome<(f64, Vec<dynamics_symbolic::Method>)> {
    let mut times = Vec::new();
    let mut methods = Vec::new();
    for _ in 0..3 {
        let start = clock::thread_seconds();
        methods = expand(robot, functions, &quote!(::dynamics_runtime))
            .map_err(|failures| failures[0].to_string())?;
        times.push(clock::thread_seconds() - start);
    }
    times.sort_by(f64::total_cmp);
    Ok((times[1], methods))
}
