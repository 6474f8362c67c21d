//! The place of one frame in another, to calculate with.

use nalgebra::{Matrix3, Vector3};

use super::angle::SinCos;
use crate::{Frame, Placement};

/// Rotation and position of one frame in another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pose {
    pub(super) rotation: Matrix3<f64>,
    pub(super) position: Vector3<f64>,
}

impl Pose {
    /// A frame that is the other frame.
    pub(super) const IDENTITY: Self = Pose {
        rotation: Matrix3::new(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        position: Vector3::new(0.0, 0.0, 0.0),
    };

    /// The frame that `next` describes in this one, in the frame that this one is described in.
    pub(super) fn then(&self, next: &Pose) -> Pose {
        Pose {
            rotation: self.rotation * next.rotation,
            position: self.rotation * next.position + self.position,
        }
    }

    /// The outer frame in this one.
    pub(super) fn inverse(&self) -> Pose {
        let rotation = self.rotation.transpose();
        Pose {
            rotation,
            position: -(rotation * self.position),
        }
    }

    pub(super) fn placement(&self) -> Placement {
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
