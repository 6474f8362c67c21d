//! An integration between events: friction stops joints, holds them and lets them go, and ranges have ends.

use core::marker::PhantomData;

use dynamics_runtime::Size;

use super::error::Cause;
use super::friction::Contact;
use super::joint_set::JointSet;
use super::limits::{AtLimit, End};
use super::motion::{Contacts, Held, Motion};
use super::progress::Progress;
use super::recorder::Recorder;
use super::sampling::Instants;
use super::settings::ErrorControl;
use crate::integrate::{Phase, Stepper};

/// Where a step begins.
pub(super) struct Start<D: Size> {
    pub(super) t: f64,
    pub(super) phase: Phase<D>,
    pub(super) held: Held<D>,
}

/// How the first event within a step is found.
pub(super) trait Finder<S, K: ?Sized, D: Size> {
    /// Has the last step of the stepper end at the first event in it. Where there is none, the
    /// forces at its end.
    fn first_event(
        motion: &Motion<D>,
        system: &S,
        stepper: &mut K,
        start: &Start<D>,
    ) -> Result<Option<Held<D>>, Cause>;
}

/// The least margin where a stepper is, and the forces there.
pub(super) fn here<S, D: Size>(
    motion: &Motion<D>,
    stepper: &(impl Stepper<S, Cause, D> + ?Sized),
) -> Result<(f64, Held<D>), Cause> {
    let phase = stepper.phase();
    let contacts = motion.contacts();
    let held = motion.held(&contacts, stepper.t(), phase)?;
    Ok((motion.least_margin(&contacts, phase, &held), held))
}

/// An integration whose steps end at the events that `F` finds.
pub(super) struct Eventful<'a, S, K: ?Sized, F, D: Size> {
    motion: &'a Motion<'a, D>,
    system: &'a S,
    stepper: &'a mut K,
    instants: Instants,
    held: Held<D>,
    progress: Progress<D>,
    finder: PhantomData<F>,
}

impl<'a, S, K: ?Sized, F, D: Size> Eventful<'a, S, K, F, D>
where
    K: Stepper<S, Cause, D>,
    F: Finder<S, K, D>,
{
    /// From where the stepper is.
    pub(super) fn start(
        motion: &'a Motion<'a, D>,
        system: &'a S,
        stepper: &'a mut K,
        duration: f64,
        control: Option<ErrorControl>,
    ) -> Result<Self, Cause> {
        let held = motion.held(&motion.contacts(), stepper.t(), stepper.phase())?;
        Ok(Eventful {
            motion,
            system,
            stepper,
            instants: Instants::new(motion.torque.period(), duration),
            held,
            progress: Progress::new(motion.size, control),
            finder: PhantomData,
        })
    }

    /// Makes steps to the end of the recorder's plan, under error control at most `max_steps` between two samples.
    pub(super) fn drive(mut self, recorder: &mut Recorder<D>) -> Result<(), Cause> {
        let mut steps = 0;
        while let Some(next) = recorder.next_sample() {
            let made = if self.progress.has_too_many(steps, recorder) {
                Err(Cause::TooManySteps)
            } else {
                self.advance(self.instants.next())
            };
            recorder.work.rejected = self.stepper.rejected();
            let event = made.map_err(|cause| self.blamed(cause, recorder, next))?;
            let end = self.stopped(event);
            recorder.reach(self.stepper.t(), end)?;
            steps += 1;
            let mut taken = self
                .motion
                .take_within(self.system, self.stepper, recorder)?;
            self.turn(event, recorder)?;
            self.progress.after_step(self.motion, recorder)?;
            taken |= self.motion.take_here(recorder);
            if taken {
                steps = 0;
            }
            self.motion.recentre(self.system, self.stepper, recorder);
        }
        Ok(())
    }

    /// Goes on after a step: after an event in it, and from where the laws are asked again.
    fn turn(&mut self, event: bool, recorder: &mut Recorder<D>) -> Result<(), Cause> {
        let t = self.stepper.t();
        let mut contacts = self.motion.contacts().clone();
        if event {
            (recorder.phase, contacts) = self.change(recorder.phase.clone())?;
        }
        let begins = self.instants.begin(t);
        if begins {
            self.motion.torque.sample(t, &recorder.phase)?;
        }
        if event || begins {
            let (contacts, held) = self.motion.settle(&contacts, t, &recorder.phase)?;
            self.held = held;
            self.motion.go_on_under(contacts);
            self.stepper.restart(self.system, recorder.phase.clone())?;
        }
        Ok(())
    }

    /// The cause of a step that fails for no better reason of the method: chatter, if a joint would stop before the
    /// next sample.
    fn blamed(&mut self, cause: Cause, reached: &Recorder<D>, next: f64) -> Cause {
        let (t, phase, motion) = (reached.t, &reached.phase, self.motion);
        let chatters = matches!(cause, Cause::NoConvergence | Cause::StepTooSmall)
            .then(|| motion.stops_and_chatters(t, phase, next - t));
        match chatters.flatten() {
            Some(joint) => Cause::Chatter { joint },
            None => self.progress.blamed(cause, motion, t, phase),
        }
    }

    /// Makes a step, up to the first event in it; whether there was one.
    fn advance(&mut self, end: f64) -> Result<bool, Cause> {
        let start = Start {
            t: self.stepper.t(),
            phase: self.stepper.phase().clone(),
            held: self.held.clone(),
        };
        self.stepper.step(self.system, end)?;
        let without = F::first_event(self.motion, self.system, self.stepper, &start)?;
        let is_event = without.is_none();
        if let Some(held) = without {
            self.held = held;
        }
        Ok(is_event)
    }

    /// The phase reached, in which joints that an event stopped stand still.
    fn stopped(&self, event: bool) -> Phase<D> {
        let mut phase = self.stepper.phase().clone();
        for (i, contact) in self.motion.contacts().as_ref().iter().enumerate() {
            let stops = match contact {
                Contact::Slides(way) => event && *way != 0.0 && way * phase.qd[i] <= 0.0,
                Contact::Sticks | Contact::Leans(_) => true,
            };
            if stops {
                phase.qd[i] = 0.0;
            }
        }
        phase
    }

    /// The phase after an event: joints that hit a stop are thrown back. Otherwise one that stopped sticks, and one
    /// that nothing holds is let go.
    fn change(&mut self, phase: Phase<D>) -> Result<(Phase<D>, Contacts<D>), Cause> {
        self.passes(&phase)?;
        let contacts = self.motion.contacts();
        let impact = self
            .motion
            .thrown_back(&contacts, self.stepper.t(), &phase)?;
        if let Some(impact) = impact {
            self.progress.count(impact.joints, None);
            return Ok((impact.after, impact.contacts));
        }
        let (least, held) = here(self.motion, self.stepper)?;
        let free = |i: usize| self.motion.margin(contacts[i], i, &phase, &held) <= least.max(0.0);
        let next = self.motion.each(|i| match contacts[i] {
            Contact::Slides(way) if way != 0.0 && phase.qd[i] == 0.0 => Contact::Sticks,
            // It was held until now by all the friction that there is.
            Contact::Sticks if free(i) => Contact::Slides(held.way_out(i)),
            Contact::Leans(inwards) if free(i) => self.motion.let_in(i, inwards),
            contact => contact,
        });
        let changed = self.motion.joints().find(|i| contacts[*i] != next[*i]);
        self.progress.count(JointSet::default(), changed);
        Ok((phase, next))
    }

    /// Passing a limit, where that is an error.
    fn passes(&self, phase: &Phase<D>) -> Result<(), Cause> {
        let limits = &self.motion.limits;
        if limits.kind != AtLimit::Ends {
            return Ok(());
        }
        for joint in self.motion.joints() {
            let (q, qd) = (phase.q[joint], phase.qd[joint]);
            let is_beyond = |end: &End| end.inwards * qd < 0.0 && end.gap(q) <= 0.0;
            if let Some(End { at: limit, .. }) = limits.ends(joint).find(is_beyond) {
                return Err(Cause::JointLimit { joint, limit });
            }
        }
        Ok(())
    }
}
