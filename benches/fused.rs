//! One program for several functions beside a call for each: the ratio of their times, measured in
//! turns, so that whatever else the machine does meets both.
//!
//! `taskset -c 0 cargo bench -p benches --bench fused`. Each turn evaluates both at 64 states.

use std::hint::black_box;

use measuring::Effort;
use measuring::table::{Table, nanoseconds};
use robots::{Panda, Puma560};
use testkit::five::{Numbers, states};

const STATES: usize = 64;

/// A row with the time of `fused`, and its ratio to that of `apart`.
fn compare<const N: usize>(
    table: &mut Table,
    name: &str,
    fused: impl Fn(&Numbers<f64, N>),
    apart: impl Fn(&Numbers<f64, N>),
) {
    let states = states::<f64, N>(STATES);
    let comparison = Effort::RATIO.compare([
        &mut || states.iter().for_each(|state| fused(black_box(state))),
        &mut || states.iter().for_each(|state| apart(black_box(state))),
    ]);
    let time = nanoseconds(comparison.nanoseconds / STATES as f64);
    let ratios = comparison.ratios.map(|ratio| format!("{ratio:.3}"));
    table.row([name.to_owned(), time].into_iter().chain(ratios));
}

macro_rules! compare_robots {
    ($table:ident: $($robot:ident, $n:literal;)*) => {$(
        compare::<$n>(
            &mut $table,
            concat!(stringify!($robot), " control_terms"),
            |[q, qd, _]| {
                black_box(&$robot.control_terms(q, qd));
            },
            |[q, qd, _]| {
                black_box(&$robot.mass_matrix(q));
                black_box(&$robot.coriolis_vector(q, qd));
                black_box(&$robot.gravity_vector(q));
            },
        );
        compare::<$n>(
            &mut $table,
            concat!(stringify!($robot), " linearised"),
            |[q, qd, qdd]| {
                black_box(&$robot.linearised(q, qd, qdd));
            },
            |[q, qd, qdd]| {
                black_box(&$robot.inverse_dynamics(q, qd, qdd));
                black_box(&$robot.inverse_dynamics_derivatives(q, qd, qdd));
            },
        );
    )*};
}

fn main() {
    let heads = ["tuple", "ns", "lower quartile", "median", "upper quartile"];
    let title = "Time of the fused call, and its ratio to the calls one by one";
    let mut table = Table::new(title, &heads);
    compare_robots! { table: Puma560, 6; Panda, 7; }
    println!("{}", table.text());
}
