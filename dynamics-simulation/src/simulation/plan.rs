//! The plan of a run, whatever method makes it.

use super::error::InvalidSetting;
use super::settings::is_possible;

/// The length of a run, and its samples at equal intervals.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plan {
    pub(super) duration: f64,
    pub(super) samples: usize,
}

/// In a shorter run the rounding of the time would be less than any number of full precision.
const SHORTEST: f64 = f64::MIN_POSITIVE / f64::EPSILON;

impl Default for Plan {
    /// For 1 s, with 101 samples.
    fn default() -> Self {
        Plan {
            duration: 1.0,
            samples: 101,
        }
    }
}

impl Plan {
    /// Whether it makes sense, with laws that are sampled at a period or not.
    pub(super) fn validate(&self, period: Option<f64>) -> Result<(), InvalidSetting> {
        if !(self.duration >= SHORTEST && self.duration.is_finite()) {
            return Err(InvalidSetting::Duration(self.duration));
        }
        if self.samples < 2 {
            return Err(InvalidSetting::Samples(self.samples));
        }
        if let Some(period) = period.filter(|period| !is_possible(*period, self.duration)) {
            return Err(InvalidSetting::Period(period));
        }
        Ok(())
    }
}

/// The most steps of fixed length between two samples, where there are a hundred samples and more.
const MOST_STEPS: f64 = 1e5;

impl Plan {
    /// Whether the steps of a fixed length, and those that end where laws are sampled, are no more than a run may have.
    pub(super) fn validate_steps(
        &self,
        step: f64,
        period: Option<f64>,
    ) -> Result<(), InvalidSetting> {
        let steps = self.duration / step + period.map_or(0.0, |period| self.duration / period);
        let most = MOST_STEPS * (self.samples as f64 - 1.0).max(100.0);
        if steps > most * (1.0 + 1e-9) {
            return Err(InvalidSetting::TooManySteps { steps, most });
        }
        Ok(())
    }
}

/// The methods by which a simulation is given its plan.
macro_rules! plan_setters {
    () => {
        /// The time simulated, s.
        pub fn duration(mut self, duration: f64) -> Self {
            self.setting.plan.duration = duration;
            self
        }

        /// The number of samples, at equal intervals, the first at t = 0 and the last at the end.
        pub fn samples(mut self, samples: usize) -> Self {
            self.setting.plan.samples = samples;
            self
        }
    };
}

pub(super) use plan_setters;
