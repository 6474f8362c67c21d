//! An integration from sample to sample.

use super::motion::Motion;
use super::sticking::Sticking;
use super::trajectory::Recorder;
use super::{Cause, TorqueLaw};
use crate::ForwardDynamics;
use crate::integrate::{Failure, Stepper};

/// Makes steps to the end of the recorder's plan, at most `max_steps` between two samples.
pub(super) fn drive<S, R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    system: &S,
    stepper: impl Stepper<S, Cause, N>,
    recorder: &mut Recorder<N>,
    max_steps: usize,
) -> Result<(), Cause>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    if motion.sticks() {
        return Sticking::start(motion, system, stepper)?.drive(recorder, max_steps);
    }
    smooth(system, stepper, recorder, max_steps)
}

/// Without events.
fn smooth<S, const N: usize>(
    system: &S,
    mut stepper: impl Stepper<S, Cause, N>,
    recorder: &mut Recorder<N>,
    max_steps: usize,
) -> Result<(), Cause> {
    let duration = recorder.duration();
    while let Some(t) = recorder.next_sample() {
        let mut steps = 0;
        while stepper.t() < t {
            if steps == max_steps {
                return Err(Cause::TooManySteps);
            }
            let made = stepper.step(system, duration);
            recorder.work.rejected = stepper.rejected();
            made?;
            recorder.reach(stepper.t(), *stepper.phase())?;
            steps += 1;
        }
        recorder.push(t, stepper.at(system, t)?);
    }
    Ok(())
}

impl From<Failure<Cause>> for Cause {
    fn from(failure: Failure<Cause>) -> Self {
        match failure {
            Failure::Refused(cause) => cause,
            Failure::StepTooSmall => Cause::StepTooSmall,
            Failure::NoConvergence => Cause::NoConvergence,
        }
    }
}
