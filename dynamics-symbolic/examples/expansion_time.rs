//! How long the engine takes for the default set of functions, from table to tokens: seconds on a
//! processor.
//!
//! A procedural macro runs unoptimised in users' builds, so the number that
//! counts is that of the profile `unoptimised`:
//! `cargo run --profile unoptimised -p dynamics-symbolic --example expansion_time`
//!
//! It fails where an expansion takes longer than its limit.
//!
//! With numbers as arguments, generic chains of so many joints are expanded instead, once each.

use dynamics_symbolic::neglect::neglect;
use dynamics_symbolic::robot::{Robot, Value};
use dynamics_symbolic::{Function, expand};
use measuring::table::Table;
use quote::quote;
use std::process::ExitCode;
use std::time::{Duration, Instant};

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

/// As [`CASES`], a tree of as many joints.
const LARGEST_TREE: (&str, f64) = ("humanoid", 20.0);

/// As [`CASES`], the PUMA 560 abbreviated: both models are derived.
const ABBREVIATED: f64 = 4.0;

/// For how long a time within its limit is looked for: a short expansion may fall into a slow second of the machine.
const PATIENCE: Duration = Duration::from_secs(20);

/// As [`CASES`], the Panda with ranges of its joints, over which rounding errors are bounded.
const LIMITED: f64 = 4.0;

fn main() -> ExitCode {
    let joints: Vec<usize> = std::env::args()
        .skip(1)
        .map(|argument| argument.parse().expect("a number of joints"))
        .collect();
    let heads = ["robot", "joints", "time, s", "limit, s"];
    let mut table = Table::new("Expansion of the default set", &heads);
    if !joints.is_empty() {
        for &joints in &joints {
            is_within(&mut table, &arms::generic_chain(joints), f64::INFINITY);
        }
        print!("{}", table.text());
        return ExitCode::SUCCESS;
    }
    let mut robots: Vec<_> = CASES.map(|(name, limit)| (arms::robot(name), limit)).into();
    robots.push((arms::generic_chain(LONGEST.0), LONGEST.1));
    robots.push((arms::tree(LARGEST_TREE.0), LARGEST_TREE.1));
    let mut abbreviated = neglect(&arms::robot("puma560"), 0.01).expect("a part of it");
    abbreviated.name = "puma560 at 1 %".to_owned();
    robots.push((abbreviated, ABBREVIATED));
    let mut limited = arms::robot("panda");
    limited.name = "panda with limits".to_owned();
    for row in &mut limited.rows {
        row.limits = Some([Value::integer(-2), Value::integer(2)]);
    }
    robots.push((limited, LIMITED));
    // All of them, whatever the first ones take.
    let slow = robots
        .iter()
        .filter(|(robot, limit)| !is_within(&mut table, robot, *limit))
        .count();
    print!("{}", table.text());
    if slow == 0 {
        return ExitCode::SUCCESS;
    }
    println!("{slow} above their limits in every expansion");
    ExitCode::FAILURE
}

/// A row with the time of an expansion: the first time, or, if that is above the limit, the least of several, because
/// the machine may do something else as well. They are at least three, and take at least [`PATIENCE`] in all.
fn is_within(table: &mut Table, robot: &Robot, limit: f64) -> bool {
    let start = Instant::now();
    let mut time = expansion(robot);
    let mut count = 1;
    while time > limit && (count < 3 || start.elapsed() < PATIENCE) {
        time = time.min(expansion(robot));
        count += 1;
    }
    let joints = robot.rows.len().to_string();
    let name = robot.name.clone();
    table.row([name, joints, format!("{time:.2}"), format!("{limit:.1}")]);
    time <= limit
}

/// Seconds of one expansion of the default set.
fn expansion(robot: &Robot) -> f64 {
    let functions = Function::default_set(true);
    let start = measuring::thread_seconds();
    let methods = expand(robot, &functions, &quote!(::robot_dynamics)).expect("proven");
    let time = measuring::thread_seconds() - start;
    assert_eq!(methods.len(), functions.len());
    time
}
