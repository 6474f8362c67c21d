//! The place of one frame in another.

use nalgebra::{Matrix3, Vector3};

/// Rotation and position of one frame in another.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Placement {
    /// The rotation matrix by rows: its columns are the frame's axes.
    pub rotation: [[f64; 3]; 3],
    /// The frame's origin, m.
    pub position: [f64; 3],
}

impl Placement {
    /// A frame that is the other frame.
    pub const IDENTITY: Self = Placement {
        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        position: [0.0; 3],
    };

    pub(crate) fn new(rotation: &Matrix3<f64>, position: &Vector3<f64>) -> Self {
        let [x, y, z]: [[f64; 3]; 3] = rotation.transpose().into();
        Placement {
            rotation: [x, y, z],
            position: (*position).into(),
        }
    }

    pub(crate) fn matrix(&self) -> Matrix3<f64> {
        Matrix3::from(self.rotation).transpose()
    }

    pub(crate) fn origin(&self) -> Vector3<f64> {
        Vector3::from(self.position)
    }
}
