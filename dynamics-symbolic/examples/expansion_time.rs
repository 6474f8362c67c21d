//! How long the engine takes for the default set of functions, and for the derivatives, from table to
//! tokens.
//!
//! A procedural macro runs unoptimised in users' builds, so the number that
//! counts is that of the profile `unoptimised`:
//! `cargo run --profile unoptimised -p dynamics-symbolic --example expansion_time`

#[path = "../tests/support/mod.rs"]
mod support;

use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, expand};
use quote::quote;
use std::time::Instant;

/// Robots, and the time in seconds that their expansion may take.
const CASES: [(&str, f64); 5] = [
    ("two_link_saha", 0.1),
    ("puma560", 1.5),
    ("panda", 4.0),
    ("generic_chain_n7", 4.0),
    ("generic_chain_n12", 20.0),
];

/// The functions on request that take longest.
const DERIVATIVES: [Function; 2] = [
    Function::InverseDynamicsDerivatives,
    Function::ForwardDynamicsDerivatives,
];

/// The median of three times from table to tokens, in seconds.
fn expansion_time(robot: &Robot, functions: &[Function]) -> f64 {
    let mut times: Vec<f64> = (0..3)
        .map(|_| {
            let start = Instant::now();
            let methods = expand(robot, functions, &quote!(::robot_dynamics)).expect("proven");
            assert_eq!(methods.len(), functions.len());
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[1]
}

fn main() {
    println!("robot                joints  default set, s  limit, s  both derivatives, s");
    for (name, limit) in CASES {
        let robot = support::robot(name);
        println!(
            "{name:20} {:6} {:15.3} {limit:9.1} {:20.3}",
            robot.rows.len(),
            expansion_time(&robot, &Function::default_set(true)),
            expansion_time(&robot, &DERIVATIVES),
        );
    }
}
