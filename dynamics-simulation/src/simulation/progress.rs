//! Whether a run gets on: one bound on work without progress, whatever uses it up.
//!
//! The work of a run is its evaluations of the equations of motion, and its steps. It is asked now and then whether something
//! uses it up that does not lead on:
//!
//! - A joint chatters about rest. A force that jumps at rest, such as dry friction by its sign, drives it back from both
//!   sides, and under error control the steps across the jump are minute. A joint that merely passes rest is not there each
//!   time: its motion has many steps from one rest to the next.
//! - Most steps end at events: joints hit their stops, or stop and are let go.
//!
//! A run in which this goes on ends after the work [`MOST_WORK`] if the rest of it, at that pace, would take more than that
//! again. It ends at once at a [`STANDSTILL`]. Bounces are motion, so that more samples allow more of them, and those that no
//! tolerance tells from rest come to rest first.

use dynamics_runtime::{JointVector as _, Size};

use super::creep::Creep;
use super::error::Cause;
use super::friction::Friction;
use super::joint_set::JointSet;
use super::motion::Motion;
use super::recorder::Recorder;
use super::settings::ErrorControl;
use crate::integrate::Phase;

/// The work of a run since it began to make no progress.
pub(super) struct Progress<D: Size> {
    /// The control of steps that are as short as their error asks for.
    control: Option<ErrorControl>,
    /// The joints that were near rest and driven back each time, in questions one after the other.
    joints: D::Each<bool>,
    questions: u64,
    /// The time of the first of these questions, and the work until then.
    began: (f64, u64),
    /// When it was asked last, and the work until then.
    asked: (f64, u64),
    creep: Creep<D>,
    /// Steps since it was asked last.
    recent: usize,
    /// Steps since the first of these questions was due, and the events among them.
    steps: usize,
    events: usize,
    /// The joints that hit their stops in these.
    hit: JointSet,
    /// The joint of the last event that was no impact.
    joint: usize,
}

/// A run makes no progress if it is found so many times, one after the other.
const QUESTIONS: u64 = 16;

/// The work between two questions.
const WORK: u64 = 4_000;

/// The most work without progress, and for the rest of a run at that pace. Chattering passes where the forces change.
const MOST_WORK: f64 = 1e6;

/// Bounces below the tolerance are rest where the rest of a run would take this share of the most work.
const COARSE: f64 = 0.1;

/// Bounces are followed as far as positions resolve them for so much work.
const WORK_TO_REST: u64 = 300_000;

/// Nothing gets on where the rest would take so many times the most work.
const STANDSTILL: f64 = 300.0;

/// The tolerance of methods without error control: that of most others by default.
const FIXED_TOLERANCE: f64 = 1e-9;

/// A tenth of the most steps makes less of the way to the next sample than this, where no hope is.
const TOO_SLOW: f64 = 1.0 / 300.0;

/// Short steps at the start of a motion are over after so many.
const ENOUGH: usize = 10_000;

/// A joint is driven ever faster if it is as fast as this, rad/s or m/s, and so many times faster than at the start.
const FASTEST: f64 = 1e4;
const FASTER: f64 = 10.0;

/// The bounces of so many samples count.
const SAMPLES: f64 = 100.0;

/// Near rest, a joint would stop within so many steps.
const NEAR: f64 = 4.0;

impl<D: Size> Progress<D> {
    pub(super) fn new(size: D, control: Option<ErrorControl>) -> Self {
        Progress {
            control,
            joints: size.each(|_| true),
            questions: 0,
            began: (0.0, 0),
            asked: (0.0, 0),
            creep: Creep::new(size),
            recent: 0,
            steps: 0,
            events: 0,
            hit: JointSet::default(),
            joint: 0,
        }
    }

    /// Whether another step is one too many, after so many since the last sample, if steps have no fixed length.
    pub(super) fn has_too_many(&self, steps: usize, recorder: &Recorder<D>) -> bool {
        let Some(most) = self.control.map(|control| control.max_steps) else {
            return false;
        };
        let is_early = steps >= ENOUGH && steps == most / 10;
        steps >= most || (is_early && recorder.share_of_interval() < TOO_SLOW)
    }

    /// Counts an event, in which some joints hit their stops or the contact of another one changed.
    pub(super) fn count(&mut self, hit: JointSet, changed: Option<usize>) {
        self.events += 1;
        self.hit.extend(hit.iter());
        self.joint = changed.unwrap_or(self.joint);
    }

    /// The end of a run that makes no progress, after a step to where the recorder is.
    pub(super) fn after_step(
        &mut self,
        motion: &Motion<D>,
        recorder: &mut Recorder<D>,
    ) -> Result<(), Cause> {
        if self.control.is_none() {
            self.creep.after_step(motion, recorder);
        }
        (self.recent, self.steps) = (self.recent + 1, self.steps + 1);
        let work = motion.evaluations.get() + recorder.work.steps;
        // Not in step with a motion that repeats itself.
        if work < self.asked.1 + WORK + 10 * self.questions * self.questions {
            return Ok(());
        }
        let (t, phase) = (recorder.t, &recorder.phase);
        let cause = self.cause(motion, t, phase);
        self.questions += 1;
        if cause.is_none() {
            let creep = core::mem::replace(&mut self.creep, Creep::new(motion.size));
            let fresh = Progress::new(motion.size, self.control);
            *self = Progress { creep, ..fresh };
        }
        // The motion before the first of these questions was another one.
        if self.questions <= 1 {
            self.began = (t, work);
        }
        (self.recent, self.asked) = (0, (t, work));
        let cause = cause.filter(|_| self.questions >= QUESTIONS);
        cause.map_or(Ok(()), |cause| self.judge(cause, motion, recorder, work))
    }

    /// Ends a run if its rest would take too much work. Bounces below the tolerance come to rest first.
    fn judge(
        &self,
        cause: Cause,
        motion: &Motion<D>,
        recorder: &Recorder<D>,
        work: u64,
    ) -> Result<(), Cause> {
        let bounces = matches!(cause, Cause::Impacts { .. });
        let left = recorder.duration - recorder.t;
        let counts = if bounces {
            left.min(SAMPLES * recorder.interval())
        } else {
            left
        };
        let (t, before) = self.began;
        let spent = work - before;
        // The work up to the end, over the most.
        let share = spent as f64 * counts / (MOST_WORK * (recorder.t - t));
        if bounces && share > COARSE && spent > WORK_TO_REST {
            let tolerance = self.control.map(|control| control.tolerance);
            let tolerance = tolerance.map(|bound| bound.absolute.max(bound.relative));
            motion.coarse.set(tolerance.unwrap_or(FIXED_TOLERANCE));
        }
        let may_get_on = (spent as f64) < MOST_WORK && share < STANDSTILL;
        if share <= 1.0 || may_get_on {
            return Ok(());
        }
        Err(cause)
    }

    /// The cause where a run that fails ends, for no better reason of the method.
    pub(super) fn blamed(
        &mut self,
        cause: Cause,
        motion: &Motion<D>,
        t: f64,
        phase: &Phase<D>,
    ) -> Cause {
        let is_of_steps = matches!(
            cause,
            Cause::TooManySteps | Cause::NoConvergence | Cause::StepTooSmall
        );
        if is_of_steps {
            self.cause(motion, t, phase).unwrap_or(cause)
        } else {
            cause
        }
    }

    /// Why there is no progress: a joint that chatters about rest, or events.
    fn cause(&mut self, motion: &Motion<D>, t: f64, phase: &Phase<D>) -> Option<Cause> {
        if self.control.is_some() {
            let step = (t - self.asked.0) / self.recent.max(1) as f64;
            self.joints =
                motion.each(|i| self.joints[i] && motion.near_rest(t, phase, i, step).is_some());
            if let Some(joint) = motion.joints().find(|i| self.joints[*i]) {
                return Some(motion.chatters(joint));
            }
        }
        let joints = self.hit;
        let is_of_events = self.events > 0 && 2 * self.events >= self.steps;
        is_of_events.then_some(if joints.is_empty() {
            Cause::Chatter { joint: self.joint }
        } else {
            Cause::Impacts { joints }
        })
    }
}

/// The fastest joint as the cause of too many steps, if it is too fast for a robot and did not begin so.
pub(super) fn runs_away<D: Size>(cause: Cause, initial: &Phase<D>, reached: &Phase<D>) -> Cause {
    let fastest = |phase: &Phase<D>| {
        let speeds = phase.qd.entries().iter().map(|speed| speed.abs());
        speeds.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b))
    };
    match (fastest(initial), fastest(reached)) {
        (Some((_, first)), Some((joint, speed)))
            if cause == Cause::TooManySteps && speed > FASTEST.max(FASTER * first) =>
        {
            Cause::RunsAway { joint, speed }
        }
        _ => cause,
    }
}

impl<D: Size> Motion<'_, D> {
    /// The speed below which a joint would stop within a few steps of that length, if it is that slow, and driven back to
    /// rest whichever way it moves.
    pub(super) fn near_rest(
        &self,
        t: f64,
        phase: &Phase<D>,
        joint: usize,
        step: f64,
    ) -> Option<f64> {
        let speed = NEAR * step * self.driven_back_by(t, phase, joint)?;
        Some(speed).filter(|speed| phase.qd[joint].abs() <= *speed)
    }

    /// The greater of the accelerations back to rest of a joint that moves ever so slowly one way, and the other; `None` where
    /// one of them is none.
    fn driven_back_by(&self, t: f64, phase: &Phase<D>, joint: usize) -> Option<f64> {
        let back = |way: f64| {
            let mut moves = phase.clone();
            moves.qd[joint] = way * f64::MIN_POSITIVE;
            let held = self.held(&self.contacts(), t, &moves).ok()?;
            Some(-way * held.qdd[joint]).filter(|back| *back > 0.0)
        };
        Some(back(1.0)?.max(back(-1.0)?))
    }

    /// The cause of a joint that chatters without events: its dry friction, or the law.
    fn chatters(&self, joint: usize) -> Cause {
        match self.friction.kind {
            Friction::Sign if !self.friction.dry[joint].is_none() => Cause::Sticks { joint },
            _ => Cause::Chatter { joint },
        }
    }
}
