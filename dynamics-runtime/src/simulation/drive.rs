//! An integration from sample to sample.

use super::by_margins::ByMargins;
use super::error::Cause;
use super::events::Eventful;
use super::motion::Motion;
use super::recorder::Recorder;
use super::samples::{Followed, take_here, take_within};
use super::sampling::Instants;
use super::torque::TorqueLaw;
use crate::integrate::{Failure, Stepper};
use crate::simulation::EquationsOfMotion;
use crate::size::Size;

/// Makes steps to the end of the recorder's plan, at most `max_steps` between two samples.
///
/// The stepper is known at run time alone: a call for each step is nothing beside the step, and what is written
/// here is compiled once for all methods.
pub(super) fn drive<S, R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size>(
    motion: &Motion<R, L, D>,
    system: &S,
    stepper: &mut dyn Stepper<S, Cause, D>,
    recorder: &mut Recorder<D>,
    max_steps: usize,
) -> Result<(), Cause> {
    if motion.has_events() {
        let duration = recorder.duration();
        let run = Eventful::<_, _, _, _, ByMargins, D>::start(motion, system, stepper, duration)?;
        return run.drive(recorder, max_steps);
    }
    smooth(motion, system, stepper, recorder, max_steps)
}

/// The same without events.
pub(super) fn smooth<M: Followed<D>, S, E: Into<Cause>, D: Size>(
    motion: &M,
    system: &S,
    stepper: &mut dyn Stepper<S, E, D>,
    recorder: &mut Recorder<D>,
    max_steps: usize,
) -> Result<(), Cause> {
    let mut instants = Instants::new(motion.period(), recorder.duration());
    let mut steps = 0;
    while recorder.next_sample().is_some() {
        if steps == max_steps {
            return Err(Cause::TooManySteps);
        }
        let made = stepper.step(system, instants.next());
        recorder.work.rejected = stepper.rejected();
        made?;
        let (t, phase) = (stepper.t(), stepper.phase().clone());
        recorder.reach(t, phase.clone())?;
        steps += 1;
        let mut taken = take_within(motion, system, stepper, recorder)?;
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

#[cfg(test)]
mod tests {
    use core::cell::Cell;

    use nalgebra::{Const, Vector1};

    use super::smooth;
    use crate::integrate::{Failure, Phase, Stepper};
    use crate::simulation::error::Cause;
    use crate::simulation::plan::Plan;
    use crate::simulation::recorder::Recorder;
    use crate::simulation::samples::Followed;
    use crate::simulation::trajectory::Forces;

    /// A stepper without motion, whose steps end at the given time.
    struct Clock(f64, Phase<Const<1>>);

    impl Stepper<(), Cause, Const<1>> for Clock {
        fn t(&self) -> f64 {
            self.0
        }

        fn phase(&self) -> &Phase<Const<1>> {
            &self.1
        }

        fn step(&mut self, _: &(), end: f64) -> Result<(), Failure<Cause>> {
            assert!(end > self.0);
            self.0 = end;
            Ok(())
        }

        fn at(&mut self, _: &(), _: f64) -> Result<Phase<Const<1>>, Failure<Cause>> {
            Ok(self.1.clone())
        }

        fn retake(&mut self, _: &(), _: f64) -> Result<(), Failure<Cause>> {
            Ok(())
        }

        fn restart(&mut self, _: &(), _: Phase<Const<1>>) -> Result<(), Failure<Cause>> {
            Ok(())
        }

        fn rejected(&self) -> u64 {
            0
        }
    }

    /// A law that knows when it is to be asked.
    struct Asked(f64, Cell<u64>);

    impl Followed<Const<1>> for Asked {
        fn forces(&self, _: f64, _: &Phase<Const<1>>) -> Forces<Const<1>> {
            Forces {
                qdd: Vector1::zeros(),
                tau: Vector1::zeros(),
            }
        }

        fn period(&self) -> Option<f64> {
            Some(self.0)
        }

        fn sample(&self, t: f64, _: &Phase<Const<1>>) -> Result<(), Cause> {
            self.1.set(self.1.get() + 1);
            assert_eq!(t, self.1.get() as f64 * self.0);
            Ok(())
        }
    }

    /// The last one is asked for at its time to the last bit, and no step is one of rounding: samples of
    /// the run, as many as periods or less, make none.
    #[test]
    fn a_million_periods_do_not_drift() {
        let period = 1e-3;
        for samples in [2, 1_001, 1_000_001] {
            let mut plan = Plan::<Const<1>>::new(Const);
            (plan.duration, plan.samples) = (1e3, samples);
            let mut recorder = Recorder::new(plan.initial.clone());
            recorder.plan(&plan).unwrap();
            recorder.push(
                0.0,
                plan.initial.clone(),
                Asked(0.0, Cell::new(0)).forces(0.0, &plan.initial),
            );
            let asked = Asked(period, Cell::new(0));
            smooth(
                &asked,
                &(),
                &mut Clock(0.0, plan.initial.clone()),
                &mut recorder,
                1_000_000,
            )
            .unwrap();
            assert_eq!(asked.1.get(), 999_999);
            assert_eq!(recorder.work.steps, 1_000_000);
            assert_eq!((recorder.t, recorder.next_sample()), (1e3, None));
        }
    }
}
