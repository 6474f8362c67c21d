//! An integration from sample to sample.

use dynamics_runtime::Size;

use super::error::Cause;
use super::events::{Eventful, Finder};
use super::motion::Motion;
use super::progress::Progress;
use super::recorder::Recorder;
use super::sampling::Instants;
use super::settings::ErrorControl;
use crate::integrate::{Failure, Stepper};

/// Makes steps to the end of the recorder's plan, under error control at most its `max_steps` between two samples. Events are those that `F` finds.
///
/// Steppers of [`Simulation`](crate::Simulation) are trait objects, so that this is compiled once for all of its
/// methods: a call is nothing beside a step.
pub(super) fn drive<F, S, K, D: Size>(
    motion: &Motion<D>,
    system: &S,
    stepper: &mut K,
    recorder: &mut Recorder<D>,
    control: Option<ErrorControl>,
) -> Result<(), Cause>
where
    F: Finder<S, K, D>,
    K: Stepper<S, Cause, D> + ?Sized,
{
    if motion.has_events() {
        let duration = recorder.duration;
        let run = Eventful::<_, _, F, D>::start(motion, system, stepper, duration, control)?;
        return run.drive(recorder);
    }
    let mut instants = Instants::new(motion.torque.period(), recorder.duration);
    let mut progress = Progress::new(motion.size, control);
    let mut steps = 0;
    while recorder.next_sample().is_some() {
        let made = if progress.has_too_many(steps, recorder) {
            Err(Cause::TooManySteps)
        } else {
            stepper.step(system, instants.next()).map_err(Cause::from)
        };
        recorder.work.rejected = stepper.rejected();
        made.map_err(|cause| progress.blamed(cause, motion, recorder.t, &recorder.phase))?;
        let (t, phase) = (stepper.t(), stepper.phase().clone());
        recorder.reach(t, phase.clone())?;
        steps += 1;
        progress.after_step(motion, recorder)?;
        let mut taken = motion.take_within(system, stepper, recorder)?;
        if instants.begin(t) {
            motion.torque.sample(t, &phase)?;
            stepper.restart(system, phase)?;
        }
        taken |= motion.take_here(recorder);
        if taken {
            steps = 0;
        }
        motion.recentre(system, stepper, recorder);
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

#[cfg(test)]
mod tests {
    use core::cell::Cell;

    use dynamics_runtime::Place;
    use nalgebra::{Const, Vector1};

    use super::drive;
    use crate::integrate::{Failure, Phase, Stepper};
    use crate::simulation::DormandPrince;
    use crate::simulation::by_margins::ByMargins;
    use crate::simulation::error::Cause;
    use crate::simulation::friction::Law;
    use crate::simulation::limits::Limits;
    use crate::simulation::motion::Motion;
    use crate::simulation::placed::Placed;
    use crate::simulation::plan::Plan;
    use crate::simulation::recorder::Recorder;
    use crate::simulation::tests::Cart;
    use crate::simulation::torque::TorqueLaw;

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
    }

    /// A law that knows when it is to be called.
    struct Expected(f64, Cell<u64>);

    impl TorqueLaw<Const<1>> for Expected {
        fn motors(&self, _: f64, _: &Phase<Const<1>>) -> Vector1<f64> {
            Vector1::zeros()
        }

        fn with_tool(
            &self,
            tau: Vector1<f64>,
            _: f64,
            _: &Phase<Const<1>>,
        ) -> Result<Vector1<f64>, Cause> {
            Ok(tau)
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

    /// The last one is called at its time to the last bit, and no step is one of rounding: samples of
    /// the run, as many as periods or less, make none.
    #[test]
    fn a_million_periods_do_not_drift() {
        for samples in [2, 1_001, 1_000_001] {
            let (duration, law) = (1e3, Expected(1e-3, Cell::new(0)));
            let q = Vector1::zeros();
            let (cart, _) = Placed::<_, Const<1>>::at(&Cart, &Place { base: None, q });
            let motion = Motion::new(&cart, &law, Law::sign(Const), Limits::none(Const));
            let initial = Phase::zeros(Const);
            let mut recorder = Recorder::new(initial.clone());
            recorder.plan(&Plan { duration, samples }).unwrap();
            recorder.push(motion.sample_at(0.0, initial.clone()));
            let mut clock = Clock(0.0, initial);
            drive::<ByMargins, _, _, _>(
                &motion,
                &(),
                &mut clock,
                &mut recorder,
                Some(DormandPrince::default().max_steps(1_000_000).control()),
            )
            .unwrap();
            assert_eq!(law.1.get(), 999_999);
            assert_eq!(recorder.work.steps, 1_000_000);
            assert_eq!((recorder.t, recorder.next_sample()), (1e3, None));
        }
    }
}
