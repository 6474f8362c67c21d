//! Places of the frames, and the Jacobian.

use nalgebra::{Matrix4, Vector3, Vector6};

use super::NumericArm;
use super::angle::SinCos;
use super::joint::Joint;
use super::link::Link;
use super::pose::Pose;
use crate::JointType;
use crate::size::Size;

/// How many sines are evaluated at once.
const AT_ONCE: usize = 4;

impl<D: Size> NumericArm<D> {
    /// The joints at their positions.
    #[inline(always)]
    pub(super) fn joints(&self, q: &D::Vector) -> D::Links<Joint> {
        let mut joints = self.per_link(Joint::new(SinCos::ZERO, 0.0, SinCos::ZERO, 0.0));
        for first in (0..self.count).step_by(AT_ONCE) {
            let last = self.count.min(first + AT_ONCE);
            let mut positions = [0.0; AT_ONCE];
            for k in first..last {
                positions[k - first] = self.links[k].of(q);
            }
            let turned = SinCos::of_joints(positions);
            for k in first..last {
                joints[k] = self.links[k].joint(positions[k - first], turned[k - first]);
            }
        }
        joints
    }

    /// The joints' frames in the world.
    pub(super) fn poses_in_world(&self, q: &D::Vector) -> D::Links<Pose> {
        let joints = self.joints(q);
        self.outward(self.base, |k, _, pose| pose.then(&joints[k].pose()))
    }

    /// The table's link frame of a link whose joint's frame is one of these.
    fn table_frame(&self, k: usize, poses: &D::Links<Pose>) -> Pose {
        poses[k].then(&self.links[k].table_frame)
    }

    /// The last link, which carries the tip, and the tip in the world.
    fn tip(&self, poses: &D::Links<Pose>) -> Option<(usize, Pose)> {
        let last = self.count.checked_sub(1)?;
        Some((last, poses[last].then(&self.links[last].tip)))
    }

    /// Homogeneous transforms of the link frames in the world, of those joints that move by themselves.
    pub fn link_poses(&self, q: &D::Vector) -> D::Each<Matrix4<f64>> {
        let poses = self.poses_in_world(q);
        self.per_joint(|k| homogeneous(&self.table_frame(k, &poses)))
    }

    /// Homogeneous transform of the tip in the world: of the tool, or else of the last link frame. For
    /// no joints, that of the base.
    pub fn forward_kinematics(&self, q: &D::Vector) -> Matrix4<f64> {
        let tip = self.tip(&self.poses_in_world(q));
        homogeneous(&tip.map_or(self.base, |(_, tip)| tip))
    }

    /// Geometric Jacobian of the tip's origin p: rows vx vy vz wx wy wz in the world.
    ///
    /// Column i is `(z_i x (p - p_i), z_i)` for a revolute joint, `(z_i, 0)` for a prismatic one
    /// (Craig, section 5.8).
    pub fn jacobian(&self, q: &D::Vector) -> D::Columns<6> {
        let poses = self.poses_in_world(q);
        match self.tip(&poses) {
            Some((last, tip)) => self.point_jacobian(last, &tip.position, &poses),
            None => self.size.columns(),
        }
    }

    /// The rate of the geometric Jacobian along a motion.
    ///
    /// Column i, `(z_i x r_i, z_i)` with `r_i = p - p_i`, changes as its vectors do:
    /// `dz_i/dt = w_i x z_i`, and `dr_i/dt` is the velocity of the tip less that of a point of axis i.
    pub fn jacobian_rate(&self, q: &D::Vector, qd: &D::Vector) -> D::Columns<6> {
        let poses = self.poses_in_world(q);
        let mut rate = self.size.columns();
        let Some((last, tip)) = self.tip(&poses) else {
            return rate;
        };
        let velocity_of_tip = self.velocity(Some(last), &tip.position, &poses, qd)[0];
        for (k, link) in self.carriers(last) {
            let axis = poses[k].rotation.column(2).into_owned();
            let place = poses[k].position;
            // Of the axis and of its point, by the joints before it.
            let [v, w] = self.velocity(link.carrier, &place, &poses, qd);
            let turning = w.cross(&axis);
            let column = match link.joint_type {
                JointType::Revolute => {
                    let arm = tip.position - place;
                    let linear = turning.cross(&arm) + axis.cross(&(velocity_of_tip - v));
                    joined(&linear, &turning)
                }
                JointType::Prismatic => joined(&turning, &Vector3::zeros()),
            };
            for row in 0..6 {
                rate[(row, link.joint)] += link.factor * column[row];
            }
        }
        rate
    }

    /// Linear and angular velocity of a point that a link carries; at rest on the base.
    fn velocity(
        &self,
        link: Option<usize>,
        point: &Vector3<f64>,
        poses: &D::Links<Pose>,
        qd: &D::Vector,
    ) -> [Vector3<f64>; 2] {
        let mut velocity = Vector6::zeros();
        for (k, link) in link.into_iter().flat_map(|link| self.carriers(link)) {
            velocity += column(link, &poses[k], point) * link.of(qd);
        }
        [0, 3].map(|first| velocity.fixed_rows::<3>(first).into_owned())
    }

    /// Geometric Jacobians of the origins of the link frames, of those joints that move by themselves; joints that do not
    /// carry a link do not move it.
    pub fn link_jacobians(&self, q: &D::Vector) -> D::Each<D::Columns<6>> {
        let poses = self.poses_in_world(q);
        self.per_joint(|k| {
            let origin = self.table_frame(k, &poses).position;
            self.point_jacobian(k, &origin, &poses)
        })
    }

    /// Geometric Jacobian of a point that link k carries.
    fn point_jacobian(
        &self,
        k: usize,
        point: &Vector3<f64>,
        poses: &D::Links<Pose>,
    ) -> D::Columns<6> {
        let mut jacobian = self.size.columns();
        for (i, link) in self.carriers(k) {
            let column = column(link, &poses[i], point);
            for row in 0..6 {
                jacobian[(row, link.joint)] += link.factor * column[row];
            }
        }
        jacobian
    }

    /// Centre of mass of all links and of the tool in the world, `sum m c / sum m`.
    pub fn center_of_mass(&self, q: &D::Vector) -> Vector3<f64> {
        let poses = self.poses_in_world(q);
        let moment = |(k, link): (usize, &Link)| center(link, &poses[k]) * link.mass;
        self.links().map(moment).sum::<Vector3<f64>>() / self.total_mass()
    }

    /// Jacobian of the centre of mass: column i is the sum of what joint i gives the centres of the
    /// links beyond it.
    pub fn center_of_mass_jacobian(&self, q: &D::Vector) -> D::Columns<3> {
        let (poses, total) = (self.poses_in_world(q), self.total_mass());
        let mut jacobian = self.size.columns();
        for (k, body) in self.links() {
            let center = center(body, &poses[k]);
            for (i, link) in self.carriers(k) {
                let column = column(link, &poses[i], &center);
                for row in 0..3 {
                    jacobian[(row, link.joint)] += link.factor * column[row] * body.mass / total;
                }
            }
        }
        jacobian
    }

    fn total_mass(&self) -> f64 {
        self.links().map(|(_, link)| link.mass).sum()
    }
}

/// The centre of mass of a link whose joint's frame is at `pose`.
fn center(link: &Link, pose: &Pose) -> Vector3<f64> {
    pose.rotation * link.com + pose.position
}

/// What a joint, whose frame is at `pose`, gives a point beyond it at unit speed, above the angular
/// velocity of its link.
fn column(link: &Link, pose: &Pose, point: &Vector3<f64>) -> Vector6<f64> {
    let axis = pose.rotation.column(2).into_owned();
    match link.joint_type {
        JointType::Revolute => joined(&axis.cross(&(point - pose.position)), &axis),
        JointType::Prismatic => joined(&axis, &Vector3::zeros()),
    }
}

fn joined(linear: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(
        linear.x, linear.y, linear.z, angular.x, angular.y, angular.z,
    )
}

fn homogeneous(pose: &Pose) -> Matrix4<f64> {
    let mut matrix = pose.rotation.to_homogeneous();
    matrix
        .fixed_view_mut::<3, 1>(0, 3)
        .copy_from(&pose.position);
    matrix
}
