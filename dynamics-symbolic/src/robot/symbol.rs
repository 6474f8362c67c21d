//! The meaning of the symbols in a robot's equations.

use super::Value;
use crate::function::Argument;

/// The meaning of a symbol. Indices count the degrees of freedom from 0: of a base that moves six, which have a velocity, an
/// acceleration and a force alone, then the joints, those that are locked left out. Joints that
/// follow others come after all that move by themselves, and have symbols of their own only for what is
/// no polynomial in those of the joint they follow.
#[derive(Clone, Debug, PartialEq)]
pub enum Symbol {
    /// The circle's ratio.
    Pi,
    /// A symbolic parameter.
    Field(usize),
    /// Sine of a constant or parametric angle.
    AngleSine(Value),
    /// Cosine of a constant or parametric angle.
    AngleCosine(Value),
    /// Sine of a joint angle; of a follower, of the leader's position times the factor, without the offset.
    Sine(usize),
    /// Cosine of such an angle.
    Cosine(usize),
    /// A joint's position, q.
    Position(usize),
    /// A joint's velocity, qd.
    Velocity(usize),
    /// A joint's acceleration, qdd.
    Acceleration(usize),
    /// A joint's force or torque, tau.
    Force(usize),
    /// The sign of a joint's or a follower's velocity.
    VelocitySign(usize),
    /// exp(-(qd/v)^2) of a joint's or a follower's velocity and its [Stribeck velocity](super::Stribeck): what is left
    /// of the static friction beyond Coulomb's.
    Stribeck(usize),
    /// An entry of another argument than q, qd, qdd and tau.
    Entry(Argument, usize),
}

impl Symbol {
    /// The argument and the index of the entry that the symbol stands for, where it is one.
    pub fn entry(&self) -> Option<(Argument, usize)> {
        match *self {
            Symbol::Position(i) => Some((Argument::Position, i)),
            Symbol::Velocity(i) => Some((Argument::Velocity, i)),
            Symbol::Acceleration(i) => Some((Argument::Acceleration, i)),
            Symbol::Force(i) => Some((Argument::Force, i)),
            Symbol::Entry(argument, i) => Some((argument, i)),
            _ => None,
        }
    }

    /// The argument, and the index of the joint or entry, on which the symbol depends; `None` of constants and
    /// parameters.
    pub fn argument(&self) -> Option<(Argument, usize)> {
        match *self {
            Symbol::Sine(i) | Symbol::Cosine(i) => Some((Argument::Position, i)),
            Symbol::VelocitySign(i) | Symbol::Stribeck(i) => Some((Argument::Velocity, i)),
            _ => self.entry(),
        }
    }
}
