//! How long the engine takes for the default set of functions, from table to tokens: seconds on a
//! processor.
//!
//! A procedural macro runs unoptimised in users' builds, so the number that
//! counts is that of the profile `unoptimised`:
//! `cargo run --profile unoptimised -p dynamics-symbolic --example expansion_time`
//!
//! With numbers as arguments, generic chains of so many joints are expanded instead, once each.

use dynamics_symbolic::neglect::neglect;
use dynamics_symbolic::robot::{Robot, Value};
use dynamics_symbolic::{Function, expand};
use quote::quote;

/// Robots, and the time in seconds that their expansion may take.
const CASES: [(&str, f64); 5] = [
    ("two_link_saha", 0.1),
    ("puma560", 1.5),
    ("panda", 4.0),
    ("generic_chain_n7", 4.0),
    ("generic_chain_n12", 8.0),
];

/// As [`CASES`], the longest chain that is promised to expand.
const LONGEST: (usize, f64) = (30, 20.0);

/// As [`CASES`], the PUMA 560 abbreviated: both models are derived.
const ABBREVIATED: f64 = 4.0;

/// As [`CASES`], the Panda with ranges of its joints, over which rounding errors are bounded.
const LIMITED: f64 = 4.0;

fn main() {
    let joints: Vec<usize> = std::env::args()
        .skip(1)
        .map(|argument| argument.parse().expect("a number of joints"))
        .collect();
    println!("robot                joints   median, s  limit, s");
    for &joints in &joints {
        report(&arms::generic_chain(joints), 1, f64::NAN);
    }
    if joints.is_empty() {
        for (name, limit) in CASES {
            report(&arms::robot(name), 3, limit);
        }
        report(&arms::generic_chain(LONGEST.0), 3, LONGEST.1);
        let complete = arms::robot("puma560");
        let mut abbreviated = neglect(&complete, 0.01).expect("a part of it");
        abbreviated.name = "puma560 at 1 %".to_owned();
        report(&abbreviated, 3, ABBREVIATED);
        let mut limited = arms::robot("panda");
        limited.name = "panda with limits".to_owned();
        for row in &mut limited.rows {
            row.limits = Some([Value::integer(-2), Value::integer(2)]);
        }
        report(&limited, 3, LIMITED);
    }
}

/// Prints the median of the times of several expansions.
fn report(robot: &Robot, repetitions: usize, limit: f64) {
    let mut times: Vec<f64> = (0..repetitions).map(|_| expansion(robot)).collect();
    times.sort_by(f64::total_cmp);
    let (name, joints) = (&robot.name, robot.rows.len());
    let median = times[repetitions / 2];
    println!("{name:20} {joints:6} {median:11.4} {limit:9.1}");
}

/// Seconds of one expansion of the default set.
fn expansion(robot: &Robot) -> f64 {
    let functions = Function::default_set(true);
    let start = clock::thread_seconds();
    let methods = expand(robot, &functions, &quote!(::robot_dynamics)).expect("proven");
    let time = clock::thread_seconds() - start;
    assert_eq!(methods.len(), functions.len());
    time
}
