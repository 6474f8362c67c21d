//! What the symbols in a robot's equations stand for.

use super::Value;
use crate::function::Argument;

/// What a symbol stands for. Indices of joints count from 0, joints that are locked left out. Joints that
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
