//! Where the robot stands, and what is fixed to its tip.

use super::Value;

/// The place of a frame in another one, `T(xyz) Rz(yaw) Ry(pitch) Rx(roll)`, as in URDF.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement<C = Value> {
    /// The frame's origin, m.
    pub xyz: [C; 3],
    /// Roll, pitch and yaw, rad.
    pub rpy: [C; 3],
}

/// A frame and a body that are fixed to the link of the tip.
#[derive(Clone, Debug, PartialEq)]
pub struct Tool<C = Value> {
    /// The tool frame in that link's frame.
    pub placement: Placement<C>,
    /// Mass of the body, kg.
    pub mass: C,
    /// Its centre of mass in the tool frame, m.
    pub com: [C; 3],
    /// Its inertia tensor about the centre of mass, axes parallel to the tool frame: entries xx, yy,
    /// zz, xy, yz, xz of the tensor, kg m^2.
    pub inertia: [C; 6],
}

impl Tool {
    /// Whether a body is there: not where its mass and its tensor are the number zero.
    pub fn has_body(&self) -> bool {
        !self.mass.is_zero() || self.inertia.iter().any(|entry| !entry.is_zero())
    }
}
