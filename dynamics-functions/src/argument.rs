//! The arguments of the generated methods.

use super::{Shape, Size};

/// An argument of a generated method, after `&self`. Methods take theirs in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Argument {
    /// Where a base that moves stands: nine entries of its rotation by rows, then its position. A base that stands has none.
    Base,
    /// q, joint positions.
    Position,
    /// qd, joint velocities.
    Velocity,
    /// qdd, joint accelerations.
    Acceleration,
    /// tau, joint forces and torques.
    Force,
    /// qd_r, the velocities of a reference motion.
    ReferenceVelocity,
    /// qdd_r, the accelerations of a reference motion.
    ReferenceAcceleration,
    /// jerk, the rates of the joint accelerations.
    Jerk,
    /// snap, the rates of the jerk.
    Snap,
    /// A force on the tip and a moment about its origin.
    Wrench,
    /// The highest order of a series.
    Order,
    /// The pose of a frame that is to be reached: nine entries of its rotation by rows, then its position.
    Pose,
}

impl Argument {
    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Argument::Base => "base",
            Argument::Position => "q",
            Argument::Velocity => "qd",
            Argument::Acceleration => "qdd",
            Argument::Force => "tau",
            Argument::ReferenceVelocity => "qd_r",
            Argument::ReferenceAcceleration => "qdd_r",
            Argument::Jerk => "jerk",
            Argument::Snap => "snap",
            Argument::Wrench => "wrench",
            Argument::Order => "order",
            Argument::Pose => "pose",
        }
    }

    /// The arrangement of its values; `None` of a number that counts something.
    pub const fn shape(self) -> Option<Shape> {
        match self {
            Argument::Base | Argument::Pose => Some(Shape::Matrix(Size::Fixed(12), Size::One)),
            Argument::Position => Some(Shape::Matrix(Size::Joints, Size::One)),
            Argument::Velocity
            | Argument::Acceleration
            | Argument::Force
            | Argument::ReferenceVelocity
            | Argument::ReferenceAcceleration
            | Argument::Jerk
            | Argument::Snap => Some(Shape::Matrix(Size::Freedoms, Size::One)),
            Argument::Wrench => Some(Shape::Matrix(Size::Fixed(6), Size::One)),
            Argument::Order => None,
        }
    }

    /// Its meaning with its unit, for joints whose positions and forces have the units that are given;
    /// `None` where the description of the function says it.
    pub fn meaning(self, position: &str, force: &str) -> Option<String> {
        Some(match self {
            Argument::Base => "where the base stands: its axes in the world as columns of a rotation, and its origin, m"
                .to_owned(),
            Argument::Position => format!("joint positions, {position}"),
            Argument::Velocity => format!("joint velocities, {position} per s"),
            Argument::Acceleration => format!("joint accelerations, {position} per s^2"),
            Argument::Force => format!("joint forces and torques, {force}"),
            Argument::ReferenceVelocity => format!("reference velocities, {position} per s"),
            Argument::ReferenceAcceleration => {
                format!("reference accelerations, {position} per s^2")
            }
            Argument::Jerk => format!("rates of the accelerations, {position} per s^3"),
            Argument::Snap => format!("rates of `jerk`, {position} per s^4"),
            Argument::Wrench => "force (N) on the tip and moment (N m) about its origin, \
                fx fy fz nx ny nz in the axes of `jacobian`, that the surroundings apply"
                .to_owned(),
            Argument::Pose => "pose that is to be reached: axes as columns of a rotation, and origin, m".to_owned(),
            Argument::Order => return None,
        })
    }

    /// As [`Argument::meaning`], of a robot whose base moves: what has an entry for each degree of freedom begins with six
    /// of the base.
    pub fn meaning_on_moving_base(self, position: &str, force: &str) -> Option<String> {
        let (name, units) = match self {
            Argument::Velocity => ("velocities", ["m/s", "rad/s"]),
            Argument::Acceleration => ("accelerations", ["m/s^2", "rad/s^2"]),
            Argument::Force => ("forces and moments", ["N", "N m"]),
            Argument::ReferenceVelocity => ("reference velocities", ["m/s", "rad/s"]),
            Argument::ReferenceAcceleration => ("reference accelerations", ["m/s^2", "rad/s^2"]),
            _ => return self.meaning(position, force),
        };
        let [linear, angular] = units;
        let of_joints = self.meaning(position, force)?;
        Some(format!(
            "{name}: of the base in its own axes, three linear ({linear}) and three angular ({angular}), then {of_joints}"
        ))
    }
}
