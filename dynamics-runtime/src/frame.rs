//! The base and the tool of a table, as they are written there.

/// A frame in another one: `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`, as in URDF.
///
/// Where an angle is the double nearest to a multiple of pi/2, it means exactly that multiple.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Frame {
    /// The frame's origin, m.
    pub xyz: [f64; 3],
    /// Roll, pitch and yaw, rad.
    pub rpy: [f64; 3],
}

impl Frame {
    /// A frame that is the other frame.
    pub const IDENTITY: Self = Frame {
        xyz: [0.0; 3],
        rpy: [0.0; 3],
    };
}

/// A base that moves: its body, described in frame 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FloatingBase {
    /// Mass of the body, kg.
    pub mass: f64,
    /// Its centre of mass in frame 0, m.
    pub com: [f64; 3],
    /// Entries xx, yy, zz, xy, yz, xz of its inertia tensor about the centre of mass, axes parallel to frame 0, kg m^2.
    pub inertia: [f64; 6],
}

/// The numbers of the base, before those of the joints.
pub const NAMES_OF_BASE: [&str; 6] = [
    "base vx", "base vy", "base vz", "base wx", "base wy", "base wz",
];

/// A frame that is fixed to the last link, the tip of the arm, and a body in it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Tool {
    /// The tool frame in the last link frame of the table.
    pub frame: Frame,
    /// Mass of the body, kg.
    pub mass: f64,
    /// Its centre of mass in the tool frame, m.
    pub com: [f64; 3],
    /// Entries xx, yy, zz, xy, yz, xz of its inertia tensor about the centre of mass, axes parallel to
    /// the tool frame, kg m^2.
    pub inertia: [f64; 6],
}

impl Tool {
    /// No tool: the tip is the last link frame.
    pub const NONE: Self = Tool {
        frame: Frame::IDENTITY,
        mass: 0.0,
        com: [0.0; 3],
        inertia: [0.0; 6],
    };
}
