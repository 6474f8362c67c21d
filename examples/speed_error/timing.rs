//! The clock.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// How much time is spent on a measurement.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Effort {
    samples: usize,
    sample: Duration,
}

impl Effort {
    pub(crate) const QUICK: Effort = Effort {
        samples: 5,
        sample: Duration::from_micros(20),
    };
    pub(crate) const FULL: Effort = Effort {
        samples: 31,
        sample: Duration::from_micros(100),
    };

    /// The median time of an evaluation, ns.
    pub(crate) fn nanoseconds<I, R>(self, inputs: &[I], mut function: impl FnMut(&I) -> R) -> f64 {
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
        while sample(rounds) < self.sample {
            rounds *= 2;
        }
        let mut times: Vec<_> = (0..self.samples).map(|_| sample(rounds)).collect();
        times.sort();
        times[self.samples / 2].as_nanos() as f64 / (rounds * inputs.len()) as f64
    }
}
