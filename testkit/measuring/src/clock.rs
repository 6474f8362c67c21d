//! Clocks: time on a processor, and the time of a short call.

use std::hint::black_box;
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Seconds for which this thread has run, without other programs' time; if the system does not tell (Linux does), the
/// time of the day.
pub fn thread_seconds() -> f64 {
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = statistics.split_whitespace().next().map(str::parse::<f64>);
    match nanoseconds {
        Some(Ok(nanoseconds)) => 1e-9 * nanoseconds,
        _ => wall_seconds(),
    }
}

/// Seconds on processors of all programs that this one has run, to 1/50 s; if the system does not tell (Linux does),
/// the time of the day.
pub fn children_seconds() -> f64 {
    /// The clock of these numbers on every architecture, per second.
    const TICKS: f64 = 100.0;
    let statistics = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The name, in parentheses, may have spaces in it. User and system time are fields 16 and 17.
    let fields = statistics.rsplit_once(") ").map(|(_, fields)| fields);
    let ticks = fields.map(|fields| fields.split(' ').skip(13).take(2).map(str::parse::<f64>));
    match ticks.and_then(|ticks| ticks.collect::<Result<Vec<_>, _>>().ok()) {
        Some(ticks) => ticks.iter().sum::<f64>() / TICKS,
        None => wall_seconds(),
    }
}

fn wall_seconds() -> f64 {
    let time = SystemTime::now().duration_since(UNIX_EPOCH);
    time.map_or(0.0, |time| time.as_secs_f64())
}

/// A result, and the seconds until it was there.
pub fn seconds<R>(work: impl FnOnce() -> R) -> (R, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64())
}

/// The result of the first of some runs, and the median of their times, s: up to seven runs in 15 ms, at least one.
pub fn median_of_runs<R>(run: impl Fn() -> R) -> (R, f64) {
    let (result, first) = seconds(&run);
    let mut times = vec![first];
    while times.len() < 7 && times.iter().sum::<f64>() < 0.015 {
        times.push(seconds(&run).1);
    }
    (result, median(times))
}

/// The median; of an even number of values the upper one of the two in the middle.
///
/// # Panics
///
/// If there is no value.
pub fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// How much time is spent on measuring a call.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    samples: usize,
    /// The shortest duration of a sample, far above the clock's resolution.
    sample: Duration,
}

/// A piece of work beside another one, measured in turns.
#[derive(Clone, Copy, Debug)]
pub struct Comparison {
    /// The median time of the first piece, ns.
    pub nanoseconds: f64,
    /// The quartiles of the ratios of both times, the first piece's over the second's.
    pub ratios: [f64; 3],
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
    /// For a ratio near to one.
    pub const RATIO: Effort = Effort {
        samples: 301,
        sample: Duration::from_micros(20),
    };

    /// The median time of an evaluation, ns, over all inputs in turn.
    pub fn nanoseconds<I, R>(self, inputs: &[I], mut function: impl FnMut(&I) -> R) -> f64 {
        let mut all = || {
            for input in inputs {
                // Not the value, which would be copied: a processor waits before it copies what was just written.
                black_box(&function(black_box(input)));
            }
        };
        self.in_turns([&mut all])[0] / inputs.len() as f64
    }

    /// The median times of some pieces of work, ns, measured in turns, so that whatever else the machine does
    /// meets all of them.
    pub fn in_turns<const K: usize>(self, work: [&mut dyn FnMut(); K]) -> [f64; K] {
        self.samples_in_turns(work).map(median)
    }

    /// Two pieces of work, measured in turns.
    pub fn compare(self, work: [&mut dyn FnMut(); 2]) -> Comparison {
        let [times, others] = self.samples_in_turns(work);
        let mut ratios: Vec<f64> = times.iter().zip(&others).map(|(a, b)| a / b).collect();
        ratios.sort_by(f64::total_cmp);
        Comparison {
            nanoseconds: median(times),
            ratios: [1, 2, 3].map(|quarter| ratios[quarter * (ratios.len() - 1) / 4]),
        }
    }

    /// The times of some pieces of work, ns, one of each piece after the other.
    fn samples_in_turns<const K: usize>(self, work: [&mut dyn FnMut(); K]) -> [Vec<f64>; K] {
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
                let time = sample(piece, rounds[piece]).as_nanos() as f64;
                times[piece].push(time / rounds[piece] as f64);
            }
        }
        times
    }
}
