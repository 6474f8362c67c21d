//! The states at which functions are timed, and the clock.

use std::hint::black_box;
use std::time::{Duration, Instant};

use robot_dynamics::State;
use robot_dynamics::nalgebra::SVector;

/// Number of states: a function is evaluated at each in turn.
pub(crate) const STATES: usize = 64;

/// Samples of which the median is taken.
const SAMPLES: usize = 31;

/// Shortest duration of a sample: a thousand times the clock's resolution.
const SAMPLE: Duration = Duration::from_micros(50);

/// States spread over the joints' circles; positions of sliding joints within 3 m.
pub(crate) fn states<const N: usize>() -> Vec<State<N>> {
    let vector = |phase: f64, state: usize| {
        SVector::from_fn(|joint, _| (phase + 1.7 * state as f64 + 2.3 * joint as f64).sin() * 3.0)
    };
    (0..STATES)
        .map(|i| State {
            q: vector(0.1, i),
            qd: vector(0.7, i),
            qdd: vector(1.9, i),
        })
        .collect()
}

/// The median time of an evaluation, ns. An input may be a batch of states: divide by its length.
pub(crate) fn nanoseconds<I, R>(inputs: &[I], mut function: impl FnMut(&I) -> R) -> f64 {
    let mut sample = |rounds: usize| {
        let start = Instant::now();
        for _ in 0..rounds {
            for input in inputs {
                black_box(function(black_box(input)));
            }
        }
        start.elapsed()
    };
    let mut rounds = 1;
    while sample(rounds) < SAMPLE {
        rounds *= 2;
    }
    let mut times: Vec<Duration> = (0..SAMPLES).map(|_| sample(rounds)).collect();
    times.sort();
    times[SAMPLES / 2].as_nanos() as f64 / (rounds * inputs.len()) as f64
}
