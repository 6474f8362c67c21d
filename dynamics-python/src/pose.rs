//! Poses as homogeneous matrices by rows.

use dynamics_runtime::Pose;
use dynamics_runtime::nalgebra::{Matrix3, Matrix4, Vector3};

/// The entries of a homogeneous matrix by rows.
pub(crate) fn rows_of(matrix: &Matrix4<f64>) -> [f64; 16] {
    core::array::from_fn(|k| matrix[(k / 4, k % 4)])
}

/// The pose of a homogeneous matrix by rows.
pub(crate) fn pose_of(rows: &[f64]) -> Pose<f64> {
    Pose {
        rotation: Matrix3::from_fn(|i, j| rows[4 * i + j]),
        position: Vector3::from_fn(|i, _| rows[4 * i + 3]),
    }
}

/// The homogeneous matrix of a pose by rows.
pub(crate) fn by_rows(pose: &Pose<f64>) -> [f64; 16] {
    rows_of(&pose.homogeneous())
}
