//! The place of one frame in another, to calculate with.

use nalgebra::{Matrix3, Vector3};

use crate::Placement;

/// Rotation and position of one frame in another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pose {
    pub(super) rotation: Matrix3<f64>,
    pub(super) position: Vector3<f64>,
}

impl Pose {
    /// A frame that is the other frame.
    pub(super) fn identity() -> Self {
        Pose {
            rotation: Matrix3::identity(),
            position: Vector3::zeros(),
        }
    }

    /// The frame that `next` describes in this one, in the frame that this one is described in.
    pub(super) fn then(&self, next: &Pose) -> Pose {
        Pose {
            rotation: self.rotation * next.rotation,
            position: self.rotation * next.position + self.position,
        }
    }

    pub(super) fn placement(&self) -> Placement {
        Placement::new(&self.rotation, &self.position)
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
