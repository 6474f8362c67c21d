//! Places of the frames, and the Jacobian.

use nalgebra::{Matrix4, Vector3, Vector6};

use super::NumericArm;
use super::angle::SinCos;
use super::joint::Joint;
use super::link::Link;
use super::pose::Pose;
use super::walk::Place;
use crate::JointType;
use crate::size::Size;

impl<D: Size> NumericArm<D> {
    /// A value that is computed from the joints at their positions.
    ///
    /// The list of joints is never moved: its copy took a tenth of the time of short functions.
    #[inline(always)]
    pub(super) fn at<X>(&self, q: &D::Vector, value: impl FnOnce(&D::Links<Joint>) -> X) -> X {
        let turned = D::sin_cos(q);
        let mut joints = self.per_link(Joint::NONE);
        self.walk_outward(
            #[inline(always)]
            |place| {
                let position = place.of(q);
                let sin_cos = if place.link.is_follower {
                    SinCos::of_joint(position)
                } else {
                    let (sin, cos) = turned[place.joint];
                    SinCos { sin, cos }
                };
                joints[place.k] = place.link.joint(position, sin_cos);
            },
        );
        value(&joints)
    }

    /// The joints at their positions.
    pub(super) fn joints(&self, q: &D::Vector) -> D::Links<Joint> {
        self.at(q, |joints| joints.clone())
    }

    /// The joints' frames in the world.
    pub(super) fn poses_in_world(&self, q: &D::Vector) -> D::Links<Pose> {
        self.at(q, |joints| {
            let mut poses = self.per_link(self.base);
            self.outward(
                self.base,
                #[inline(always)]
                |Place { k, .. }, before| {
                    let pose = before.then(&joints[k].pose());
                    poses[k] = pose;
                    pose
                },
            );
            poses
        })
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
        self.walk_to_base(last, |joint| {
            let axis = poses[joint.k].rotation.column(2).into_owned();
            let place = poses[joint.k].position;
            // The velocity of the axis and of its point, by the joints before it.
            let [v, w] = self.velocity(joint.carrier, &place, &poses, qd);
            let turning = w.cross(&axis);
            let column = match joint.link.joint_type {
                JointType::Revolute => {
                    let arm = tip.position - place;
                    let linear = turning.cross(&arm) + axis.cross(&(velocity_of_tip - v));
                    joined(&linear, &turning)
                }
                JointType::Prismatic => joined(&turning, &Vector3::zeros()),
            };
            joint.add_column(&mut rate, 6, |row| column[row]);
        });
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
        if let Some(link) = link {
            self.walk_to_base(link, |place| {
                velocity += column(place.link, &poses[place.k], point) * place.of(qd);
            });
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
        self.walk_to_base(k, |place| {
            let column = column(place.link, &poses[place.k], point);
            place.add_column(&mut jacobian, 6, |row| column[row]);
        });
        jacobian
    }

    /// Centre of mass of all links and of the tool in the world, `sum m c / sum m`.
    pub fn center_of_mass(&self, q: &D::Vector) -> Vector3<f64> {
        let poses = self.poses_in_world(q);
        let mut moment = Vector3::zeros();
        self.walk_outward(|Place { k, link, .. }| moment += center(link, &poses[k]) * link.mass);
        moment / self.total_mass()
    }

    /// Jacobian of the centre of mass: column i is the sum of what joint i gives the centres of the
    /// links beyond it.
    pub fn center_of_mass_jacobian(&self, q: &D::Vector) -> D::Columns<3> {
        let (poses, total) = (self.poses_in_world(q), self.total_mass());
        let mut jacobian = self.size.columns();
        self.walk_outward(|body| {
            let center = center(body.link, &poses[body.k]);
            self.walk_to_base(body.k, |place| {
                let column = column(place.link, &poses[place.k], &center);
                place.add_column(&mut jacobian, 3, |row| column[row] * body.link.mass / total);
            });
        });
        jacobian
    }

    fn total_mass(&self) -> f64 {
        let mut mass = 0.0;
        self.walk_outward(|place| mass += place.link.mass);
        mass
    }
}

/// The centre of mass of a link whose joint's frame is at `pose`.
fn center(link: &Link, pose: &Pose) -> Vector3<f64> {
    pose.rotation * link.com + pose.position
}

/// The velocity of a point beyond a joint at unit speed, above the angular velocity of the link. The joint's frame is at
/// `pose`.
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
