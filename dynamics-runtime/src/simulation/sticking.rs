//! Stopping, sticking and letting go: an integration between events.

use super::friction::Contact;
use super::motion::{Held, Motion};
use super::trajectory::Recorder;
use super::{Cause, TorqueLaw};
use crate::ForwardDynamics;
use crate::integrate::{Phase, Stepper};

/// Sets what friction does to each joint at the start: those at rest stick, if it holds them.
pub(super) fn settle_at_start<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    phase: &Phase<N>,
) -> Result<(), Cause>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    let coulomb = motion.coulomb();
    motion.set_contacts(core::array::from_fn(|i| {
        if coulomb[i] == 0.0 {
            Contact::Slides(0.0)
        } else if phase.qd[i] == 0.0 {
            Contact::Sticks
        } else {
            Contact::Slides(phase.qd[i].signum())
        }
    }));
    settle(motion, 0.0, phase)?;
    Ok(())
}

/// Lets go of joints that friction cannot hold, the one that it holds least first.
fn settle<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    t: f64,
    phase: &Phase<N>,
) -> Result<Held<N>, Cause>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
{
    let coulomb = motion.coulomb();
    loop {
        let held = motion.held(t, phase)?;
        let mut contacts = motion.contacts();
        let excess = |i: usize| held.forces[i].abs() / coulomb[i];
        let stuck = (0..N).filter(|i| contacts[*i] == Contact::Sticks);
        let worst = stuck.max_by(|i, j| excess(*i).total_cmp(&excess(*j)));
        match worst {
            Some(i) if excess(i) > 1.0 => {
                contacts[i] = Contact::Slides(-held.forces[i].signum());
                motion.set_contacts(contacts);
            }
            _ => return Ok(held),
        }
    }
}

/// How far joint `i` is from its next event: the velocity of one that slides, the friction left of
/// one that sticks.
fn margin<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    i: usize,
    phase: &Phase<N>,
    held: &Held<N>,
) -> f64 {
    match motion.contacts()[i] {
        Contact::Slides(0.0) => f64::INFINITY,
        Contact::Slides(way) => way * phase.qd[i],
        Contact::Sticks => motion.coulomb()[i] - held.forces[i].abs(),
    }
}

fn least_margin<R, L, const N: usize>(
    motion: &Motion<R, L, N>,
    phase: &Phase<N>,
    held: &Held<N>,
) -> f64 {
    let margins = (0..N).map(|i| margin(motion, i, phase, held));
    margins.fold(f64::INFINITY, f64::min)
}

/// An integration whose steps end at the events.
pub(super) struct Sticking<'a, S, R, L, K, const N: usize> {
    motion: &'a Motion<'a, R, L, N>,
    system: &'a S,
    stepper: K,
    held: Held<N>,
    /// Events since time went on.
    idle: usize,
}

impl<'a, S, R, L, K, const N: usize> Sticking<'a, S, R, L, K, N>
where
    R: ForwardDynamics<N>,
    L: TorqueLaw<N>,
    K: Stepper<S, Cause, N>,
{
    /// From where the stepper is.
    pub(super) fn start(
        motion: &'a Motion<'a, R, L, N>,
        system: &'a S,
        stepper: K,
    ) -> Result<Self, Cause> {
        let held = motion.held(stepper.t(), stepper.phase())?;
        Ok(Sticking {
            motion,
            system,
            stepper,
            held,
            idle: 0,
        })
    }

    /// Makes steps to the end of the recorder's plan, at most `max_steps` between two samples.
    pub(super) fn drive(
        mut self,
        recorder: &mut Recorder<N>,
        max_steps: usize,
    ) -> Result<(), Cause> {
        let mut steps = 0;
        while recorder.next_sample().is_some() {
            if steps == max_steps || self.idle > 4 * N + 8 {
                return Err(Cause::TooManySteps);
            }
            let made = self.advance(recorder.duration());
            recorder.work.rejected = self.stepper.rejected();
            let event = made?;
            let end = self.stopped(event);
            recorder.reach(self.stepper.t(), end)?;
            steps += 1;
            while let Some(t) = recorder.next_sample().filter(|t| *t <= self.stepper.t()) {
                let phase = match t == self.stepper.t() {
                    true => end,
                    false => self.stepper.at(self.system, t)?,
                };
                recorder.push(t, phase);
                steps = 0;
            }
            if event {
                self.change(end)?;
            }
        }
        Ok(())
    }

    /// Makes a step, up to the first event in it; whether there was one.
    fn advance(&mut self, end: f64) -> Result<bool, Cause> {
        let (t, phase, held) = (self.stepper.t(), *self.stepper.phase(), self.held);
        self.stepper.step(self.system, end)?;
        let (margin, after) = self.here()?;
        let late = self.stepper.t();
        if margin >= 0.0 {
            let Some(dip) = self.dip(t, &phase, &held, &after) else {
                self.held = after;
                self.idle = 0;
                return Ok(false);
            };
            self.stepper.retake(self.system, dip)?;
            if self.here()?.0 >= 0.0 {
                self.stepper.retake(self.system, late)?;
                self.held = after;
                self.idle = 0;
                return Ok(false);
            }
        }
        self.locate(t, least_margin(self.motion, &phase, &held))?;
        self.idle = if self.stepper.t() > t {
            0
        } else {
            self.idle + 1
        };
        Ok(true)
    }

    /// The least margin where the stepper is, and the forces there.
    fn here(&self) -> Result<(f64, Held<N>), Cause> {
        let phase = self.stepper.phase();
        let held = self.motion.held(self.stepper.t(), phase)?;
        Ok((least_margin(self.motion, phase, &held), held))
    }

    /// The time at which a velocity that keeps its sign from one end of the step to the other dips
    /// below zero, by the cubic through its values and slopes at the ends.
    fn dip(&self, t: f64, from: &Phase<N>, before: &Held<N>, after: &Held<N>) -> Option<f64> {
        let to = self.stepper.phase();
        let h = self.stepper.t() - t;
        let lowest = |i: usize| match self.motion.contacts()[i] {
            Contact::Slides(way) => lowest(
                [way * from.qd[i], way * to.qd[i]],
                [way * before.qdd[i] * h, way * after.qdd[i] * h],
            ),
            Contact::Sticks => None,
        };
        (0..N)
            .filter_map(lowest)
            .reduce(f64::min)
            .map(|s| t + s * h)
    }

    /// Takes the step again, so that it ends where the least margin, which was `margin` at `start`
    /// and is negative here, passes zero: false position after Illinois (M. Dowell, P. Jarratt, BIT
    /// 11 (1971)), by halves where that does not apply.
    fn locate(&mut self, start: f64, margin: f64) -> Result<(), Cause> {
        let (mut a, mut at_a) = (start, margin);
        let (mut b, mut at_b) = (self.stepper.t(), self.here()?.0);
        let rounding = 4.0 * f64::EPSILON * (at_a.abs() + at_b.abs());
        let mut side = 0;
        while b - a > 4.0 * f64::EPSILON * b && at_b < -rounding {
            let secant = b - at_b * (b - a) / (at_b - at_a);
            let inside = at_a > 0.0 && secant > a && secant < b;
            let c = if inside { secant } else { 0.5 * (a + b) };
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
                Contact::Sticks => true,
            };
            if stops {
                phase.qd[i] = 0.0;
            }
        }
        phase
    }

    /// Goes on after an event: a joint that stopped sticks, one that friction does not hold is let
    /// go.
    fn change(&mut self, phase: Phase<N>) -> Result<(), Cause> {
        let t = self.stepper.t();
        let (least, held) = self.here()?;
        let contacts = self.motion.contacts();
        let next = core::array::from_fn(|i| match contacts[i] {
            Contact::Slides(way) if way != 0.0 && phase.qd[i] == 0.0 => Contact::Sticks,
            // It was held until now by all the friction that there is.
            Contact::Sticks if margin(self.motion, i, &phase, &held) <= least.max(0.0) => {
                Contact::Slides(-held.forces[i].signum())
            }
            contact => contact,
        });
        self.motion.set_contacts(next);
        self.held = settle(self.motion, t, &phase)?;
        self.stepper.restart(self.system, phase)?;
        Ok(())
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
