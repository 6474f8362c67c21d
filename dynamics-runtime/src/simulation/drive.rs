//! An integration from sample to sample.

use super::error::Cause;
use super::motion::Motion;
use super::recorder::Recorder;
use super::sticking::Sticking;
use super::torque::TorqueLaw;
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

/// The same without events.
pub(super) fn smooth<S, E: Into<Cause>, const N: usize>(
    system: &S,
    mut stepper: impl Stepper<S, E, N>,
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

impl<E: Into<Cause>> From<Failure<E>> for Cause {
    fn from(failure: Failure<E>) -> Self {
        match failure {
            Failure::Refused(refusal) => refusal.into(),
            Failure::StepTooSmall => Cause::StepTooSmall,
            Failure::NoConvergence => Cause::NoConvergence,
        }
    }
}
