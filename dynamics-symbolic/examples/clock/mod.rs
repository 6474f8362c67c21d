//! Time on a processor: what other programs do meanwhile is not in it.

use std::time::{SystemTime, UNIX_EPOCH};

/// Seconds for which this thread has run; where the system does not tell (Linux does), the time
/// of the day.
pub(crate) fn thread_seconds() -> f64 {
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
