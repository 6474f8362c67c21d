//! An integration between events: of friction, which stops joints, holds them and lets them go, and of the
//! ends of their ranges.

use super::contacts::{
    classified, least_margin, let_in, margin, settle, stops_and_chatters, way_out,
};
use super::error::Cause;
use super::friction::Contact;
use super::impact::thrown_back;
use super::limits::AtLimit;
use super::motion::{Held, Motion};
use super::recorder::Recorder;
use super::samples::{Followed, take_here, take_within};
use super::sampling::Instants;
use super::torque::TorqueLaw;
use crate::EquationsOfMotion;
use crate::integrate::{Phase, Stepper};

/// An integration whose steps end at the events.
pub(super) struct Eventful<'a, S, R, L, const N: usize> {
    motion: &'a Motion<'a, R, L, N>,
    system: &'a S,
    stepper: &'a mut dyn Stepper<S, Cause, N>,
    instants: Instants,
    held: Held<N>,
    /// Events since the last step without one.
    in_a_row: usize,
    /// Events since the last sample.
    events: usize,
    /// The joint of the last event.
    joint: usize,
}

/// So many events without a step between them that has none are chatter: no event is that short of
/// the next one in a motion that a step of the method can follow.
const MOST_IN_A_ROW: usize = 1_000;

impl<'a, S, R, L, const N: usize> Eventful<'a, S, R, L, N>
where
    R: EquationsOfMotion<N>,
    L: TorqueLaw<N>,
{
    /// From where the stepper is.
    pub(super) fn start(
        motion: &'a Motion<'a, R, L, N>,
        system: &'a S,
        stepper: &'a mut dyn Stepper<S, Cause, N>,
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
        })
    }

    /// Makes steps to the end of the recorder's plan, at most `max_steps` between two samples.
    pub(super) fn drive(
        mut self,
        recorder: &mut Recorder<N>,
        max_steps: usize,
    ) -> Result<(), Cause> {
        let mut steps = 0;
        while let Some(next) = recorder.next_sample() {
            if self.in_a_row == MOST_IN_A_ROW {
                return Err(Cause::Chatter { joint: self.joint });
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
            let mut taken = take_within(self.motion, self.system, self.stepper, recorder)?;
            self.turn(event, recorder)?;
            taken |= take_here(self.motion, recorder);
            if taken {
                (steps, self.events) = (0, 0);
            }
        }
        Ok(())
    }

    /// Goes on after a step: after an event in it, and from where the laws are asked again.
    fn turn(&mut self, event: bool, recorder: &mut Recorder<N>) -> Result<(), Cause> {
        let t = self.stepper.t();
        if event {
            recorder.phase = self.change(recorder.phase)?;
        } else {
            self.in_a_row = 0;
        }
        let begins = self.instants.begin(t);
        if begins {
            self.motion.sample(t, &recorder.phase)?;
        }
        if event || begins {
            self.held = settle(self.motion, t, &recorder.phase)?;
            self.stepper.restart(self.system, recorder.phase)?;
        }
        Ok(())
    }

    /// Where a run of steps that does not get on ends: by a joint's events, if most of them had one.
    fn too_many(&self, steps: usize) -> Cause {
        match 2 * self.events > steps {
            true => Cause::Chatter { joint: self.joint },
            false => Cause::TooManySteps,
        }
    }

    /// What makes a step fail for which the method has no better reason than that it fails: a joint
    /// that would stop before the next sample, and chatter.
    fn blamed(&self, cause: Cause, reached: &Recorder<N>, next: f64) -> Cause {
        if !matches!(cause, Cause::NoConvergence | Cause::StepTooSmall) {
            return cause;
        }
        let left = next - reached.t;
        match stops_and_chatters(self.motion, reached.t, &reached.phase, left) {
            Some(joint) => Cause::Chatter { joint },
            None => cause,
        }
    }

    /// Makes a step, up to the first event in it; whether there was one.
    fn advance(&mut self, end: f64) -> Result<bool, Cause> {
        let (t, phase, held) = (self.stepper.t(), *self.stepper.phase(), self.held);
        self.stepper.step(self.system, end)?;
        let (margin, after) = self.here()?;
        if margin >= 0.0 && !self.dips(t, &phase, &held, &after)? {
            self.held = after;
            return Ok(false);
        }
        self.locate(t, least_margin(self.motion, &phase, &held))?;
        Ok(true)
    }

    /// Whether a velocity, or the way to a limit, dips below zero within a step that ends well; the
    /// stepper then is there.
    fn dips(
        &mut self,
        t: f64,
        from: &Phase<N>,
        before: &Held<N>,
        after: &Held<N>,
    ) -> Result<bool, Cause> {
        let late = self.stepper.t();
        let dip = self.dip(t, from, before, after);
        let Some(dip) = dip.filter(|dip| t < *dip && *dip < late) else {
            return Ok(false);
        };
        self.stepper.retake(self.system, dip)?;
        if self.here()?.0 < 0.0 {
            return Ok(true);
        }
        self.stepper.retake(self.system, late)?;
        Ok(false)
    }

    /// The least margin where the stepper is, and the forces there.
    fn here(&self) -> Result<(f64, Held<N>), Cause> {
        let phase = self.stepper.phase();
        let held = self.motion.held(self.stepper.t(), phase)?;
        Ok((least_margin(self.motion, phase, &held), held))
    }

    /// The time at which a velocity that keeps its sign from one end of the step to the other dips
    /// below zero, or a position passes a limit and comes back, by the cubic through values and slopes at
    /// the ends.
    fn dip(&self, t: f64, from: &Phase<N>, before: &Held<N>, after: &Held<N>) -> Option<f64> {
        let to = self.stepper.phase();
        let h = self.stepper.t() - t;
        let of_velocity = |i: usize| match self.motion.contacts()[i] {
            Contact::Slides(way) => lowest(
                [way * from.qd[i], way * to.qd[i]],
                [way * before.qdd[i] * h, way * after.qdd[i] * h],
            ),
            _ => None,
        };
        let limits = self.motion.limits();
        let of_position = |i: usize| {
            let ends = limits.ends(i).filter_map(move |end| {
                lowest(
                    [from.q[i], to.q[i]].map(|q| limits.margin(&end, q)),
                    [from.qd[i], to.qd[i]].map(|qd| end.inwards * qd * h),
                )
            });
            ends.reduce(f64::min)
        };
        let dips = (0..N).flat_map(|i| [of_velocity(i), of_position(i)]);
        dips.flatten().reduce(f64::min).map(|s| t + s * h)
    }

    /// Takes the step again, so that it ends where the least margin, which was `margin` at `start`
    /// and is negative here, passes zero: false position after Illinois (M. Dowell, P. Jarratt, BIT
    /// 11 (1971)), by halves where that does not apply.
    fn locate(&mut self, start: f64, margin: f64) -> Result<(), Cause> {
        let (mut a, mut at_a) = (start, margin);
        let (mut b, mut at_b) = (self.stepper.t(), self.here()?.0);
        let rounding = 4.0 * f64::EPSILON * at_a.abs();
        let mut side = 0;
        while b - a > 4.0 * f64::EPSILON * b && at_b < -rounding {
            let secant = b - at_b * (b - a) / (at_b - at_a);
            let inside = at_a > 0.0 && secant > a && secant < b;
            let c = if inside { secant } else { 0.5 * (a + b) };
            if c <= a || c >= b {
                break;
            }
            self.stepper.retake(self.system, c)?;
            let at_c = self.here()?.0;
            if at_c <= rounding {
                (b, at_b) = (c, at_c);
                if side == 1 {
                    at_a *= 0.5;
                }
                side = 1;
            } else {
                (a, at_a) = (c, at_c);
                if side == -1 {
                    at_b *= 0.5;
                }
                side = -1;
            }
        }
        if self.stepper.t() != b {
            self.stepper.retake(self.system, b)?;
        }
        Ok(())
    }

    /// The phase reached, in which joints that an event stopped stand still.
    fn stopped(&self, event: bool) -> Phase<N> {
        let mut phase = *self.stepper.phase();
        for (i, contact) in self.motion.contacts().iter().enumerate() {
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
    fn change(&mut self, phase: Phase<N>) -> Result<Phase<N>, Cause> {
        self.passes(&phase)?;
        if let Some(after) = thrown_back(self.motion, self.stepper.t(), &phase)? {
            self.motion.set_contacts(classified(self.motion, &after));
            // Bounces take time, and become fewer: they are no chatter.
            self.in_a_row = 0;
            return Ok(after);
        }
        let (least, held) = self.here()?;
        let contacts = self.motion.contacts();
        let free = |i: usize| margin(self.motion, i, &phase, &held) <= least.max(0.0);
        let next = core::array::from_fn(|i| match contacts[i] {
            Contact::Slides(way) if way != 0.0 && phase.qd[i] == 0.0 => Contact::Sticks,
            // It was held until now by all the friction that there is.
            Contact::Sticks if free(i) => Contact::Slides(way_out(&held, i)),
            Contact::Leans(inwards) if free(i) => let_in(self.motion, i, inwards),
            contact => contact,
        });
        self.count(&contacts, &next);
        self.motion.set_contacts(next);
        Ok(phase)
    }

    /// Passing a limit, where that is an error.
    fn passes(&self, phase: &Phase<N>) -> Result<(), Cause> {
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
        match (0..N).find_map(|i| Some((i, beyond(i)?))) {
            Some((joint, limit)) => Err(Cause::JointLimit { joint, limit }),
            None => Ok(()),
        }
    }

    fn count(&mut self, before: &[Contact; N], after: &[Contact; N]) {
        self.in_a_row += 1;
        self.events += 1;
        let changed = (0..N).find(|i| before[*i] != after[*i]);
        self.joint = changed.unwrap_or(self.joint);
    }
}

/// Where, from 0 to 1, the cubic with these values and slopes at 0 and 1 has a negative minimum.
fn lowest([g0, g1]: [f64; 2], [d0, d1]: [f64; 2]) -> Option<f64> {
    if !(d0 < 0.0 && d1 > 0.0) {
        return None;
    }
    // g0 + d0 s + a s^2 + b s^3, and the root of its derivative where it turns upwards.
    let a = 3.0 * (g1 - g0) - 2.0 * d0 - d1;
    let b = 2.0 * (g0 - g1) + d0 + d1;
    let s = -d0 / (a + (a * a - 3.0 * b * d0).sqrt());
    let value = g0 + s * (d0 + s * (a + s * b));
    (s > 0.0 && s < 1.0 && value < 0.0).then_some(s)
}

#[cfg(test)]
mod tests {
    use super::lowest;

    #[test]
    fn dips_are_where_a_cubic_is_negative() {
        // (s - 1/2)^2 - 1/100.
        let s = lowest([0.24, 0.24], [-1.0, 1.0]).unwrap();
        assert!((s - 0.5).abs() < 1e-15);
        assert_eq!(lowest([0.26, 0.26], [-1.0, 1.0]), None);
        assert_eq!(lowest([0.1, 0.2], [1.0, 1.0]), None);
        // (s - 1/4)^2 (s + 1) - 1/50.
        let cubic = |s: f64| (s - 0.25).powi(2) * (s + 1.0) - 0.02;
        let slope = |s: f64| 2.0 * (s - 0.25) * (s + 1.0) + (s - 0.25).powi(2);
        let s = lowest([cubic(0.0), cubic(1.0)], [slope(0.0), slope(1.0)]).unwrap();
        assert!((s - 0.25).abs() < 1e-15);
    }
}
