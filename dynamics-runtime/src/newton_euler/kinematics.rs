//! Places of the frames, and the Jacobian.

use core::array;
use core::ops::AddAssign;

use nalgebra::{Matrix4, SMatrix, SVector, Vector3, Vector6};

use super::NewtonEuler;
use super::angle::SinCos;
use super::joint::Joint;
use super::pose::Pose;
use crate::JointType;

impl<const N: usize> NewtonEuler<N> {
    /// The joints at their positions; one evaluation for all sines.
    #[inline(always)]
    pub(super) fn joints(&self, q: &SVector<f64, N>) -> [Joint; N] {
        let turned = self.sines(q);
        let mut joints = [Joint::new(SinCos::ZERO, 0.0, SinCos::ZERO, 0.0); N];
        for (i, link) in self.links().iter().enumerate() {
            joints[i] = link.joint(q[i], turned[i]);
        }
        joints
    }

    /// Of every row in use; of all at once where that is all.
    #[inline(always)]
    fn sines(&self, q: &SVector<f64, N>) -> [SinCos; N] {
        let [angles] = q.data.0;
        if self.rows() == N {
            return SinCos::of_joints(angles);
        }
        let mut turned = [SinCos::ZERO; N];
        for (turned, angle) in turned.iter_mut().zip(angles).take(self.rows()) {
            [*turned] = SinCos::of_joints([angle]);
        }
        turned
    }

    /// The joints' frames in the world.
    pub(super) fn poses_in_world(&self, q: &SVector<f64, N>) -> [Pose; N] {
        let (mut pose, joints) = (self.base, self.joints(q));
        let mut poses = [pose; N];
        for (i, joint) in joints.iter().take(self.rows()).enumerate() {
            pose = pose.then(&joint.pose());
            poses[i] = pose;
        }
        poses
    }

    /// The table's link frames in the world.
    fn table_frames(&self, q: &SVector<f64, N>) -> [Pose; N] {
        let poses = self.poses_in_world(q);
        array::from_fn(|i| poses[i].then(&self.links[i].table_frame))
    }

    /// Homogeneous transforms of all link frames of the table in the world.
    pub fn link_poses(&self, q: &SVector<f64, N>) -> [Matrix4<f64>; N] {
        if let Some(coupled) = &self.coupled {
            return coupled.link_poses(q);
        }
        self.table_frames(q).map(|pose| homogeneous(&pose))
    }

    /// Homogeneous transform of the tip in the world: of the tool, or else of the last link frame. For
    /// no joints, that of the base.
    pub fn forward_kinematics(&self, q: &SVector<f64, N>) -> Matrix4<f64> {
        if let Some(coupled) = &self.coupled {
            return coupled.forward_kinematics(q);
        }
        let poses = self.poses_in_world(q);
        let last = poses[..self.rows()].last().zip(self.links().last());
        let tip = last.map_or(self.base, |(pose, link)| pose.then(&link.tip));
        homogeneous(&tip)
    }

    /// Geometric Jacobian of the tip's origin p: rows vx vy vz wx wy wz in the world.
    ///
    /// Column i is `(z_i x (p - p_i), z_i)` for a revolute joint, `(z_i, 0)` for a prismatic one
    /// (Craig, section 5.8).
    pub fn jacobian(&self, q: &SVector<f64, N>) -> SMatrix<f64, 6, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.jacobian(q);
        }
        let poses = self.poses_in_world(q);
        let tip = self
            .forward_kinematics(q)
            .fixed_view::<3, 1>(0, 3)
            .into_owned();
        let mut jacobian = SMatrix::<f64, 6, N>::zeros();
        for (i, pose) in poses.iter().take(self.rows()).enumerate() {
            jacobian.set_column(i, &self.column(i, pose, &tip));
        }
        jacobian
    }
}

impl<const N: usize> NewtonEuler<N> {
    /// The rate of the geometric Jacobian along a motion.
    ///
    /// Column i, `(z_i x r_i, z_i)` with `r_i = p - p_i`, changes as its vectors do:
    /// `dz_i/dt = w_i x z_i`, and `dr_i/dt` is the velocity of the tip less that of a point of axis i.
    pub fn jacobian_rate(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SMatrix<f64, 6, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.jacobian_rate(q, qd);
        }
        let poses = self.poses_in_world(q);
        let jacobian = self.jacobian(q);
        let tip = self
            .forward_kinematics(q)
            .fixed_view::<3, 1>(0, 3)
            .into_owned();
        let velocity_of_tip = (jacobian * qd).fixed_rows::<3>(0).into_owned();
        let mut rate = SMatrix::<f64, 6, N>::zeros();
        for (i, pose) in poses.iter().take(self.rows()).enumerate() {
            let axis = pose.rotation.column(2).into_owned();
            let place = pose.position;
            // Of the axis and of its point, by the joints before it.
            let (mut w, mut v) = (Vector3::zeros(), Vector3::zeros());
            for k in 0..i {
                let column = self.column(k, &poses[k], &place) * qd[k];
                v += column.fixed_rows::<3>(0);
                w += column.fixed_rows::<3>(3);
            }
            let turning = w.cross(&axis);
            let mut column = rate.column_mut(i);
            match self.links[i].joint_type {
                JointType::Revolute => {
                    let linear = turning.cross(&(tip - place)) + axis.cross(&(velocity_of_tip - v));
                    column.fixed_rows_mut::<3>(0).copy_from(&linear);
                    column.fixed_rows_mut::<3>(3).copy_from(&turning);
                }
                JointType::Prismatic => column.fixed_rows_mut::<3>(0).copy_from(&turning),
            }
        }
        rate
    }

    /// Geometric Jacobians of the origins of all link frames of the table; joints beyond a link do not
    /// move it.
    pub fn link_jacobians(&self, q: &SVector<f64, N>) -> [SMatrix<f64, 6, N>; N] {
        if let Some(coupled) = &self.coupled {
            return coupled.link_jacobians(q);
        }
        let (poses, frames) = (self.poses_in_world(q), self.table_frames(q));
        let mut jacobians = [SMatrix::<f64, 6, N>::zeros(); N];
        for (link, jacobian) in jacobians.iter_mut().take(self.rows()).enumerate() {
            for (i, pose) in poses[..=link].iter().enumerate() {
                jacobian.set_column(i, &self.column(i, pose, &frames[link].position));
            }
        }
        jacobians
    }

    /// Centre of mass of all links and of the tool in the world, `sum m c / sum m`.
    pub fn center_of_mass(&self, q: &SVector<f64, N>) -> Vector3<f64> {
        if let Some(coupled) = &self.coupled {
            return coupled.center_of_mass(q);
        }
        let poses = self.poses_in_world(q);
        let moment = |i: usize| self.center(i, &poses[i]) * self.links[i].mass;
        (0..self.rows()).map(moment).sum::<Vector3<f64>>() / self.total_mass()
    }

    /// Jacobian of the centre of mass: column i is the sum of what joint i gives the centres of the
    /// links beyond it.
    pub fn center_of_mass_jacobian(&self, q: &SVector<f64, N>) -> SMatrix<f64, 3, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.center_of_mass_jacobian(q);
        }
        let poses = self.poses_in_world(q);
        let mut jacobian = SMatrix::<f64, 3, N>::zeros();
        for (i, pose) in poses.iter().take(self.rows()).enumerate() {
            for link in i..self.rows() {
                let center = self.center(link, &poses[link]);
                let column = self.column(i, pose, &center);
                let moment = column.fixed_rows::<3>(0) * self.links[link].mass;
                jacobian.column_mut(i).add_assign(&moment);
            }
        }
        jacobian / self.total_mass()
    }

    fn total_mass(&self) -> f64 {
        self.links().iter().map(|link| link.mass).sum()
    }

    /// The centre of mass of a link whose joint's frame is at `pose`.
    fn center(&self, link: usize, pose: &Pose) -> Vector3<f64> {
        pose.rotation * self.links[link].com + pose.position
    }

    /// What joint i, whose frame is at `pose`, gives a point beyond it at unit speed, above the angular
    /// velocity of its link.
    fn column(&self, i: usize, pose: &Pose, point: &Vector3<f64>) -> Vector6<f64> {
        let axis = pose.rotation.column(2).into_owned();
        let (linear, angular) = match self.links[i].joint_type {
            JointType::Revolute => (axis.cross(&(point - pose.position)), axis),
            JointType::Prismatic => (axis, Vector3::zeros()),
        };
        let [x, y, z]: [f64; 3] = linear.into();
        let [u, v, w]: [f64; 3] = angular.into();
        Vector6::new(x, y, z, u, v, w)
    }
}

fn homogeneous(pose: &Pose) -> Matrix4<f64> {
    let mut matrix = pose.rotation.to_homogeneous();
    matrix
        .fixed_view_mut::<3, 1>(0, 3)
        .copy_from(&pose.position);
    matrix
}
