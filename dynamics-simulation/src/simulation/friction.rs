//! Dry friction as a simulation has it.
//!
//! The torques hand the arm the dry friction that its forward dynamics takes off again, and take off what the mode of
//! each joint says. Where joints stick, the columns of M^-1 that hold them are derivatives by a torque, from dual
//! numbers. An event is located by taking the step again, shorter, so that it is as accurate as the method, and not
//! as its dense output. If a joint is let go, its acceleration is evaluated once more at the least velocity that way:
//! where a law that jumps at rest drives it back, there is no motion, and the run ends in `Cause::Chatter`.
//! Without that evaluation equal steps would make events for ever.

use dynamics_runtime::Size;
use dynamics_runtime::internal::JointFriction;

use super::error::InvalidSetting;

/// How a [`Simulation`](crate::Simulation) treats dry friction: Coulomb's, and static friction that falls to
/// it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Friction {
    /// As in the forward dynamics: a multiple of sign(qd), with sign(0) = 0.
    ///
    /// A joint that should stick chatters about zero velocity. Methods with error control end in
    /// [`Cause::Sticks`](crate::simulation::Cause::Sticks) if a million evaluations and steps do not lead on, and the
    /// simulation was given this kind of friction or stops. Methods of fixed step leave a velocity proportional to the step,
    /// and the motion says which joints [creep](crate::simulation::SizedTrajectory::creeping).
    #[default]
    Sign,
    /// With stopping and sticking as events.
    ///
    /// The time at which a joint's velocity crosses zero is found to rounding. From there the joint sticks, at a
    /// velocity of exactly zero, until the force that holds it exceeds friction: static friction where the table has
    /// one, else that of Coulomb. Between events the equations are smooth and every method has its order.
    ///
    /// Cost: one more evaluation of the forward dynamics at the end of each step. Where joints stick, an evaluation
    /// becomes one over dual numbers for each of these joints. An event takes about ten steps.
    ///
    /// A force that exceeds friction and is back below it within one step is not noticed. A torque law that drives a
    /// joint back to rest from both sides, harder than friction holds it, ends the run in
    /// [`Cause::Chatter`](crate::simulation::Cause::Chatter).
    Sticking,
    /// `tanh(qd / speed)` in place of the sign.
    ///
    /// Smooth, but stiff where `speed` is small (use [`Radau5`](crate::simulation::Radau5)), and a joint never
    /// sticks: under a force f below its friction it creeps at `speed atanh(f / coulomb)`. At half
    /// the friction and a speed of 1e-3 rad/s it turns 5.5e-3 rad in ten seconds.
    Regularised {
        /// The velocity at which friction has 76 % of its value, rad/s or m/s: positive and finite.
        speed: f64,
    },
}

/// The contact of a joint with friction or a stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Contact {
    /// It slides one way, 1 or -1, with friction the other way; or it has no friction, 0.
    Slides(f64),
    /// It sticks.
    Sticks,
    /// It leans on a stop, from which the way into its range is 1 or -1.
    Leans(f64),
}

impl Contact {
    /// Whether a force holds the joint where it is.
    pub(super) fn holds(self) -> bool {
        !matches!(self, Contact::Slides(_))
    }
}

/// Friction of an arm.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Law<D: Size> {
    pub(super) kind: Friction,
    pub(super) dry: D::Each<JointFriction>,
}

impl<D: Size> Law<D> {
    pub(super) fn sign(size: D) -> Self {
        Law {
            kind: Friction::Sign,
            dry: size.each(|_| JointFriction::NONE),
        }
    }

    pub(super) fn validate(&self) -> Result<(), InvalidSetting> {
        match self.kind {
            Friction::Regularised { speed } if !(speed > 0.0 && speed.is_finite()) => {
                Err(InvalidSetting::FrictionSpeed(speed))
            }
            _ => Ok(()),
        }
    }
}
