//! Poses and velocities of the links.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::pose::{Lift, Pose};
use super::twist::angular_velocity;
use super::{Definition, Matrix, Vector};
use crate::linear::{Matrix3, Vector3};

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
        let column = |j: usize| velocity(&self.tip(&self.poses(&self.along(j))));
        let columns: Vec<_> = (0..self.dof()).map(column).collect();
        let row = |k: usize| columns.iter().map(|column| column[k]).collect();
        (0..6).map(row).collect()
    }
}

/// vx vy vz wx wy wz of a frame in the world, from a pose with its rate.
pub(super) fn velocity<R: Lift>(pose: &Pose<Dual<R>>) -> [R; 6] {
    let axes = Matrix3(pose.rotation.0.map(|row| row.map(|x| x.value)));
    let [wx, wy, wz] = axes.apply(angular_velocity(&pose.rotation)).0;
    let [vx, vy, vz] = Vector3(pose.origin.0.map(|x| x.derivative)).0;
    [vx, vy, vz, wx, wy, wz]
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
