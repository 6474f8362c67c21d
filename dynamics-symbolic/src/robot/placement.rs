//! Where the robot stands, and what is fixed to its tip.

use super::{Body, Value};

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
    /// The body, in the tool frame.
    pub body: Body<C>,
}

impl Tool {
    /// Whether a body is there.
    pub fn has_body(&self) -> bool {
        !self.body.is_massless()
    }
}
