//! Poses and velocities of the links.

use super::super::assignment::Number;
use super::pose::Pose;
use super::twist::angular_velocity;
use super::{Definition, Matrix, Vector};
use crate::linear::Matrix3;

impl Definition {
    /// The pose of the tip in the world.
    pub(super) fn forward_kinematics(&self) -> Vector {
        homogeneous(&self.tip(&self.poses(&self.q)))
    }

    /// The poses in the world of the frames of all links whose joints move.
    pub(super) fn link_poses(&self) -> Vector {
        let poses = self.poses(&self.q);
        let of_joint = |(i, _): (usize, &super::Row)| homogeneous(&poses[i]);
        self.joints().flat_map(of_joint).collect()
    }

    /// By rows: vx vy vz wx wy wz of the tip's origin for unit velocity of each joint.
    pub(super) fn jacobian(&self) -> Matrix {
        let n = self.dof();
        let mut rows = vec![vec![Number::ZERO; n]; 6];
        for j in 0..n {
            let tip = self.tip(&self.poses(&self.along(j)));
            let rotation = Matrix3(tip.rotation.0.map(|row| row.map(|x| x.value)));
            let w = rotation.apply(angular_velocity(&tip.rotation));
            for k in 0..3 {
                rows[k][j] = tip.origin[k].derivative;
                rows[3 + k][j] = w[k];
            }
        }
        rows
    }
}

/// The 4 x 4 matrix of a pose, by rows.
fn homogeneous(pose: &Pose<Number>) -> Vector {
    let mut entries = Vec::with_capacity(16);
    for (row, &x) in pose.rotation.0.iter().zip(&pose.origin.0) {
        entries.extend_from_slice(row);
        entries.push(x);
    }
    entries.extend([Number::ZERO, Number::ZERO, Number::ZERO, Number::ONE]);
    entries
}
