//! Where the arm stands, and what is fixed to its end.

use super::Value;

/// The place of a frame in another one, `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`, as in URDF.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// The frame's origin, m.
    pub xyz: [Value; 3],
    /// Roll, pitch and yaw, rad.
    pub rpy: [Value; 3],
}

/// A frame and a body that are fixed to the last link.
#[derive(Clone, Debug, PartialEq)]
pub struct Tool {
    /// The tool frame in the last link frame of the table.
    pub placement: Placement,
    /// Mass of the body, kg.
    pub mass: Value,
    /// Its centre of mass in the tool frame, m.
    pub com: [Value; 3],
    /// Its inertia tensor about the centre of mass, axes parallel to the tool frame: entries xx, yy,
    /// zz, xy, yz, xz of the tensor, kg m^2.
    pub inertia: [Value; 6],
}

impl Tool {
    /// Whether a body is there: not where its mass and its tensor are the number zero.
    pub fn has_body(&self) -> bool {
        !self.mass.is_zero() || self.inertia.iter().any(|entry| !entry.is_zero())
    }
}
