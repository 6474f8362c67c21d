//! Measuring chains.

use dynamics_symbolic::{Function, expand, robot::Robot};
use quote::quote;

use crate::chain::{Chain, LISTED, Outcome};
use crate::compile::{self, Compiler};
use crate::{source, unoptimised};

/// Measures the chains of these numbers of joints.
pub(crate) fn measure(joints: &[usize], unoptimised_too: bool) -> Outcome<Vec<Chain>> {
    let compiler = Compiler::new()?;
    let unoptimised = match unoptimised_too {
        true => unoptimised::expansion_times(joints)?
            .into_iter()
            .map(Some)
            .collect(),
        false => vec![None; joints.len()],
    };
    let chains = joints.iter().zip(unoptimised);
    chains
        .map(|(&joints, unoptimised)| {
            let chain = measure_robot(&compiler, &arms::generic_chain(joints), unoptimised)?;
            println!("{joints:2} joints measured");
            Ok(chain)
        })
        .collect()
}

/// Measures a tree of 30 joints.
pub(crate) fn measure_tree() -> Outcome<Chain> {
    measure_robot(&Compiler::new()?, &arms::tree("humanoid"), None)
}

fn measure_robot(compiler: &Compiler, robot: &Robot, unoptimised: Option<f64>) -> Outcome<Chain> {
    let joints = robot.dof();
    let functions = Function::default_set(false);
    let (expansion, methods) = expansion(robot, &functions)?;
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
    let mut times = [0.0; 3];
    let mut methods = Vec::new();
    for time in &mut times {
        let start = measuring::thread_seconds();
        methods = expand(robot, functions, &quote!(::dynamics_runtime))
            .map_err(|failures| failures[0].to_string())?;
        *time = measuring::thread_seconds() - start;
    }
    Ok((measuring::median(times), methods))
}
