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
use crate::table::{AsArm as _, FixedFrame};

/// A frame in the world, and the link that carries it; none for a frame on the base.
struct Carried {
    link: Option<usize>,
    pose: Pose,
}

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

    /// The tip in the world, and the link that carries it. There is none where several rows carry no other.
    fn tip(&self, poses: &D::Links<Pose>) -> Option<Carried> {
        let tip = |link: usize| poses[link].then(&self.links[link].tip);
        let is_there = self.tip_link.is_some() || self.count == 0;
        is_there.then(|| Carried {
            link: self.tip_link,
            pose: self.tip_link.map_or(self.base, tip),
        })
    }

    /// A frame of the table in the world, and the link that carries it.
    fn frame(&self, frame: usize, poses: &D::Links<Pose>) -> Carried {
        let FixedFrame { on, place, .. } = &self.table.arm().frames[frame];
        let carrier = on.map_or(self.base, |k| self.table_frame(k, poses));
        Carried {
            link: *on,
            pose: carrier.then(&place.into()),
        }
    }

    /// Homogeneous transforms of the link frames in the world, of those joints that move by themselves.
    pub fn link_poses(&self, q: &D::Vector) -> D::Each<Matrix4<f64>> {
        let poses = self.poses_in_world(q);
        self.per_joint(|k| homogeneous(&self.table_frame(k, &poses)))
    }

    /// Homogeneous transform of the tip in the world: of the tool, or else of the only link frame that carries no other
    /// link. For no joints, that of the base.
    pub fn forward_kinematics(&self, q: &D::Vector) -> Matrix4<f64> {
        let tip = self.tip(&self.poses_in_world(q));
        tip.map_or(Matrix4::repeat(f64::NAN), |tip| homogeneous(&tip.pose))
    }

    /// Homogeneous transform of a frame in the world.
    pub fn frame_pose(&self, frame: usize, q: &D::Vector) -> Matrix4<f64> {
        homogeneous(&self.frame(frame, &self.poses_in_world(q)).pose)
    }

    /// Geometric Jacobian of the tip's origin p: rows vx vy vz wx wy wz in the world.
    ///
    /// Column i is `(z_i x (p - p_i), z_i)` for a revolute joint, `(z_i, 0)` for a prismatic one
    /// (Craig, section 5.8).
    pub fn jacobian(&self, q: &D::Vector) -> D::Columns<6> {
        let poses = self.poses_in_world(q);
        let tip = self.tip(&poses);
        tip.map_or_else(|| self.no_columns(), |tip| self.jacobian_of(&tip, &poses))
    }

    /// Geometric Jacobian of a frame's origin. The columns of joints that do not carry it are zero.
    pub fn frame_jacobian(&self, frame: usize, q: &D::Vector) -> D::Columns<6> {
        let poses = self.poses_in_world(q);
        self.jacobian_of(&self.frame(frame, &poses), &poses)
    }

    /// J' w: the torques of a wrench w = (fx fy fz nx ny nz), N and N m, on a frame, about its origin and in the axes of
    /// the world.
    pub fn frame_wrench_torques(
        &self,
        frame: usize,
        q: &D::Vector,
        wrench: &Vector6<f64>,
    ) -> D::Vector {
        let jacobian = self.frame_jacobian(frame, q);
        let torque = |joint| (0..6).map(|row| jacobian[(row, joint)] * wrench[row]).sum();
        self.size.vector_of(torque)
    }

    /// The columns of a tip that is not there.
    fn no_columns(&self) -> D::Columns<6> {
        let mut columns = self.size.columns();
        for (row, joint) in (0..6).flat_map(|row| (0..self.dof()).map(move |joint| (row, joint))) {
            columns[(row, joint)] = f64::NAN;
        }
        columns
    }

    /// The rate of the geometric Jacobian along a motion.
    pub fn jacobian_rate(&self, q: &D::Vector, qd: &D::Vector) -> D::Columns<6> {
        let poses = self.poses_in_world(q);
        let tip = self.tip(&poses);
        tip.map_or_else(
            || self.no_columns(),
            |tip| self.jacobian_rate_of(&tip, &poses, qd),
        )
    }

    /// The rate of the geometric Jacobian of a frame along a motion.
    pub fn frame_jacobian_rate(
        &self,
        frame: usize,
        q: &D::Vector,
        qd: &D::Vector,
    ) -> D::Columns<6> {
        let poses = self.poses_in_world(q);
        self.jacobian_rate_of(&self.frame(frame, &poses), &poses, qd)
    }

    /// Column i, `(z_i x r_i, z_i)` with `r_i = p - p_i`, changes as its vectors do:
    /// `dz_i/dt = w_i x z_i`, and `dr_i/dt` is the velocity of the frame less that of a point of axis i.
    fn jacobian_rate_of(
        &self,
        Carried { link, pose: frame }: &Carried,
        poses: &D::Links<Pose>,
        qd: &D::Vector,
    ) -> D::Columns<6> {
        let mut rate = self.size.columns();
        let [velocity_of_frame, _] = self.velocity(*link, &frame.position, poses, qd);
        self.walk_from(*link, |joint| {
            let axis = poses[joint.k].rotation.column(2).into_owned();
            let place = poses[joint.k].position;
            // The velocity of the axis and of its point, by the joints before it.
            let [v, w] = self.velocity(joint.carrier, &place, poses, qd);
            let turning = w.cross(&axis);
            let column = match joint.link.joint_type {
                JointType::Revolute => {
                    let arm = frame.position - place;
                    let linear = turning.cross(&arm) + axis.cross(&(velocity_of_frame - v));
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
        self.walk_from(link, |place| {
            velocity += column(place.link, &poses[place.k], point) * place.of(qd);
        });
        [0, 3].map(|first| velocity.fixed_rows::<3>(first).into_owned())
    }

    /// Geometric Jacobians of the origins of the link frames, of those joints that move by themselves; joints that do not
    /// carry a link do not move it.
    pub fn link_jacobians(&self, q: &D::Vector) -> D::Each<D::Columns<6>> {
        let poses = self.poses_in_world(q);
        self.per_joint(|k| {
            let pose = self.table_frame(k, &poses);
            let link = Some(k);
            self.jacobian_of(&Carried { link, pose }, &poses)
        })
    }

    /// Geometric Jacobian of a frame's origin.
    fn jacobian_of(&self, frame: &Carried, poses: &D::Links<Pose>) -> D::Columns<6> {
        let mut jacobian = self.size.columns();
        self.walk_from(frame.link, |place| {
            let column = column(place.link, &poses[place.k], &frame.pose.position);
            place.add_column(&mut jacobian, 6, |row| column[row]);
        });
        jacobian
    }

    /// Centre of mass of all links, of the tool and of the bodies of frames in the world, `sum m c / sum m`.
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
pub(super) fn center(link: &Link, pose: &Pose) -> Vector3<f64> {
    pose.rotation * link.com + pose.position
}

/// The velocity of a point beyond a joint at unit speed, above the angular velocity of the link. The joint's frame is at
/// `pose`.
pub(super) fn column(link: &Link, pose: &Pose, point: &Vector3<f64>) -> Vector6<f64> {
    let axis = pose.rotation.column(2).into_owned();
    match link.joint_type {
        JointType::Revolute => joined(&axis.cross(&(point - pose.position)), &axis),
        JointType::Prismatic => joined(&axis, &Vector3::zeros()),
    }
}

pub(super) fn joined(linear: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6<f64> {
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
