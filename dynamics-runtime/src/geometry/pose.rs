//! The place of one frame in another, to calculate with.

use nalgebra::{Matrix3, Vector3};

use super::angle::SinCos;
use crate::{Frame, Placement};

/// Rotation and position of one frame in another.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    /// The axes, as columns.
    pub rotation: Matrix3<f64>,
    /// The origin, m.
    pub position: Vector3<f64>,
}

impl Pose {
    /// A frame that is the other frame.
    pub const IDENTITY: Self = Pose {
        rotation: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        position: Vector3::new(0.0, 0.0, 0.0),
    };

    /// The frame that `next` describes in this one, in the frame that this one is described in.
    pub fn then(&self, next: &Pose) -> Pose {
        Pose {
            rotation: self.rotation * next.rotation,
            position: self.rotation * next.position + self.position,
        }
    }

    /// The outer frame in this one.
    pub fn inverse(&self) -> Pose {
        let rotation = self.rotation.transpose();
        Pose {
            rotation,
            position: -(rotation * self.position),
        }
    }

    /// The same as a table has it.
    pub fn placement(&self) -> Placement {
        Placement::new(&self.rotation, &self.position)
    }
}

/// The frame as it is read: `Rz(yaw) Ry(pitch) Rx(roll)` at the origin.
impl From<&Frame> for Pose {
    fn from(frame: &Frame) -> Self {
        let [roll, pitch, yaw] = frame.rpy.map(SinCos::of_constant);
        let (sr, cr) = (roll.sin, roll.cos);
        let (sp, cp) = (pitch.sin, pitch.cos);
        let (sy, cy) = (yaw.sin, yaw.cos);
        #[rustfmt::skip]
        let rotation = Matrix3::new(
            cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,
            sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,
            -sp,     cp * sr,                cp * cr,
        );
        Pose {
            rotation,
            position: Vector3::from(frame.xyz),
        }
    }
}

impl From<&Placement> for Pose {
    fn from(placement: &Placement) -> Self {
        Pose {
            rotation: placement.matrix(),
            position: placement.origin(),
        }
    }
}

/// A base, as a frame to calculate with.
impl From<&crate::Pose<f64>> for Pose {
    fn from(base: &crate::Pose<f64>) -> Self {
        Pose {
            rotation: base.rotation,
            position: base.position,
        }
    }
}
