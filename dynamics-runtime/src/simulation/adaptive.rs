//! Integration by the Dormand-Prince method.

use nalgebra::SVector;

use super::trajectory::Recorder;
use super::{Cause, DormandPrince};
use crate::integrate::{Adaptive, Failure, Phase, StepRange, Tolerance};

impl DormandPrince {
    pub(super) fn integrate<const N: usize>(
        &self,
        acceleration: &impl Fn(f64, &Phase<N>) -> Result<SVector<f64, N>, Cause>,
        recorder: &mut Recorder<N>,
    ) -> Result<(), Cause> {
        let duration = recorder.duration();
        let tolerance = Tolerance {
            relative: self.relative_tolerance,
            absolute: self.absolute_tolerance,
        };
        let range = StepRange {
            // A few roundings of the time.
            least: 16.0 * f64::EPSILON * duration,
            greatest: self.longest_step(duration),
        };
        recorder.sample();
        let mut run = Adaptive::start(acceleration, 0.0, recorder.phase, tolerance, range)?;
        while let Some(t) = recorder.next_sample() {
            let mut steps = 0;
            while run.t < t {
                if steps == self.max_steps {
                    return Err(Cause::TooManySteps);
                }
                run.step(acceleration, duration).map_err(Cause::from)?;
                recorder.reach(run.t, run.phase);
                steps += 1;
            }
            recorder.push(t, run.at(t));
        }
        Ok(())
    }
}

impl From<Failure<Cause>> for Cause {
    fn from(failure: Failure<Cause>) -> Self {
        match failure {
            Failure::Refused(cause) => cause,
            Failure::StepTooSmall => Cause::StepTooSmall,
        }
    }
}
