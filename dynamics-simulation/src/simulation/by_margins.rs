//! Events of a method that is known at the times at which its steps end: where the least margin of all joints
//! passes zero.

use dynamics_runtime::Size;

use super::error::Cause;
use super::events::{Finder, Start, here};
use super::friction::Contact;
use super::motion::{Held, Motion};
use crate::integrate::Stepper;

/// Margins at the ends of steps, and a step that is taken again.
pub(super) struct ByMargins;

impl<S, K: ?Sized, D: Size> Finder<S, K, D> for ByMargins
where
    K: Stepper<S, Cause, D>,
{
    fn first_event(
        motion: &Motion<D>,
        system: &S,
        stepper: &mut K,
        start: &Start<D>,
    ) -> Result<Option<Held<D>>, Cause> {
        let mut search = Search {
            motion,
            system,
            stepper,
        };
        let (margin, after) = here(motion, search.stepper)?;
        if margin >= 0.0 && !search.dips(start, &after)? {
            return Ok(Some(after));
        }
        search.locate(
            start.t,
            motion.least_margin(&motion.contacts(), &start.phase, &start.held),
        )?;
        Ok(None)
    }
}

struct Search<'a, 'm, S, K: ?Sized, D: Size> {
    motion: &'a Motion<'m, D>,
    system: &'a S,
    stepper: &'a mut K,
}

impl<S, K: ?Sized, D: Size> Search<'_, '_, S, K, D>
where
    K: Stepper<S, Cause, D>,
{
    /// Whether a velocity, or the way to a limit, dips below zero within a step that ends well; the
    /// stepper then is there.
    fn dips(&mut self, start: &Start<D>, after: &Held<D>) -> Result<bool, Cause> {
        let late = self.stepper.t();
        let dip = self.dip(start, after);
        let Some(dip) = dip.filter(|dip| start.t < *dip && *dip < late) else {
            return Ok(false);
        };
        self.stepper.retake(self.system, dip)?;
        if here(self.motion, self.stepper)?.0 < 0.0 {
            return Ok(true);
        }
        self.stepper.retake(self.system, late)?;
        Ok(false)
    }

    /// The time within the step at which a velocity dips below zero, or a position passes a limit, that is back at the
    /// end. It is that of the cubic through values and slopes at both ends.
    fn dip(&self, start: &Start<D>, after: &Held<D>) -> Option<f64> {
        let Start {
            t,
            phase: from,
            held: before,
        } = start;
        let to = self.stepper.phase();
        let h = self.stepper.t() - t;
        let contacts = self.motion.contacts();
        let of_velocity = |i: usize| match contacts[i] {
            Contact::Slides(way) => lowest(
                [way * from.qd[i], way * to.qd[i]],
                [way * before.qdd[i] * h, way * after.qdd[i] * h],
            ),
            _ => None,
        };
        let limits = &self.motion.limits;
        let of_position = |i: usize| {
            let ends = limits.ends(i).filter_map(move |end| {
                lowest(
                    [from.q[i], to.q[i]].map(|q| limits.margin(&end, q)),
                    [from.qd[i], to.qd[i]].map(|qd| end.inwards * qd * h),
                )
            });
            ends.reduce(f64::min)
        };
        let dips = self
            .motion
            .joints()
            .flat_map(|i| [of_velocity(i), of_position(i)]);
        dips.flatten().reduce(f64::min).map(|s| t + s * h)
    }

    /// Takes the step again, so that it ends where the least margin passes zero: it was `margin` at `start` and is
    /// negative here. False position after Illinois (M. Dowell, P. Jarratt, BIT 11 (1971)), by halves where that does
    /// not apply.
    fn locate(&mut self, start: f64, margin: f64) -> Result<(), Cause> {
        let (mut a, mut at_a) = (start, margin);
        let (mut b, mut at_b) = (self.stepper.t(), here(self.motion, self.stepper)?.0);
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
            let at_c = here(self.motion, self.stepper)?.0;
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
