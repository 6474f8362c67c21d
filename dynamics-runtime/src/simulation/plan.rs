//! The plan of a run, whatever method makes it.

use super::error::InvalidSetting;
use super::settings::is_possible;
use crate::integrate::Phase;
use crate::size::Size;

/// The start of a run, its length, and its samples at equal intervals.
#[derive(Clone, Debug)]
pub(super) struct Plan<D: Size> {
    pub(super) initial: Phase<D>,
    pub(super) duration: f64,
    pub(super) samples: usize,
}

/// In a shorter run the rounding of the time would be less than any number of full precision.
const SHORTEST: f64 = f64::MIN_POSITIVE / f64::EPSILON;

impl<D: Size> Plan<D> {
    /// From rest at q = 0, for 1 s, with 101 samples.
    pub(super) fn new(size: D) -> Self {
        Plan {
            initial: Phase::zeros(size),
            duration: 1.0,
            samples: 101,
        }
    }

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
        match self.initial.first_non_finite() {
            Some(joint) => Err(InvalidSetting::InitialState { joint }),
            None => Ok(()),
        }
    }
}

/// The most steps of fixed length between two samples, where there are a hundred samples and more.
const MOST_STEPS: f64 = 1e5;

impl<D: Size> Plan<D> {
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

/// The methods by which a simulation is given its plan, except for its start.
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
