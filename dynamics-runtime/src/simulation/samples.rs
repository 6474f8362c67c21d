//! The samples of a motion that is followed by steps.

use super::error::Cause;
use super::recorder::Recorder;
use super::sampling::before;
use super::trajectory::Forces;
use crate::integrate::{Failure, Phase, Stepper};

/// What a driver needs to know of a motion beside its equations.
pub(super) trait Followed<const N: usize> {
    /// What is recorded beside a phase.
    fn forces(&self, t: f64, phase: &Phase<N>) -> Forces<N>;

    /// The period of laws that are sampled and held.
    fn period(&self) -> Option<f64>;

    /// Begins a period: asks the laws that are sampled.
    fn sample(&self, t: f64, phase: &Phase<N>) -> Result<(), Cause>;
}

/// Takes the samples that lie within the last step; whether there were any.
pub(super) fn take_within<M: Followed<N>, S, E, const N: usize>(
    motion: &M,
    system: &S,
    stepper: &mut (impl Stepper<S, E, N> + ?Sized),
    recorder: &mut Recorder<N>,
) -> Result<bool, Failure<E>> {
    let (end, mut taken) = (stepper.t(), false);
    while let Some(t) = recorder.next_sample().filter(|t| before(*t, end)) {
        let phase = stepper.at(system, t)?;
        recorder.push(t, phase, motion.forces(t, &phase));
        taken = true;
    }
    Ok(taken)
}

/// Takes the samples where the recorder is: one or none, or more where they are nearer to each other than
/// the rounding of the time. Whether there were any.
pub(super) fn take_here<M: Followed<N>, const N: usize>(
    motion: &M,
    recorder: &mut Recorder<N>,
) -> bool {
    let (reached, phase, mut taken) = (recorder.t, recorder.phase, false);
    while let Some(t) = recorder.next_sample().filter(|t| !before(reached, *t)) {
        recorder.push(t, phase, motion.forces(t, &phase));
        taken = true;
    }
    taken
}
