//! Clocks: time on a processor, and the time of a short call.

#![forbid(unsafe_code)]

use std::hint::black_box;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Seconds for which this thread has run, without what other programs do meanwhile; where the system
/// does not tell (Linux does), the time of the day.
pub fn thread_seconds() -> f64 {
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = statistics.split_whitespace().next().map(str::parse::<f64>);
    match nanoseconds {
        Some(Ok(nanoseconds)) => 1e-9 * nanoseconds,
        _ => wall_seconds(),
    }
}

fn wall_seconds() -> f64 {
    let time = SystemTime::now().duration_since(UNIX_EPOCH);
    time.map_or(0.0, |time| time.as_secs_f64())
}

/// How much time is spent on measuring a call.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    samples: usize,
    /// The shortest duration of a sample, far above the clock's resolution.
    sample: Duration,
}

impl Effort {
    /// For a first look.
    pub const QUICK: Effort = Effort {
        samples: 5,
        sample: Duration::from_micros(20),
    };
    /// For a number to publish.
    pub const FULL: Effort = Effort {
        samples: 31,
        sample: Duration::from_micros(100),
    };

    /// The median time of an evaluation, ns, over all inputs in turn.
    pub fn nanoseconds<I, R>(self, inputs: &[I], mut function: impl FnMut(&I) -> R) -> f64 {
        let mut sample = |rounds: usize| {
            let start = Instant::now();
            for _ in 0..rounds {
                for input in inputs {
                    // Not the value, which would be copied: a processor waits before it copies what was just written.
                    black_box(&function(black_box(input)));
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

    /// The median times of some pieces of work, ns, measured in turns, so that whatever else the machine does
    /// meets all of them.
    pub fn in_turns<const K: usize>(self, work: [&mut dyn FnMut(); K]) -> [f64; K] {
        let mut sample = |piece: usize, rounds: usize| {
            let start = Instant::now();
            for _ in 0..rounds {
                work[piece]();
            }
            start.elapsed()
        };
        let mut rounds = [1; K];
        for piece in 0..K {
            while sample(piece, rounds[piece]) < self.sample {
                rounds[piece] *= 2;
            }
        }
        let mut times = [const { Vec::new() }; K];
        for _ in 0..self.samples {
            for piece in 0..K {
                times[piece].push(sample(piece, rounds[piece]));
            }
        }
        core::array::from_fn(|piece| {
            times[piece].sort();
            times[piece][self.samples / 2].as_nanos() as f64 / rounds[piece] as f64
        })
    }
}
