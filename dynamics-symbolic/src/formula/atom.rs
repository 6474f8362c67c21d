//! The variables of formulas.

use crate::function::Argument;

/// A variable of a formula, in the order in which the factors of a product are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Atom {
    /// The circle's ratio.
    Pi,
    /// A symbolic parameter.
    Field(usize),
    /// Cosine of the constant or parametric angle of that index in [`Atoms::angles`](super::multiply_out::Atoms).
    AngleCosine(usize),
    /// Its sine.
    AngleSine(usize),
    /// The sum of that index in [`Atoms::divisors`](super::multiply_out::Atoms), by which something is divided.
    Divisor(usize),
    /// q of a joint.
    Position(usize),
    /// Cosine of a sum of joint angles.
    Cosine(Run),
    /// Sine of a sum of joint angles.
    Sine(Run),
    /// An entry of another argument than q, qd, qdd and tau.
    Entry(Argument, usize),
    /// qd of a joint.
    Velocity(usize),
    /// The sign of a joint's velocity.
    VelocitySign(usize),
    /// exp(-(qd/v)^2) of a joint.
    Stribeck(usize),
    /// qdd of a joint.
    Acceleration(usize),
    /// tau of a joint.
    Force(usize),
}

/// The angles of consecutive revolute joints with parallel axes, added up: those with the indices `first` to `last` in
/// a group. The angles of axes that point the other way than the first one are subtracted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Run {
    /// The group: see [`Groups`](super::groups::Groups).
    pub(super) group: usize,
    /// The first angle.
    pub(super) first: usize,
    /// The last angle.
    pub(super) last: usize,
}

impl Atom {
    /// Whether this is a constant of the arm: a number, a parameter or a function of these.
    pub(super) fn is_parameter(self) -> bool {
        self < Atom::Position(0)
    }

    /// The cosine that belongs to a sine.
    pub(super) fn cosine(self) -> Option<Atom> {
        match self {
            Atom::Sine(run) => Some(Atom::Cosine(run)),
            Atom::AngleSine(index) => Some(Atom::AngleCosine(index)),
            _ => None,
        }
    }

    /// Whether this belongs to the motion: velocities, accelerations, forces.
    pub(super) fn is_motion(self) -> bool {
        self >= Atom::Entry(Argument::Position, 0)
    }
}
