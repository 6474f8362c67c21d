//! Events of a motion whose series are known: zeros of polynomials.
//!
//! A series is a polynomial, of position and of the force that holds a joint that leans on its stop. Its first zero
//! in the step is the event. Intervals are halved in the basis of Bernstein, whose changes of sign bound the number
//! of zeros (`taylor::first_root`): steps are long, and a joint may pass a limit and be back several times in one.

use nalgebra::Const;

use super::error::Cause;
use super::events::{Finder, Start};
use super::friction::Contact;
use super::limits::{AtLimit, End};
use super::motion::{Held, Motion};
use crate::integrate::Stepper;
use crate::taylor::{Polynomial, SeriesStepper, Steady};

/// The first zero of the way to a limit, or of the force on a stop, over a step: to rounding, however often a joint
/// turns.
pub(super) struct BySeries;

/// A force on a stop that is less than so many roundings of its greatest term is none.
const ROUNDINGS_OF_FORCE: f64 = 16.0;

impl<S: Steady<N>, const N: usize> Finder<S, SeriesStepper<S::Arm, N>, Const<N>> for BySeries {
    fn first_event(
        motion: &Motion<'_, Const<N>>,
        system: &S,
        stepper: &mut SeriesStepper<S::Arm, N>,
        start: &Start<Const<N>>,
    ) -> Result<Option<Held<Const<N>>>, Cause> {
        let limits = &motion.limits;
        let contacts = motion.contacts();
        let of_joint = |i: usize| match contacts[i] {
            Contact::Leans(inwards) => {
                let force = stepper.holding_force(i).less(0.0, inwards);
                force.first_passage(ROUNDINGS_OF_FORCE * f64::EPSILON * force.size())
            }
            _ => {
                let position = stepper.position(i);
                let ends = limits.ends(i);
                let times = ends.filter_map(|end| arrival(limits.kind, &end, position));
                times.reduce(f64::min)
            }
        };
        let Some(share) = (0..N).filter_map(of_joint).reduce(f64::min) else {
            return Ok(Some(start.held.clone()));
        };
        let t = stepper.time_at(share).max(start.t.next_up());
        Stepper::<_, Cause, Const<N>>::retake(stepper, system, t)?;
        Ok(None)
    }
}

/// When a joint arrives at an end of its range. Where that is an error, it may be there.
fn arrival(kind: AtLimit, end: &End, position: Polynomial) -> Option<f64> {
    let gap = position.less(end.at, end.inwards);
    match kind {
        AtLimit::Ends => gap.first_passage(end.resolution()),
        _ => {
            let rounding = f64::EPSILON * (1.0 + end.at.abs());
            gap.first_passage(rounding).map(|share| gap.refined(share))
        }
    }
}
