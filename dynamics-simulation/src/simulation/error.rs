//! How a simulation ends early.

use core::fmt;

use dynamics_runtime::internal::{JointName, Velocities};
use dynamics_runtime::{
    JointVector as _, NAMES_OF_BASE, Pose, SingularMassMatrix, Size, SizedModel, Sizes,
};
use nalgebra::Const;

use super::joint_set::JointSet;
use super::trajectory::SizedTrajectory;
use crate::taylor::Refusal;

/// A simulation that could not reach its end, with everything that it computed before.
///
/// `{:?}`, which `unwrap` and an error of `main` print, is the sentence of `{}` and the number of samples.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub struct SizedSimulationError<K: Sizes> {
    /// The time reached, s.
    pub time: f64,
    /// The pose of a base that moves then; the identity of one that stands.
    pub base: Pose<f64>,
    /// The joint positions reached, rad or m.
    pub q: <K::Joints as Size>::Vector,
    /// The velocities reached, rad/s or m/s.
    pub qd: Velocities<K>,
    /// Why the motion does not go on from there. Its joints count the six numbers of a base that moves first.
    pub cause: Cause,
    /// The names of the joints, if the sentence has them ([`naming`](SizedSimulationError::naming)).
    pub(super) joint_names: Vec<String>,
    /// The samples up to there.
    pub trajectory: SizedTrajectory<K>,
}

/// A simulation of an arm of `N` joints that could not reach its end.
pub type SimulationError<const N: usize> = SizedSimulationError<Const<N>>;

/// The result of a simulation.
pub(super) type Outcome<K> = Result<SizedTrajectory<K>, Box<SizedSimulationError<K>>>;

/// Why a simulation ended early.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Cause {
    /// A setting makes no sense.
    InvalidSetting(InvalidSetting),
    /// The mass matrix is not positive definite.
    SingularMassMatrix(SingularMassMatrix),
    /// The torque law returned a torque that is not finite.
    NonFiniteTorque {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// A law of the force at the tool or at a frame returned one that is not finite.
    NonFiniteToolWrench {
        /// The component of (fx fy fz nx ny nz), counted from 0.
        component: usize,
    },
    /// An acceleration is not finite.
    NonFiniteAcceleration {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// A position or a velocity is not finite.
    NonFiniteState {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// The error stays beyond the tolerance at every step, down to those that vanish in the rounding of the time.
    StepTooSmall,
    /// The equations of a step of an implicit method are not solved by iteration: the step is too
    /// long.
    NoConvergence,
    /// The greatest number of steps between two samples was made, or a tenth of it, 10,000 at least, so far from the next sample
    /// that 30 times the greatest number would not be enough.
    TooManySteps,
    /// The same, and a joint is faster than 1e4 rad/s or m/s, ten times faster than any began.
    ///
    /// A law of the wrong sign does that, and a sampled one whose gains are too high for its period.
    RunsAway {
        /// The fastest joint, counted from 0.
        joint: usize,
        /// Its speed, rad/s or m/s.
        speed: f64,
    },
    /// A joint passes an end of its range, where that is an error
    /// ([`Simulation::limits_are_errors`](crate::Simulation::limits_are_errors)).
    JointLimit {
        /// The joint, counted from 0.
        joint: usize,
        /// The end of its range, rad or m.
        limit: f64,
    },
    /// A joint stops and is let go again and again. The torques drive it back to rest whichever way it moves, and neither
    /// friction ([`Friction::Sticking`](crate::Friction::Sticking)) nor a stop holds it there.
    ///
    /// Torque laws that jump where the velocity passes zero, such as those with `signum`, do that. Make the law continuous
    /// there, by a boundary layer for example. Under error control, and where steps end at events, this ends a run that a
    /// million evaluations and steps did not lead on, if its rest would take as many again. Dry friction does it too in a
    /// simulation that was not given a kind of friction. [`Friction::Sticking`](crate::Friction::Sticking) lets the joint rest.
    Chatter {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// A joint with dry friction by its sign ([`Friction::Sign`](crate::Friction::Sign)) should stick: it turns back again and
    /// again, in ever shorter steps. A million evaluations and steps did not lead on, and the rest would take as many again. A
    /// run of fixed steps goes on and creeps: [`creeping`](crate::simulation::SizedTrajectory::creeping) has its joints.
    ///
    /// [`Friction::Sticking`](crate::Friction::Sticking) lets it rest.
    Sticks {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// Joints hit their stops again and again: a million evaluations and steps did not lead on, and 100 samples, or the rest of
    /// the run, would take as many again.
    ///
    /// Elastic stops (a restitution of 1) under a strong force, and torque laws that jump at a stop, do that. A lower
    /// restitution, a continuous law, or more samples help. Bounces below the tolerance come to rest before that.
    Impacts {
        /// The joints that take part.
        joints: JointSet,
    },
}

impl Cause {
    /// The cause under error control, where every state that is reached is finite: a stage that is not belongs to a
    /// step that is too long.
    pub(super) fn of_long_steps(self) -> Self {
        match self {
            Cause::NonFiniteState { .. } => Cause::StepTooSmall,
            cause => cause,
        }
    }
}

/// A setting of a simulation that makes no sense.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum InvalidSetting {
    /// The duration is not a finite number of seconds above 1e-292 s, at which the rounding of the time is the least
    /// number.
    Duration(f64),
    /// There are fewer than two samples, or more than memory holds.
    Samples(usize),
    /// The step, or the longest step, is not positive, or lost in the rounding of the time; or a fixed step is not
    /// finite.
    Step(f64),
    /// A tolerance is not a positive finite number.
    Tolerance(f64),
    /// The order of a Taylor series is not one of those that steps are chosen for.
    Order(usize),
    /// A joint has Coulomb friction, which the Taylor method does not follow.
    CoulombFriction {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// An initial position or velocity is not finite.
    InitialState {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// The place at the start has another number of joints than a robot that is known at run time.
    Positions {
        /// The robot's number of joints.
        expected: usize,
        /// The number of positions that were given.
        found: usize,
    },
    /// The start has another number of velocities than a robot that is known at run time.
    Velocities {
        /// The robot's number of velocities: six more than joints where its base moves.
        expected: usize,
        /// The number of velocities that were given.
        found: usize,
    },
    /// The speed of regularised friction is not a positive finite number.
    FrictionSpeed(f64),
    /// Steps of fixed length, or periods at which laws are sampled, would be more than 100 000 between two samples, or 10
    /// million in a run of fewer than 101 samples.
    TooManySteps {
        /// The number of steps up to the end.
        steps: f64,
        /// The greatest number of them in a run of so many samples.
        most: f64,
    },
    /// The period at which laws are sampled is not a positive finite number of seconds, or lost in the
    /// rounding of the time.
    Period(f64),
    /// The restitution of stops is not a number from 0 to 1.
    Restitution(f64),
    /// The limits of a joint, which are stops or errors, are no range: not numbers, or not in order.
    Limits {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// The greatest torque of a joint, where motors saturate, is not a number above zero.
    TorqueLimit {
        /// The joint, counted from 0.
        joint: usize,
    },
    /// A joint begins outside of its limits, which are stops or errors.
    OutsideLimits {
        /// The joint, counted from 0.
        joint: usize,
        /// Where it begins, rad or m.
        q: f64,
        /// Its limits, rad or m.
        limits: [f64; 2],
    },
    /// The method works in positions and momenta, and the arm lacks the functions for these: see
    /// [`ForwardDynamics::momenta`](dynamics_runtime::ForwardDynamics::momenta).
    NoMomenta,
    /// The method is implicit, and the base moves: its rotation is followed by explicit methods alone.
    MovingBase,
    /// The rotation of the base at the start is none: its columns are not orthogonal unit vectors to 1e-6, right-handed.
    Rotation,
}

impl<K: Sizes> fmt::Display for SizedSimulationError<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [q, qd] = [self.q.entries(), self.qd.entries()];
        // A start of another length than the robot's says nothing of a base.
        let of_base = match qd.len().checked_sub(q.len()) {
            Some(of_base) if of_base == NAMES_OF_BASE.len() => of_base,
            _ => 0,
        };
        write!(f, "the simulation ended at t = {:?} s: ", self.time)?;
        let freedoms = Freedoms {
            of_base,
            joints: &self.joint_names,
        };
        self.cause.write(f, freedoms)?;
        f.write_str(" (")?;
        if of_base > 0 {
            write!(f, "base = {:?}, ", self.base.entries().as_slice())?;
        }
        write!(f, "q = {q:?}, qd = {qd:?})")
    }
}

impl<K: Sizes> fmt::Debug for SizedSimulationError<K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let samples = self.trajectory.len();
        write!(f, "{self}; `trajectory` has {samples} samples up to there")
    }
}

impl<K: Sizes> core::error::Error for SizedSimulationError<K> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match &self.cause {
            Cause::SingularMassMatrix(source) => Some(source),
            Cause::InvalidSetting(source) => Some(source),
            _ => None,
        }
    }
}

impl<K: Sizes> SizedSimulationError<K> {
    /// The error with the names of the robot's joints in its sentence: `joint 2 (elbow)` in place of `joint 2`.
    #[must_use]
    pub fn naming(mut self, robot: &impl SizedModel<K>) -> Self {
        self.joint_names = robot.names().as_ref().to_vec();
        self
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f, Freedoms::default())
    }
}

/// The names of freedoms, as causes and settings count them: those of the base first.
#[derive(Clone, Copy, Debug, Default)]
struct Freedoms<'a> {
    of_base: usize,
    /// The names of the joints, if they are known.
    joints: &'a [String],
}

impl Freedoms<'_> {
    /// The name of a freedom: joints count from 1.
    fn name(self, freedom: usize) -> String {
        if let Some(name) = NAMES_OF_BASE[..self.of_base].get(freedom) {
            return (*name).to_owned();
        }
        let joint = freedom - self.of_base;
        JointName(joint, self.joints.get(joint).map(String::as_str)).to_string()
    }

    /// Joints by their own numbers.
    fn joints(self, set: JointSet) -> JointSet {
        set.behind(self.of_base)
    }
}

impl Cause {
    fn write(&self, f: &mut fmt::Formatter<'_>, freedoms: Freedoms<'_>) -> fmt::Result {
        let mut not_finite = |what: &str, joint: &usize| {
            write!(f, "the {what} of {} is not finite", freedoms.name(*joint))
        };
        match self {
            Cause::InvalidSetting(setting) => setting.write(f, freedoms),
            Cause::SingularMassMatrix(error) => write!(f, "{error}"),
            Cause::NonFiniteTorque { joint } => not_finite("torque", joint),
            Cause::NonFiniteAcceleration { joint } => not_finite("acceleration", joint),
            Cause::NonFiniteState { joint } => not_finite("state", joint),
            Cause::NonFiniteToolWrench { component } => {
                let name = ["fx", "fy", "fz", "nx", "ny", "nz"][component % 6];
                write!(f, "{name} of the force at the tool or at a frame is not finite")
            }
            Cause::StepTooSmall => f.write_str(
                "no step is short enough for the tolerance: shorter ones are lost in the rounding of the time",
            ),
            Cause::NoConvergence => f.write_str("the step is too long for an implicit method"),
            Cause::TooManySteps => f.write_str(
                "more steps between two samples than `max_steps`: a larger tolerance, more samples or, for a stiff arm, Radau's method help",
            ),
            Cause::RunsAway { joint, speed } => write!(
                f,
                "{} runs away, at {speed:.1e} rad/s or m/s: a law of the wrong sign does that, and a sampled one whose gains are too high for its period",
                freedoms.name(*joint)
            ),
            Cause::JointLimit { joint, limit } => {
                write!(f, "{} passes its limit {limit:?}", freedoms.name(*joint))
            }
            Cause::Chatter { joint } => write!(
                f,
                "{} chatters: the torques drive it back to rest from both sides; a law has to be continuous there, and dry friction has to be sticking friction",
                freedoms.name(*joint)
            ),
            Cause::Sticks { joint } => write!(
                f,
                "{} is held at rest by its dry friction, and friction by the sign of the velocity cannot rest: take sticking friction",
                freedoms.name(*joint)
            ),
            Cause::Impacts { joints } => write!(
                f,
                "the motion does not get on at the stops of {}: they hit or leave them again and again",
                freedoms.joints(*joints)
            ),
        }
    }
}

impl fmt::Display for InvalidSetting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(f, Freedoms::default())
    }
}

impl InvalidSetting {
    fn write(&self, f: &mut fmt::Formatter<'_>, freedoms: Freedoms<'_>) -> fmt::Result {
        const TIME: &str = "a finite time that is not lost in the rounding of the duration";
        let mut impossible = |given: fmt::Arguments<'_>, expected: &str| {
            write!(f, "{given} is not possible: expected {expected}")
        };
        match self {
            InvalidSetting::Duration(duration) => impossible(
                format_args!("a duration of {duration:?} s"),
                "a finite time above 1e-292 s",
            ),
            InvalidSetting::Step(step) => impossible(format_args!("a step of {step:?} s"), TIME),
            InvalidSetting::Period(period) => {
                impossible(format_args!("a period of {period:?} s"), TIME)
            }
            InvalidSetting::TooManySteps { steps, most } => write!(
                f,
                "the run would take {steps:.0} steps of fixed length, and with so many samples {most:.0} are the most: take a longer step or control period, or more samples"
            ),
            InvalidSetting::Tolerance(tolerance) => impossible(
                format_args!("a tolerance of {tolerance:?}"),
                "a finite number above zero",
            ),
            InvalidSetting::Samples(samples) => write!(
                f,
                "{samples} samples are not possible: expected two at least, and no more than memory holds"
            ),
            InvalidSetting::Order(order) => write!(f, "series of order {order} are not possible"),
            InvalidSetting::CoulombFriction { joint } => write!(
                f,
                "{} has Coulomb friction, which Taylor series do not follow",
                freedoms.name(*joint)
            ),
            InvalidSetting::InitialState { joint } => {
                write!(f, "the initial state of {} is not finite", freedoms.name(*joint))
            }
            InvalidSetting::Positions { expected, found } => {
                write!(f, "the start has {found} positions: expected {expected}")
            }
            InvalidSetting::Velocities { expected, found } => {
                write!(f, "the start has {found} velocities: expected {expected}")
            }
            InvalidSetting::FrictionSpeed(speed) => {
                write!(f, "friction cannot be regularised over a speed of {speed:?}")
            }
            InvalidSetting::Restitution(restitution) => write!(
                f,
                "a restitution of {restitution:?} is not possible: it lies between 0 and 1"
            ),
            InvalidSetting::Limits { joint } => write!(
                f,
                "the limits of {} are no range: the lower one first, both numbers",
                freedoms.name(*joint)
            ),
            InvalidSetting::TorqueLimit { joint } => {
                write!(f, "the torque limit of {} is not a number above zero", freedoms.name(*joint))
            }
            InvalidSetting::OutsideLimits { joint, q, limits } => write!(
                f,
                "{} begins at {q:?}, outside of its limits {:?} to {:?}",
                freedoms.name(*joint),
                limits[0],
                limits[1]
            ),
            InvalidSetting::NoMomenta => f.write_str(
                "the method works in momenta, for which the arm lacks mass_matrix or inverse_dynamics",
            ),
            InvalidSetting::MovingBase => f.write_str(
                "the method is implicit and follows no base that moves: take DormandPrince, Dop853, RungeKutta4 or one of Euler's",
            ),
            InvalidSetting::Rotation => f.write_str(
                "the rotation of the base is none: its columns are the axes of the base, orthogonal unit vectors to 1e-6, right-handed",
            ),
        }
    }
}

impl core::error::Error for Cause {}

impl core::error::Error for InvalidSetting {}

impl From<InvalidSetting> for Cause {
    fn from(setting: InvalidSetting) -> Self {
        Cause::InvalidSetting(setting)
    }
}

impl From<SingularMassMatrix> for Cause {
    fn from(error: SingularMassMatrix) -> Self {
        Cause::SingularMassMatrix(error)
    }
}

impl From<Refusal> for Cause {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::State { joint } => Cause::NonFiniteState { joint },
            Refusal::Acceleration { joint } => Cause::NonFiniteAcceleration { joint },
            Refusal::Singular(error) => Cause::SingularMassMatrix(error),
        }
    }
}
