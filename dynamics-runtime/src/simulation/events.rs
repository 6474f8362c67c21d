//! An integration between events: of friction, which stops joints, holds them and lets them go, and of the
//! ends of their ranges.

use core::marker::PhantomData;

use super::error::{Cause, JointSet};
use super::friction::Contact;
use super::limits::AtLimit;
use super::motion::{Held, Motion};
use super::recorder::Recorder;
use super::sampling::Instants;
use super::torque::TorqueLaw;
use crate::integrate::{Phase, Stepper};
use crate::simulation::EquationsOfMotion;
use crate::size::Size;

/// Where a step begins.
pub(super) struct Start<D: Size> {
    pub(super) t: f64,
    pub(super) phase: Phase<D>,
    pub(super) held: Held<D>,
}

/// How the first event within a step is found.
pub(super) trait Finder<S, R, L, K: ?Sized, D: Size> {
    /// Has the last step of the stepper end at the first event in it. Where there is none, the
    /// forces at its end.
    fn first_event(
        motion: &Motion<R, L, D>,
        system: &S,
        stepper: &mut K,
        start: &Start<D>,
    ) -> Result<Option<Held<D>>, Cause>;
}

/// The least margin where a stepper is, and the forces there.
pub(super) fn here<S, R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size>(
    motion: &Motion<R, L, D>,
    stepper: &(impl Stepper<S, Cause, D> + ?Sized),
) -> Result<(f64, Held<D>), Cause> {
    let phase = stepper.phase();
    let held = motion.held(stepper.t(), phase)?;
    Ok((motion.least_margin(phase, &held), held))
}

/// An integration whose steps end at the events that `F` finds.
pub(super) struct Eventful<'a, S, R, L, K: ?Sized, F, D: Size> {
    motion: &'a Motion<'a, R, L, D>,
    system: &'a S,
    stepper: &'a mut K,
    instants: Instants,
    held: Held<D>,
    /// Events since the last progress: a step without one, or an impact of a joint that came from farther than
    /// positions resolve.
    in_a_row: usize,
    /// Events since the last sample.
    events: usize,
    /// The joint of the last event that was no impact.
    joint: usize,
    /// The joints that hit their stops since the last progress, and those since the last sample.
    hit: [JointSet; 2],
    finder: PhantomData<F>,
}

/// So many events without a step between them that has none are chatter: no event is that short of
/// the next one in a motion that a step of the method can follow.
const MOST_IN_A_ROW: usize = 1_000;

/// So many events between two samples end a run of any method: a bound for those whose steps have none, and for
/// elastic bounces that go on for ever.
const MOST_BETWEEN_SAMPLES: usize = 100_000;

impl<'a, S, R, L, K: ?Sized, F, D: Size> Eventful<'a, S, R, L, K, F, D>
where
    R: EquationsOfMotion<D>,
    L: TorqueLaw<D>,
    K: Stepper<S, Cause, D>,
    F: Finder<S, R, L, K, D>,
{
    /// From where the stepper is.
    pub(super) fn start(
        motion: &'a Motion<'a, R, L, D>,
        system: &'a S,
        stepper: &'a mut K,
        duration: f64,
    ) -> Result<Self, Cause> {
        let held = motion.held(stepper.t(), stepper.phase())?;
        Ok(Eventful {
            motion,
            system,
            stepper,
            instants: Instants::new(motion.period(), duration),
            held,
            in_a_row: 0,
            events: 0,
            joint: 0,
            hit: [JointSet::default(); 2],
            finder: PhantomData,
        })
    }

    /// Makes steps to the end of the recorder's plan, at most `max_steps` between two samples.
    pub(super) fn drive(
        mut self,
        recorder: &mut Recorder<D>,
        max_steps: usize,
    ) -> Result<(), Cause> {
        let mut steps = 0;
        while let Some(next) = recorder.next_sample() {
            if self.in_a_row >= MOST_IN_A_ROW {
                return Err(self.endless(self.hit[0]));
            }
            if self.events >= MOST_BETWEEN_SAMPLES {
                return Err(self.endless(self.hit[1]));
            }
            if steps == max_steps {
                return Err(self.too_many(steps));
            }
            let made = self.advance(self.instants.next());
            recorder.work.rejected = self.stepper.rejected();
            let event = made.map_err(|cause| self.blamed(cause, recorder, next))?;
            let end = self.stopped(event);
            recorder.reach(self.stepper.t(), end)?;
            steps += 1;
            let mut taken = self
                .motion
                .take_within(self.system, self.stepper, recorder)?;
            self.turn(event, recorder)?;
            taken |= self.motion.take_here(recorder);
            if taken {
                (steps, self.events) = (0, 0);
                self.hit[1] = JointSet::default();
            }
        }
        Ok(())
    }

    /// Goes on after a step: after an event in it, and from where the laws are asked again.
    fn turn(&mut self, event: bool, recorder: &mut Recorder<D>) -> Result<(), Cause> {
        let t = self.stepper.t();
        if event {
            recorder.phase = self.change(recorder.phase.clone())?;
        } else {
            self.progress();
        }
        let begins = self.instants.begin(t);
        if begins {
            self.motion.sample(t, &recorder.phase)?;
        }
        if event || begins {
            self.held = self.motion.settle(t, &recorder.phase)?;
            self.stepper.restart(self.system, recorder.phase.clone())?;
        }
        Ok(())
    }

    /// Where a run of steps that does not get on ends: by a joint's events, if most of them had one.
    fn too_many(&self, steps: usize) -> Cause {
        match 2 * self.events > steps {
            true => self.endless(self.hit[1]),
            false => Cause::TooManySteps,
        }
    }

    /// The cause of events without end, among them impacts of some joints.
    fn endless(&self, joints: JointSet) -> Cause {
        if joints == JointSet::default() {
            Cause::Chatter { joint: self.joint }
        } else {
            Cause::Impacts { joints }
        }
    }

    fn progress(&mut self) {
        self.in_a_row = 0;
        self.hit[0] = JointSet::default();
    }

    /// What makes a step fail for which the method has no better reason than that it fails: a joint
    /// that would stop before the next sample, and chatter.
    fn blamed(&self, cause: Cause, reached: &Recorder<D>, next: f64) -> Cause {
        if !matches!(cause, Cause::NoConvergence | Cause::StepTooSmall) {
            return cause;
        }
        let left = next - reached.t;
        let motion = self.motion;
        let chatters = motion.stops_and_chatters(reached.t, &reached.phase, left);
        chatters.map_or(cause, |joint| Cause::Chatter { joint })
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

    /// The phase after an event: joints that hit a stop are thrown back; else one that stopped sticks, and
    /// one that nothing holds is let go.
    fn change(&mut self, phase: Phase<D>) -> Result<Phase<D>, Cause> {
        self.passes(&phase)?;
        if let Some(impact) = self.motion.thrown_back(self.stepper.t(), &phase)? {
            if impact.is_progress {
                self.progress();
            }
            self.in_a_row += 1;
            self.events += 1;
            self.hit
                .iter_mut()
                .for_each(|hit| hit.extend(impact.joints.iter()));
            return Ok(impact.after);
        }
        let (least, held) = here(self.motion, self.stepper)?;
        let contacts = self.motion.contacts();
        let free = |i: usize| self.motion.margin(i, &phase, &held) <= least.max(0.0);
        let next = self.motion.each(|i| match contacts[i] {
            Contact::Slides(way) if way != 0.0 && phase.qd[i] == 0.0 => Contact::Sticks,
            // It was held until now by all the friction that there is.
            Contact::Sticks if free(i) => Contact::Slides(held.way_out(i)),
            Contact::Leans(inwards) if free(i) => self.motion.let_in(i, inwards),
            contact => contact,
        });
        self.count(&contacts, &next);
        self.motion.set_contacts(next);
        Ok(phase)
    }

    /// Passing a limit, where that is an error.
    fn passes(&self, phase: &Phase<D>) -> Result<(), Cause> {
        let limits = self.motion.limits();
        if limits.kind != AtLimit::Ends {
            return Ok(());
        }
        let beyond = |i: usize| {
            let ends = limits
                .ends(i)
                .filter(|end| end.inwards * phase.qd[i] < 0.0 && end.gap(phase.q[i]) <= 0.0);
            ends.map(|end| end.at).next()
        };
        match self.motion.joints().find_map(|i| Some((i, beyond(i)?))) {
            Some((joint, limit)) => Err(Cause::JointLimit { joint, limit }),
            None => Ok(()),
        }
    }

    fn count(&mut self, before: &D::Each<Contact>, after: &D::Each<Contact>) {
        self.in_a_row += 1;
        self.events += 1;
        let changed = self.motion.joints().find(|i| before[*i] != after[*i]);
        self.joint = changed.unwrap_or(self.joint);
    }
}
