//! The samples of a motion that is followed by steps.

use super::error::Cause;
use super::motion::Motion;
use super::recorder::Recorder;
use super::sampling::before;
use super::torque::TorqueLaw;
use crate::integrate::Stepper;
use crate::simulation::EquationsOfMotion;
use crate::size::Size;

impl<R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size> Motion<'_, R, L, D> {
    /// Takes the samples that lie within the last step; whether there were any.
    pub(super) fn take_within<S>(
        &self,
        system: &S,
        stepper: &mut (impl Stepper<S, Cause, D> + ?Sized),
        recorder: &mut Recorder<D>,
    ) -> Result<bool, Cause> {
        let (end, mut taken) = (stepper.t(), false);
        while let Some(t) = recorder.next_sample().filter(|t| before(*t, end)) {
            let phase = stepper.at(system, t)?;
            let forces = self.forces(t, &phase);
            recorder.push(t, phase, forces);
            taken = true;
        }
        Ok(taken)
    }

    /// Takes the samples where the recorder is: one or none, or more where they are nearer to each other than
    /// the rounding of the time. Whether there were any.
    pub(super) fn take_here(&self, recorder: &mut Recorder<D>) -> bool {
        let (reached, phase, mut taken) = (recorder.t, recorder.phase.clone(), false);
        while let Some(t) = recorder.next_sample().filter(|t| !before(reached, *t)) {
            recorder.push(t, phase.clone(), self.forces(t, &phase));
            taken = true;
        }
        taken
    }
}
