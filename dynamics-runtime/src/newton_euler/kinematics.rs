//! Places of the frames, and the Jacobian.

use core::array;

use nalgebra::{Matrix4, SMatrix, SVector};

use super::NewtonEuler;
use super::angle::SinCos;
use super::joint::Joint;
use super::pose::Pose;
use crate::JointType;

impl<const N: usize> NewtonEuler<N> {
    /// The joints at their positions; one evaluation for all sines.
    #[inline(always)]
    pub(super) fn joints(&self, q: &SVector<f64, N>) -> [Joint; N] {
        let turned = SinCos::of_joints(q.data.0[0]);
        let mut joints = [Joint::new(SinCos::ZERO, 0.0, SinCos::ZERO, 0.0); N];
        for (i, link) in self.links.iter().enumerate() {
            joints[i] = link.joint(q[i], turned[i]);
        }
        joints
    }

    /// The joints' frames in the world.
    pub(super) fn poses_in_world(&self, q: &SVector<f64, N>) -> [Pose; N] {
        let mut pose = self.base;
        self.joints(q).map(|joint| {
            pose = pose.then(&joint.pose());
            pose
        })
    }

    /// The table's link frames in the world.
    fn table_frames(&self, q: &SVector<f64, N>) -> [Pose; N] {
        let poses = self.poses_in_world(q);
        array::from_fn(|i| poses[i].then(&self.links[i].table_frame))
    }

    /// Homogeneous transforms of all link frames of the table in the world.
    pub fn link_poses(&self, q: &SVector<f64, N>) -> [Matrix4<f64>; N] {
        self.table_frames(q).map(|pose| homogeneous(&pose))
    }

    /// Homogeneous transform of the tip in the world: of the tool, or else of the last link frame. For
    /// no joints, that of the base.
    pub fn forward_kinematics(&self, q: &SVector<f64, N>) -> Matrix4<f64> {
        let poses = self.poses_in_world(q);
        let last = poses.last().zip(self.links.last());
        let tip = last.map_or(self.base, |(pose, link)| pose.then(&link.tip));
        homogeneous(&tip)
    }

    /// Geometric Jacobian of the tip's origin p: rows vx vy vz wx wy wz in the world.
    ///
    /// Column i is `(z_i x (p - p_i), z_i)` for a revolute joint, `(z_i, 0)` for a prismatic one
    /// (Craig, section 5.8).
    pub fn jacobian(&self, q: &SVector<f64, N>) -> SMatrix<f64, 6, N> {
        let poses = self.poses_in_world(q);
        let tip = self
            .forward_kinematics(q)
            .fixed_view::<3, 1>(0, 3)
            .into_owned();
        let mut jacobian = SMatrix::<f64, 6, N>::zeros();
        for (i, pose) in poses.iter().enumerate() {
            let axis = pose.rotation.column(2).into_owned();
            let mut column = jacobian.column_mut(i);
            match self.links[i].joint_type {
                JointType::Revolute => {
                    let lever = tip - pose.position;
                    column.fixed_rows_mut::<3>(0).copy_from(&axis.cross(&lever));
                    column.fixed_rows_mut::<3>(3).copy_from(&axis);
                }
                JointType::Prismatic => column.fixed_rows_mut::<3>(0).copy_from(&axis),
            }
        }
        jacobian
    }
}

fn homogeneous(pose: &Pose) -> Matrix4<f64> {
    let mut matrix = pose.rotation.to_homogeneous();
    matrix
        .fixed_view_mut::<3, 1>(0, 3)
        .copy_from(&pose.position);
    matrix
}
