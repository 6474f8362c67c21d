//! What the symbols in a robot's equations stand for.

use super::Value;
use crate::function::Argument;

/// What a symbol stands for. Indices of joints count from 0, joints that are locked left out.
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
    /// Sine of a joint angle.
    Sine(usize),
    /// Cosine of a joint angle.
    Cosine(usize),
    /// A joint's position, q.
    Position(usize),
    /// A joint's velocity, qd.
    Velocity(usize),
    /// A joint's acceleration, qdd.
    Acceleration(usize),
    /// A joint's force or torque, tau.
    Force(usize),
    /// The sign of a joint's velocity.
    VelocitySign(usize),
    /// exp(-(qd/v)^2) of a joint's velocity and its [Stribeck velocity](super::Stribeck): what is left
    /// of the static friction beyond Coulomb's.
    Stribeck(usize),
    /// An entry of another argument than q, qd, qdd and tau.
    Entry(Argument, usize),
}
