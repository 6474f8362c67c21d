//! The arguments of the generated methods.

use super::{Shape, Size};

/// An argument of a generated method, after `&self`. Methods take theirs in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Argument {
    /// q, joint positions.
    Position,
    /// qd, joint velocities.
    Velocity,
    /// qdd, joint accelerations.
    Acceleration,
    /// tau, joint forces and torques.
    Force,
    /// The highest order of a series.
    Order,
}

impl Argument {
    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Argument::Position => "q",
            Argument::Velocity => "qd",
            Argument::Acceleration => "qdd",
            Argument::Force => "tau",
            Argument::Order => "order",
        }
    }

    /// The arrangement of its values; `None` of a number that counts something.
    pub const fn shape(self) -> Option<Shape> {
        match self {
            Argument::Position | Argument::Velocity | Argument::Acceleration | Argument::Force => {
                Some(Shape::Matrix(Size::Joints, Size::One))
            }
            Argument::Order => None,
        }
    }

    /// What it is, with its unit, for joints whose positions and forces have the units that are given;
    /// `None` where the description of the function says it.
    pub fn meaning(self, position: &str, force: &str) -> Option<String> {
        Some(match self {
            Argument::Position => format!("joint positions, {position}"),
            Argument::Velocity => format!("joint velocities, {position} per s"),
            Argument::Acceleration => format!("joint accelerations, {position} per s^2"),
            Argument::Force => format!("joint forces and torques, {force}"),
            Argument::Order => return None,
        })
    }
}
