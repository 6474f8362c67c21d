//! What a run is asked for, whatever method makes it.

use super::error::InvalidSetting;
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

    pub(super) fn validate(&self) -> Result<(), InvalidSetting> {
        if !(self.duration >= SHORTEST && self.duration.is_finite()) {
            return Err(InvalidSetting::Duration(self.duration));
        }
        if self.samples < 2 {
            return Err(InvalidSetting::Samples(self.samples));
        }
        match self.initial.first_non_finite() {
            Some(joint) => Err(InvalidSetting::InitialState { joint }),
            None => Ok(()),
        }
    }
}
