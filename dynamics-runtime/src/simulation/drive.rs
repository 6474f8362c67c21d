//! An integration from sample to sample.

use super::error::Cause;
use super::events::Eventful;
use super::motion::Motion;
use super::recorder::Recorder;
use super::samples::{Followed, take_here, take_within};
use super::sampling::Instants;
use super::torque::TorqueLaw;
use crate::EquationsOfMotion;
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
    R: EquationsOfMotion<N>,
    L: TorqueLaw<N>,
{
    if motion.has_events() {
        let duration = recorder.duration();
        return Eventful::start(motion, system, stepper, duration)?.drive(recorder, max_steps);
    }
    smooth(motion, system, stepper, recorder, max_steps)
}

/// The same without events.
pub(super) fn smooth<M, S, E, const N: usize>(
    motion: &M,
    system: &S,
    mut stepper: impl Stepper<S, E, N>,
    recorder: &mut Recorder<N>,
    max_steps: usize,
) -> Result<(), Cause>
where
    M: Followed<N>,
    E: Into<Cause>,
{
    let mut instants = Instants::new(motion.period(), recorder.duration());
    let mut steps = 0;
    while recorder.next_sample().is_some() {
        if steps == max_steps {
            return Err(Cause::TooManySteps);
        }
        let made = stepper.step(system, instants.next());
        recorder.work.rejected = stepper.rejected();
        made?;
        let (t, phase) = (stepper.t(), *stepper.phase());
        recorder.reach(t, phase)?;
        steps += 1;
        let mut taken = take_within(motion, system, &mut stepper, recorder)?;
        if instants.begin(t) {
            motion.sample(t, &phase)?;
            stepper.restart(system, phase)?;
        }
        taken |= take_here(motion, recorder);
        if taken {
            steps = 0;
        }
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
