//! Joints that chatter about rest where steps end at no events.
//!
//! A force that jumps at rest, such as dry friction by its sign, drives a joint back to rest from both sides. Under error
//! control the steps across the jump are minute, and the run would creep for minutes. It is asked now and then whether a
//! joint is a few steps from rest, and driven back there whichever way it moves. A joint that merely passes rest is not there
//! each time: its motion has many steps from one rest to the next.

use super::error::Cause;
use super::friction::Friction;
use super::motion::Motion;
use super::torque::TorqueLaw;
use crate::integrate::Phase;
use crate::simulation::EquationsOfMotion;
use crate::size::Size;

/// The joints that were near rest and driven back each time, in questions one after the other.
pub(super) struct Chatter<D: Size> {
    joints: D::Each<bool>,
    questions: usize,
    steps: usize,
    /// When it was asked last.
    since: f64,
    /// When the first of these questions was due, and the steps since then.
    began: f64,
    taken: usize,
}

/// A joint chatters if it is near rest so many times, one after the other.
const QUESTIONS: usize = 16;

/// A run ends if chattering to its end would take more steps than these: a shorter one is followed.
const MOST_STEPS: f64 = 500_000.0;

/// The least number of steps between two questions.
const STEPS: usize = 500;

/// Near rest, a joint would stop within so many steps.
const NEAR: f64 = 4.0;

impl<D: Size> Chatter<D> {
    pub(super) fn new(size: D) -> Self {
        Chatter {
            joints: size.each(|_| true),
            questions: 0,
            steps: 0,
            since: 0.0,
            began: 0.0,
            taken: 0,
        }
    }

    /// The end of a run in which a joint chatters, after a step that led to this phase. So much time is left of the run.
    pub(super) fn after_step<R: EquationsOfMotion<D>, L: TorqueLaw<D>>(
        &mut self,
        motion: &Motion<R, L, D>,
        t: f64,
        phase: &Phase<D>,
        left: f64,
    ) -> Result<(), Cause> {
        self.steps += 1;
        self.taken += 1;
        // Not in step with a motion that repeats itself.
        if self.steps < STEPS + self.questions * self.questions {
            return Ok(());
        }
        let joint = self.ask(motion, t, phase);
        self.questions += 1;
        if joint.is_none() {
            *self = Chatter::new(motion.robot.size());
            self.began = t;
        }
        (self.steps, self.since) = (0, t);
        let is_endless = self.taken as f64 * left > MOST_STEPS * (t - self.began);
        match joint {
            Some(joint) if self.questions >= QUESTIONS && is_endless => Err(motion.chatters(joint)),
            _ => Ok(()),
        }
    }

    /// The cause where a run that fails ends, for no better reason of the method.
    pub(super) fn blamed<R: EquationsOfMotion<D>, L: TorqueLaw<D>>(
        &mut self,
        cause: Cause,
        motion: &Motion<R, L, D>,
        t: f64,
        phase: &Phase<D>,
    ) -> Cause {
        let is_of_steps = matches!(
            cause,
            Cause::TooManySteps | Cause::NoConvergence | Cause::StepTooSmall
        );
        let joint = self.ask(motion, t, phase).filter(|_| is_of_steps);
        joint.map_or(cause, |joint| motion.chatters(joint))
    }

    /// The first joint that is near rest and driven back now, and was each time before.
    fn ask<R: EquationsOfMotion<D>, L: TorqueLaw<D>>(
        &mut self,
        motion: &Motion<R, L, D>,
        t: f64,
        phase: &Phase<D>,
    ) -> Option<usize> {
        let step = (t - self.since) / self.steps.max(1) as f64;
        self.joints = motion.each(|i| {
            let back = self.joints[i].then(|| motion.driven_back_by(t, phase, i));
            back.flatten()
                .is_some_and(|back| phase.qd[i].abs() <= NEAR * step * back)
        });
        motion.joints().find(|i| self.joints[*i])
    }
}

impl<R: EquationsOfMotion<D>, L: TorqueLaw<D>, D: Size> Motion<'_, R, L, D> {
    /// The greater of the accelerations back to rest of a joint that moves ever so slowly one way, and the other; `None` where
    /// one of them is none.
    fn driven_back_by(&self, t: f64, phase: &Phase<D>, joint: usize) -> Option<f64> {
        let back = |way: f64| {
            let mut moves = phase.clone();
            moves.qd[joint] = way * f64::MIN_POSITIVE;
            let held = self.held(t, &moves).ok()?;
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
