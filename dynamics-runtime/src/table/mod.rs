//! The Denavit-Hartenberg table as plain numbers: what the numeric algorithms read.

mod arm;
mod carrier;
mod followers;
mod frames;
mod list;
mod lock;
mod parameters;
#[cfg(feature = "std")]
mod runtime;

#[doc(hidden)]
pub use arm::Moving;
pub(crate) use arm::tip_row;
pub use arm::{Arm, AsArm};
pub use carrier::Carrier;
pub use followers::{Follower, JointMotion};
pub use frames::FixedFrame;
pub use list::List;
pub use parameters::StandardParameters;
#[cfg(feature = "std")]
pub use runtime::RuntimeTable;

#[doc(hidden)]
pub use crate::frame::NAMES_OF_BASE;
pub use crate::frame::{FloatingBase, Frame, Tool};
pub use crate::placement::Placement;

/// How a row of the table places its link frame in that of the link that carries it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Convention {
    /// `Rz(theta) Tz(d) Tx(a) Rx(alpha)`: the frame at the far end of the link.
    Standard,
    /// `Rx(alpha) Tx(a) Rz(theta) Tz(d)` (Craig): the frame on the joint's own axis; a row holds
    /// alpha and a of the link that carries it.
    Modified,
}

/// The kind of a joint: its variable is added to `theta` (revolute) or to `d` (prismatic).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum JointType {
    /// Rotation about z.
    Revolute,
    /// Translation along z.
    Prismatic,
}

/// Static friction S that falls to Coulomb's C as a joint begins to move:
/// `sign(qd) (C + (S - C) exp(-(qd/v)^2))`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stribeck {
    /// S, the same in both directions, N m or N.
    pub friction: f64,
    /// v, the velocity over which it falls, rad/s or m/s.
    pub velocity: f64,
}

/// A linear spring at a joint: it takes the torque or force `stiffness (q - rest)` to hold it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spring {
    /// Torque or force for each unit of displacement, N m/rad or N/m.
    pub stiffness: f64,
    /// The position of the joint at which it is slack, rad or m.
    pub rest: f64,
}

impl Spring {
    /// A joint without a spring.
    pub const NONE: Spring = Spring {
        stiffness: 0.0,
        rest: 0.0,
    };

    /// The torque or force that holds it at a position.
    #[doc(hidden)]
    pub fn force(&self, q: f64) -> f64 {
        self.stiffness * (q - self.rest)
    }

    /// The energy in it at a position, J.
    #[doc(hidden)]
    pub fn energy(&self, q: f64) -> f64 {
        0.5 * self.force(q) * (q - self.rest)
    }
}

/// One row of the table: a joint and the link that it moves. SI units, radians.
///
/// Where `alpha` or `theta` is the double nearest to a multiple of pi/2, it means exactly that multiple.
/// A generated table has whole turns taken off the angles that lose digits by them.
///
/// A row is written as `Row { mass: 2.0, ..Row::new(JointType::Revolute) }`, because later versions may have more cells.
/// Rows are a tree if some of them say on which link they stand:
///
/// ```
/// use robot_dynamics::table::{Carrier, Frame, JointType, Placement, Row};
///
/// // Two fingers on the link of row 0, 4 cm apart.
/// let finger = |y| Row {
///     on: Carrier::Row(0),
///     mount: Placement::of_frames(&[Frame { xyz: [0.0, y, 0.1], rpy: [0.0; 3] }]),
///     mass: 0.05,
///     ..Row::new(JointType::Prismatic)
/// };
/// let rows = [Row::new(JointType::Revolute), finger(0.02), finger(-0.02)];
/// # assert_eq!(rows[2].on, Carrier::Row(0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Row {
    /// Revolute or prismatic.
    pub joint_type: JointType,
    /// The link that carries the joint: by default, that of the row above.
    #[cfg_attr(feature = "serde", serde(default))]
    pub on: Carrier,
    /// Link length, m.
    pub a: f64,
    /// Link twist, rad.
    pub alpha: f64,
    /// Link offset (its constant part where the joint is prismatic), m.
    pub d: f64,
    /// Joint angle (its constant part where the joint is revolute), rad.
    pub theta: f64,
    /// Mass of the link, kg.
    pub mass: f64,
    /// Centre of mass in the link frame, m.
    pub com: [f64; 3],
    /// Entries xx, yy, zz, xy, yz, xz of the inertia tensor about the centre of mass, axes
    /// parallel to the link frame, kg m^2. Off-diagonal entries are those of the tensor: minus the
    /// product integrals.
    pub inertia: [f64; 6],
    /// Rotor inertia of the motor, kg m^2.
    pub motor_inertia: f64,
    /// Motor speed over joint speed.
    pub gear_ratio: f64,
    /// Viscous friction at the joint, N m s or N s/m.
    pub viscous: f64,
    /// Coulomb friction at the joint, N m or N: of positive velocities, and of negative ones.
    pub coulomb: [f64; 2],
    /// How static friction falls to Coulomb's, where it is greater.
    pub stribeck: Option<Stribeck>,
    /// The spring at the joint; [`Spring::NONE`] where there is none.
    pub spring: Spring,
    /// The range of the joint's position, lower end first, rad or m, where the table has one.
    pub limits: Option<[f64; 2]>,
    /// The greatest torque or force in either direction, N m or N, where the table has one.
    #[cfg_attr(feature = "serde", serde(default))]
    pub torque_limit: Option<f64>,
    /// The greatest velocity in either direction, rad/s or m/s, where the table has one.
    #[cfg_attr(feature = "serde", serde(default))]
    pub velocity_limit: Option<f64>,
    /// Where this row begins: in the frame that the row of the carrying link describes, of a modified table behind its
    /// `Rz(theta) Tz(d)`, or in the base frame. It is [`Placement::IDENTITY`], unless the table says a place (`at`), joints
    /// between the two rows are locked ([`Table::lock`]), or a URDF file places the joint: the cells a, alpha, d and theta
    /// are then zero.
    pub mount: Placement,
    /// The link frame, in the frame after `Rz(theta) Tz(d)` of a modified row. It is [`Placement::IDENTITY`], unless the
    /// axis of a joint in a URDF file is not the z axis of its link. `com` and `inertia` refer to the link frame.
    pub link_frame: Placement,
    /// The tip, in the link frame of this row, if it is on this link. In a table without branches in which no row has it,
    /// it is the link frame of the last row; with branches there is none then. A row has it where joints behind its own are
    /// locked, or where a URDF file says where the tip is.
    #[cfg_attr(feature = "serde", serde(default))]
    pub tip: Option<Placement>,
    /// New cells break no literal that ends with `..Row::new(joint_type)`.
    #[doc(hidden)]
    #[cfg_attr(feature = "serde", serde(skip))]
    pub non_exhaustive: (),
}

impl Row {
    /// A row of zeros: a massless link at the place of the one before it.
    pub const fn new(joint_type: JointType) -> Self {
        Row {
            joint_type,
            on: Carrier::Above,
            a: 0.0,
            alpha: 0.0,
            d: 0.0,
            theta: 0.0,
            mass: 0.0,
            com: [0.0; 3],
            inertia: [0.0; 6],
            motor_inertia: 0.0,
            gear_ratio: 0.0,
            viscous: 0.0,
            coulomb: [0.0; 2],
            stribeck: None,
            spring: Spring::NONE,
            limits: None,
            torque_limit: None,
            velocity_limit: None,
            mount: Placement::IDENTITY,
            link_frame: Placement::IDENTITY,
            tip: None,
            non_exhaustive: (),
        }
    }

    /// Inertia of the motor at the joint, `gear_ratio^2 * motor_inertia`, in kg m^2 (revolute) or
    /// kg (prismatic).
    pub const fn reflected_inertia(&self) -> f64 {
        self.gear_ratio * self.gear_ratio * self.motor_inertia
    }
}

/// The table of a robot with `N` joints, as numbers. Nothing is validated.
///
/// A table is written as `Table { tool, ..Table::new(convention, gravity, rows) }`, because later versions may have more
/// entries.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Table<const N: usize> {
    /// Convention of the rows.
    pub convention: Convention,
    /// Acceleration of gravity in the axes of the world, m/s^2: (0, 0, -9.81) where z points up.
    pub gravity: [f64; 3],
    /// The base frame, frame 0, in the world. It is [`Frame::IDENTITY`] if the base moves.
    pub base: Frame,
    /// The body of a base that moves; `None` of one that stands.
    #[cfg_attr(feature = "serde", serde(default))]
    pub floating: Option<FloatingBase>,
    /// The rows of the joints, from the base outwards: each one behind the row that carries it.
    #[cfg_attr(feature = "serde", serde(with = "crate::sequences::array"))]
    pub rows: [Row; N],
    /// The rows of the joints that follow these.
    #[cfg_attr(feature = "serde", serde(default))]
    pub followers: List<Follower, 8>,
    /// Frames on the links, and the bodies in them.
    #[cfg_attr(feature = "serde", serde(default))]
    pub frames: List<FixedFrame, 16>,
    /// The tool at the tip: on the link of the only row that carries no other, whether its joint is locked or not. A robot
    /// in which several rows carry no other has no tip, and no tool.
    pub tool: Tool,
    /// The tip in frame 0 of a robot on a base that moves whose rows are all locked; none is written where it has other rows,
    /// or none at all.
    #[cfg_attr(feature = "serde", serde(default))]
    pub tip: Option<Placement>,
    /// New entries break no literal that ends with `..Table::new(convention, gravity, rows)`.
    #[doc(hidden)]
    #[cfg_attr(feature = "serde", serde(skip))]
    pub non_exhaustive: (),
}

impl<const N: usize> Table<N> {
    /// An arm whose base frame is the world's, without a tool.
    pub const fn new(convention: Convention, gravity: [f64; 3], rows: [Row; N]) -> Self {
        Table {
            convention,
            gravity,
            base: Frame::IDENTITY,
            floating: None,
            rows,
            followers: List::NONE,
            frames: List::NONE,
            tool: Tool::NONE,
            tip: None,
            non_exhaustive: (),
        }
    }

    /// The ranges of the joints' positions, lower ends first, rad or m, where the table has them.
    pub fn joint_limits(&self) -> [Option<[f64; 2]>; N] {
        self.rows.each_ref().map(|row| row.limits)
    }

    /// The greatest torques or forces of the joints in either direction, N m or N, where the table has them.
    pub fn torque_limits(&self) -> [Option<f64>; N] {
        self.rows.each_ref().map(|row| row.torque_limit)
    }

    /// The greatest velocities of the joints in either direction, rad/s or m/s, where the table has them.
    pub fn velocity_limits(&self) -> [Option<f64>; N] {
        self.rows.each_ref().map(|row| row.velocity_limit)
    }

    /// Mass of all links, of the tool and of the bodies of frames on links, and of a base that moves, kg.
    pub fn total_mass(&self) -> f64 {
        self.arm().total_mass()
    }
}
