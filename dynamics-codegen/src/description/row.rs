//! The rows of joints, and the positions of those that do not move by themselves.

use dynamics_symbolic::robot::{self, JointType, Mount};

use super::body::{Body, Link, Placement};
use super::value::{Expr, ExprKind, Given, Name, Operator, Part};

/// `elbow = 0.3`, or `finger_2 = -finger_1 + 0.02` of a joint that follows another one.
#[derive(Debug)]
pub struct Positioned {
    /// The joint.
    pub name: Name,
    /// Where it is, rad or m, for a follower a linear function of the name of one other joint; none if that could not be
    /// read.
    pub position: Option<Expr>,
}

impl Positioned {
    /// `follower = factor * leader + offset`
    pub fn following(name: Name, factor: Expr, leader: &Name, offset: Expr) -> Positioned {
        let leader = Expr {
            kind: ExprKind::Name(leader.plain().to_owned()),
            place: leader.into(),
        };
        let binary = |operator, a: Expr, b: Expr| Expr {
            place: a.place.to(b.place),
            kind: ExprKind::Binary(operator, Box::new(a), Box::new(b)),
        };
        let moved = binary(Operator::Mul, factor, leader);
        Positioned {
            name,
            position: Some(binary(Operator::Add, moved, offset)),
        }
    }
}

/// `[name: revolute { cells }, ...]`
#[derive(Debug)]
pub struct Joints {
    /// The rows that could be recognised as rows.
    pub rows: Vec<Row>,
    /// Whether these are all rows.
    pub complete: bool,
}

/// `name: revolute { cells }`
#[derive(Debug, Default)]
pub struct Row {
    /// The joint's name.
    pub name: Option<Name>,
    /// Revolute or prismatic.
    pub joint_type: Option<JointType>,
    /// The link that carries the joint; left out, that of the row above.
    pub on: Given<Link>,
    /// Where the row begins on that link, `at: { xyz, rpy }`.
    pub at: Given<Placement>,
    /// Rotation about the z axis of the link that carries the joint, before the row of a modified table, rad.
    pub gamma: Given<Expr>,
    /// Displacement along that axis, m.
    pub b: Given<Expr>,
    /// Length of the common normal, m.
    pub a: Given<Expr>,
    /// Twist, rad.
    pub alpha: Given<Expr>,
    /// Offset along the axis, m.
    pub d: Given<Expr>,
    /// Angle about the axis, rad.
    pub theta: Given<Expr>,
    /// The body of the link.
    pub body: Body,
    /// The motor: inertia of its rotor, kg m^2, and its speed over that of the joint.
    pub motor: Given<Part<2>>,
    /// Friction of the joint.
    pub friction: Given<Friction>,
    /// The spring at the joint: its stiffness, and the position at which it is slack.
    pub spring: Given<Part<2>>,
    /// The range of the joint.
    pub limits: Given<Limits>,
    /// The greatest torque or force in either direction.
    pub torque_limit: Given<Expr>,
    /// The greatest speed in either direction.
    pub velocity_limit: Given<Expr>,
    /// Whether the range is that of a tree of links, in which many files have it wrong.
    pub limits_of_file: bool,
    /// Where a file begins the row on the link that carries it, each place in the one before it.
    pub places: Vec<robot::Placement>,
    /// The joint's axis, in a file that has no cells a, alpha, d and theta.
    pub mount: Option<Mount>,
}

impl Row {
    /// The joint's name; empty if it could not be read.
    pub(crate) fn word(&self) -> &str {
        self.name.as_ref().map_or("", Name::plain)
    }
}

/// `friction: { viscous, coulomb, stribeck }`
#[derive(Debug, Default)]
pub struct Friction {
    /// Force or torque for each unit of speed.
    pub viscous: Given<Expr>,
    /// Force or torque against the motion, whatever its speed.
    pub coulomb: Given<Coulomb>,
    /// Static friction, and the velocity over which it falls to Coulomb's.
    pub stribeck: Given<Part<2>>,
}

/// A value, or `{ positive, negative }`.
#[derive(Debug)]
pub enum Coulomb {
    /// The same in both directions.
    Both(Given<Expr>),
    /// At positive velocities and at negative ones.
    ByDirection(Part<2>),
}

/// `limits: [lower, upper]`
pub type Limits = [Option<Expr>; 2];
