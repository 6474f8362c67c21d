//! The description of a robot: what a Denavit-Hartenberg table says, as data.
//!
//! No syntax in here: the macro's parser builds these types, and so can any
//! other program.

mod angle;
mod base;
mod body;
mod carrier;
mod coupling;
mod frame;
mod friction;
mod grouping;
mod interpretation;
mod map;
mod mount;
mod parameter;
mod placement;
mod spring;
mod symbol;
mod value;

pub use angle::Angle;
pub use base::Base;
pub use body::Body;
pub use carrier::Carrier;
pub use coupling::Coupling;
pub use frame::Frame;
pub use friction::Stribeck;
pub use grouping::{Coefficient, Grouping, LinkGrouping, Sense, Tie};
pub use interpretation::{Interpretation, PoseOfBase};
pub use map::Quantity;
pub use mount::Mount;
pub use parameter::Parameter;
pub use placement::{Placement, Tool};
pub use spring::Spring;
pub use symbol::Symbol;
pub use value::Value;

use crate::function::{Argument, Freedoms, Request};

/// How a row of the table places link frame i in link frame i-1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Convention {
    /// `Rz(theta) Tz(d) Tx(a) Rx(alpha)`.
    Standard,
    /// `Rx(alpha) Tx(a) Rz(theta) Tz(d)` (Craig), where row i holds alpha_{i-1} and a_{i-1}.
    Modified,
}

/// The kind of a joint: its variable is added to `theta` (revolute) or `d` (prismatic).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointType {
    /// Rotation about z.
    Revolute,
    /// Translation along z.
    Prismatic,
}

/// One row of the table: a joint and the link that it moves. SI units, radians. Its cells are values of the table, or what
/// [`map`](Row::map) makes of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Row<C = Value> {
    /// The joint's name.
    pub name: String,
    /// Revolute or prismatic.
    pub joint_type: JointType,
    /// The link that carries the joint.
    pub on: Carrier,
    /// Where the row begins in the frame of that link, or in frame 0: each place in the one before it. The row's four
    /// parameters count from there, in both conventions.
    pub at: Vec<Placement<C>>,
    /// Link length, m.
    pub a: C,
    /// Link twist, rad.
    pub alpha: C,
    /// Link offset, m.
    pub d: C,
    /// Joint angle (its constant part where the joint is revolute), rad.
    pub theta: C,
    /// Mass of the link, kg.
    pub mass: C,
    /// Centre of mass in the link frame, m.
    pub com: [C; 3],
    /// Inertia tensor about the centre of mass, axes parallel to the link
    /// frame: entries xx, yy, zz, xy, yz, xz of the tensor, kg m^2.
    pub inertia: [C; 6],
    /// Rotor inertia of the motor, kg m^2.
    pub motor_inertia: C,
    /// Gear ratio, motor speed over joint speed; the number zero where the row has no motor.
    pub gear_ratio: C,
    /// Viscous friction at the joint, N m s (or N s/m).
    pub viscous: C,
    /// Coulomb friction at the joint, N m (or N): of positive velocities, and of negative ones.
    pub coulomb: [C; 2],
    /// How static friction falls to Coulomb's, where it is greater.
    pub stribeck: Option<Stribeck<C>>,
    /// The spring at the joint, where there is one.
    pub spring: Option<Spring<C>>,
    /// The range of the joint's position, lower end first, rad or m, where it is known.
    pub limits: Option<[C; 2]>,
    /// The greatest torque or force at the joint in either direction, N m or N, where it is known.
    pub torque_limit: Option<C>,
    /// Its greatest speed in either direction, rad/s or m/s, where it is known.
    pub velocity_limit: Option<C>,
    /// The position at which the joint is locked, rad or m; `None` where it moves. A locked joint is not a degree of
    /// freedom of the arm, its link is a part of the link before it, and its motor, friction and spring do
    /// nothing.
    pub locked: Option<C>,
    /// The joint's axis, if a file says it in place of the cells a, alpha, d and theta, which are then zero. Only rows
    /// of a modified table have it, all of them or none.
    pub mount: Option<Mount<C>>,
    /// The joint that this one follows, if it does. A follower is not a degree of freedom of the arm; its link,
    /// motor, friction and spring act on the joint that leads.
    pub follows: Option<Coupling<C>>,
}

impl Row {
    /// Whether the joint is one of the arm's degrees of freedom: it moves, and follows no other.
    pub fn is_free(&self) -> bool {
        self.locked.is_none() && self.follows.is_none()
    }

    /// The body of the link.
    pub fn body(&self) -> Body {
        Body {
            mass: self.mass.clone(),
            com: self.com.clone(),
            inertia: self.inertia.clone(),
        }
    }

    /// Whether the row has a motor: its reflected inertia is then a parameter of the arm, even where
    /// the table says that it is zero.
    pub fn has_motor(&self) -> bool {
        !self.gear_ratio.is_zero()
    }

    /// Whether the table says of any friction at the joint.
    pub fn has_friction(&self) -> bool {
        let of_stribeck = self.stribeck.iter().map(|stribeck| &stribeck.friction);
        let forces = [&self.viscous].into_iter().chain(&self.coulomb);
        forces.chain(of_stribeck).any(|force| !force.is_zero())
    }
}

/// A robot: its rows are a tree, and a serial arm if each one stands on the link of the row above.
#[derive(Clone, Debug)]
pub struct Robot {
    /// Name of the arm.
    pub name: String,
    /// Names of the symbolic parameters as Rust identifiers (`r#type` is one); [`Value::field`] i
    /// stands for `fields[i]`.
    pub fields: Vec<String>,
    /// Convention of the rows.
    pub convention: Convention,
    /// Acceleration of gravity in the axes of the world, m/s^2.
    pub gravity: [Value; 3],
    /// Where frame 0 stands in the world, or the body of a base that moves. `None` where frame 0 is the world's.
    /// Poses, Jacobians and the potential energy are those in the world.
    pub base: Option<Base>,
    /// The rows, from the base outwards: a row stands behind the one that carries it.
    pub rows: Vec<Row>,
    /// Named places, and the bodies that are fixed there.
    pub frames: Vec<Frame>,
    /// The tool on the link of the [tip](Robot::tip_row). The tip is the tool's frame, or else that link's frame.
    pub tool: Option<Tool>,
    /// The parameters that the functions leave out: see [`crate::neglect`].
    pub neglected: Option<Neglected>,
    /// How bounds of rounding are found.
    pub bounds: Bounds,
}

/// How the bounds of rounding of functions are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Bounds {
    /// In one walk over all positions within the limits.
    #[default]
    Whole,
    /// Positions are cut into parts, in each of which the walk loses less.
    Tight,
}

/// The base inertial parameters that are left out of the Lagrangian.
#[derive(Clone, Debug)]
pub struct Neglected {
    /// The base parameters of the complete arm.
    pub grouping: Grouping,
    /// Row and parameter of those that are left out.
    pub columns: Vec<(usize, Parameter)>,
    /// The share below which their effects are, at most.
    pub share: f64,
    /// Whether the mass matrix that is left was shown to be positive definite at all positions.
    pub is_definite: bool,
}

impl Robot {
    /// The number of degrees of freedom: entries of a velocity.
    pub fn dof(&self) -> usize {
        self.freedoms().all()
    }

    /// The degrees of freedom: of a base that moves six, and the joints that move by themselves.
    pub fn freedoms(&self) -> Freedoms {
        Freedoms {
            base: self.floating().map_or(0, |_| Base::FREEDOMS),
            joints: self.joints().count(),
        }
    }

    /// The entry of an argument that belongs to a degree of freedom: positions are those of the joints alone.
    pub fn entry_of(&self, argument: Argument, freedom: usize) -> usize {
        match argument {
            Argument::Position => freedom - self.freedoms().base,
            _ => freedom,
        }
    }

    /// The request as this robot answers it: functions of one whose base moves take where that stands.
    pub fn request(&self, request: Request) -> Request {
        if self.freedoms().has_base() {
            request.on_moving_base()
        } else {
            request
        }
    }

    /// Where frame 0 stands in the world, if it stands there and is not the world's.
    pub fn placement(&self) -> Option<&Placement> {
        match self.base.as_ref()? {
            Base::Standing(placement) => Some(placement),
            Base::Floating(_) => None,
        }
    }

    /// The body of a base that moves, in frame 0.
    pub fn floating(&self) -> Option<&Body> {
        match self.base.as_ref()? {
            Base::Standing(_) => None,
            Base::Floating(body) => Some(body),
        }
    }

    /// The rows of the joints that move by themselves, from the base outwards.
    pub fn joints(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|row| row.is_free())
    }

    /// The rows of the joints that follow others, from the base outwards, and how they do.
    pub fn followers(&self) -> impl Iterator<Item = (&Row, &Coupling)> {
        self.rows
            .iter()
            .filter_map(|row| Some((row, row.follows.as_ref()?)))
    }

    /// Whether a joint follows another one.
    pub fn is_coupled(&self) -> bool {
        self.followers().next().is_some()
    }

    /// The number of a row's joint among the degrees of freedom, those of the base first.
    pub fn joint_of(&self, row: usize) -> usize {
        let before = self.rows[..row].iter();
        self.freedoms().base + before.filter(|row| row.is_free()).count()
    }

    /// The joint and the factor behind the index of a [`Symbol`]: of a follower, where the index is none
    /// of a joint that moves by itself.
    pub fn followed(&self, index: usize) -> Option<(usize, &Value)> {
        let (_, coupling) = self.followers().nth(index.checked_sub(self.dof())?)?;
        Some((self.joint_of(coupling.leader), &coupling.factor))
    }

    /// The row of the follower that a symbol is one of its own of.
    pub fn follower_of(&self, symbol: &Symbol) -> Option<&Row> {
        match symbol {
            Symbol::Sine(i) | Symbol::Cosine(i) | Symbol::VelocitySign(i) | Symbol::Stribeck(i)
                if *i >= self.dof() =>
            {
                self.row_of(*i)
            }
            _ => None,
        }
    }

    /// The row behind the index of a [`Symbol`]; `None` of a degree of freedom of the base.
    pub fn row_of(&self, index: usize) -> Option<&Row> {
        let followers = self.followers().map(|(row, _)| row);
        let joint = index.checked_sub(self.freedoms().base)?;
        self.joints().chain(followers).nth(joint)
    }

    /// The arm in which nothing is coupled: each follower is a joint of its own.
    pub fn uncoupled(&self) -> Robot {
        let mut robot = self.clone();
        for row in &mut robot.rows {
            row.follows = None;
        }
        robot
    }
}
