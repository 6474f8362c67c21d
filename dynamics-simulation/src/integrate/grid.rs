//! The ends of steps of equal length.

/// The times at which the steps of a fixed length end: every sample is one of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    duration: f64,
    intervals: u64,
    steps_per_interval: u64,
}

impl Grid {
    /// Divides each of `intervals` equal parts of the duration into the least number of steps that
    /// are no longer than `longest`.
    pub(crate) fn new(duration: f64, intervals: u64, longest: f64) -> Self {
        Grid {
            duration,
            intervals,
            steps_per_interval: steps_per_interval(duration / intervals as f64, longest),
        }
    }

    /// Length of a step.
    pub(super) fn step(&self) -> f64 {
        self.duration / self.intervals as f64 / self.steps_per_interval as f64
    }

    /// The end of step `k`, counted from 0 at the start. Not a sum of steps, whose roundings add up.
    pub(super) fn time(&self, k: u64) -> f64 {
        let (sample, steps) = (k / self.steps_per_interval, k % self.steps_per_interval);
        sample_time(self.duration, self.intervals, sample) + steps as f64 * self.step()
    }
}

/// Time of sample `k` of a run, the last of which is at its end.
pub(crate) fn sample_time(duration: f64, intervals: u64, k: u64) -> f64 {
    if k == intervals {
        duration
    } else {
        duration * k as f64 / intervals as f64
    }
}

/// The least number of steps up to `longest` in an interval. A quotient that is whole except for its
/// rounding is whole.
fn steps_per_interval(interval: f64, longest: f64) -> u64 {
    let quotient = interval / longest;
    let whole = quotient.round();
    let steps = if (quotient - whole).abs() <= 1e-9 * whole {
        whole
    } else {
        quotient.ceil()
    };
    steps.max(1.0) as u64
}

#[cfg(test)]
mod tests {
    use super::{Grid, steps_per_interval};

    #[test]
    fn whole_numbers_of_steps_survive_rounding() {
        assert_eq!(steps_per_interval(0.2, 1e-3), 200);
        assert_eq!(steps_per_interval(0.3, 0.1), 3);
        assert_eq!(steps_per_interval(10.0 / 3.0, 1e-4), 33_334);
        assert_eq!(steps_per_interval(0.1, 0.3), 1);
        assert_eq!(steps_per_interval(1.0, 0.3), 4);
    }

    #[test]
    fn samples_are_ends_of_steps() {
        let grid = Grid::new(0.7, 7, 0.03);
        assert_eq!(grid.step(), 0.7 / 7.0 / 4.0);
        assert_eq!((grid.time(0), grid.time(28)), (0.0, 0.7));
        assert_eq!(grid.time(13), 0.7 * 3.0 / 7.0 + grid.step());
    }
}
