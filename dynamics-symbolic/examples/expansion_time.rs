//! How long the engine takes for the default set of functions, from table to tokens.
//!
//! A procedural macro runs unoptimised in users' builds, so the number that
//! counts is that of the profile `unoptimised`:
//! `cargo run --profile unoptimised -p dynamics-symbolic --example expansion_time`

#[path = "../tests/support/mod.rs"]
mod support;

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

fn main() {
    println!("robot                joints  median of 3, s  limit, s");
    for (name, limit) in CASES {
        let robot = support::robot(name);
        let functions = Function::default_set(true);
        let mut times: Vec<f64> = (0..3)
            .map(|_| {
                let start = Instant::now();
                let methods =
                    expand(&robot, &functions, &quote!(::robot_dynamics)).expect("proven");
                assert_eq!(methods.len(), functions.len());
                start.elapsed().as_secs_f64()
            })
            .collect();
        times.sort_by(f64::total_cmp);
        println!(
            "{name:20} {:6} {:15.3} {limit:9.1}",
            robot.rows.len(),
            times[1]
        );
    }
}
