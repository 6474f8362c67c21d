//! One program for several functions beside a call for each: the ratio of their times, measured in
//! turns, so that whatever else the machine does meets both.
//!
//! `taskset -c 0 cargo bench -p benches --bench fused`. Each turn evaluates both at 64 states; the median
//! of the ratios of 301 turns is printed, with the quartiles, and the time of the fused call.

use std::hint::black_box;
use std::time::Instant;

use robot_dynamics::nalgebra::SVector;
use robots::{Panda, Puma560};

const STATES: usize = 64;
const TURNS: usize = 301;

/// Passes over the states in one measurement, some tens of microseconds.
const PASSES: usize = 20;

/// States spread over the joints' circles.
fn states<const N: usize>(phase: f64) -> [SVector<f64, N>; STATES] {
    std::array::from_fn(|state| {
        SVector::from_fn(|joint, _| (phase + 1.7 * state as f64 + 2.3 * joint as f64).sin() * 3.0)
    })
}

/// ns of a call at one state.
fn time(call: &mut dyn FnMut(usize)) -> f64 {
    let start = Instant::now();
    for _ in 0..PASSES {
        for state in 0..STATES {
            call(black_box(state));
        }
    }
    start.elapsed().as_secs_f64() * 1e9 / (PASSES * STATES) as f64
}

/// Prints the time of `fused`, and its ratio to that of `apart`.
fn compare(name: &str, mut fused: impl FnMut(usize), mut apart: impl FnMut(usize)) {
    let turn = |_| {
        let fused = time(&mut fused);
        (fused, fused / time(&mut apart))
    };
    let (mut times, mut ratios): (Vec<f64>, Vec<f64>) = (0..TURNS).map(turn).unzip();
    times.sort_by(f64::total_cmp);
    ratios.sort_by(f64::total_cmp);
    let [low, median, high] = [1, 2, 3].map(|quarter| ratios[quarter * (TURNS - 1) / 4]);
    let time = times[TURNS / 2];
    println!(
        "{name:24} {time:6.1} ns, {median:.3} of the calls one by one ({low:.3} to {high:.3})"
    );
}

macro_rules! compare_robots {
    ($($robot:ident, $n:literal;)*) => {$(
        let (q, qd, qdd) = (states::<$n>(0.1), states::<$n>(0.7), states::<$n>(1.9));
        compare(
            concat!(stringify!($robot), " control_terms"),
            |i| {
                black_box(&$robot.control_terms(&q[i], &qd[i]));
            },
            |i| {
                black_box(&$robot.mass_matrix(&q[i]));
                black_box(&$robot.coriolis_vector(&q[i], &qd[i]));
                black_box(&$robot.gravity_vector(&q[i]));
            },
        );
        compare(
            concat!(stringify!($robot), " linearised"),
            |i| {
                black_box(&$robot.linearised(&q[i], &qd[i], &qdd[i]));
            },
            |i| {
                black_box(&$robot.inverse_dynamics(&q[i], &qd[i], &qdd[i]));
                black_box(&$robot.inverse_dynamics_derivatives(&q[i], &qd[i], &qdd[i]));
            },
        );
    )*};
}

fn main() {
    compare_robots! { Puma560, 6; Panda, 7; }
}
