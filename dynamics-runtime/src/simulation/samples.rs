//! The samples of a motion that is followed by steps.

use super::error::Cause;
use super::recorder::Recorder;
use super::sampling::before;
use super::trajectory::Forces;
use crate::integrate::{Failure, Phase, Stepper};
use crate::size::Size;

/// What a driver needs to know of a motion beside its equations.
pub(super) trait Followed<D: Size> {
    /// What is recorded beside a phase.
    fn forces(&self, t: f64, phase: &Phase<D>) -> Forces<D>;

    /// The period of laws that are sampled and held.
    fn period(&self) -> Option<f64>;

    /// Begins a period: asks the laws that are sampled.
    fn sample(&self, t: f64, phase: &Phase<D>) -> Result<(), Cause>;
}

/// Takes the samples that lie within the last step; whether there were any.
pub(super) fn take_within<M: Followed<D>, S, E, D: Size>(
    motion: &M,
    system: &S,
    stepper: &mut (impl Stepper<S, E, D> + ?Sized),
    recorder: &mut Recorder<D>,
) -> Result<bool, Failure<E>> {
    let (end, mut taken) = (stepper.t(), false);
    while let Some(t) = recorder.next_sample().filter(|t| before(*t, end)) {
        let phase = stepper.at(system, t)?;
        let forces = motion.forces(t, &phase);
        recorder.push(t, phase, forces);
        taken = true;
    }
    Ok(taken)
}

/// Takes the samples where the recorder is: one or none, or more where they are nearer to each other than
/// the rounding of the time. Whether there were any.
pub(super) fn take_here<M: Followed<D>, D: Size>(motion: &M, recorder: &mut Recorder<D>) -> bool {
    let (reached, phase, mut taken) = (recorder.t, recorder.phase.clone(), false);
    while let Some(t) = recorder.next_sample().filter(|t| !before(reached, *t)) {
        recorder.push(t, phase.clone(), motion.forces(t, &phase));
        taken = true;
    }
    taken
}
