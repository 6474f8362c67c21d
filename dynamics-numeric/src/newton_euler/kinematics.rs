//! Places of the frames, and the Jacobian.

use dynamics_runtime::internal::geometry::{Joint, Pose, SinCos};
use dynamics_runtime::table::{AsArm as _, FixedFrame};
use dynamics_runtime::{JointType, Size};
use nalgebra::{Matrix3, Matrix4, Vector3, Vector6};

use super::inertia::Solid;
use super::link::Link;
use super::walk::Place;
use super::{NumericArm, Placed};

/// A frame in the world, and the link that carries it; none for a frame on the base.
struct Carried {
    link: Option<usize>,
    pose: Pose,
}

/// A body in the world.
pub(super) struct BodyInWorld<'a> {
    /// The link that it is; none for that of the base.
    pub(super) link: Option<usize>,
    pub(super) mass: f64,
    /// The centre of mass.
    pub(super) center: Vector3<f64>,
    rotation: &'a Matrix3<f64>,
    tensor: &'a Matrix3<f64>,
}

impl<'a> BodyInWorld<'a> {
    fn new(link: Option<usize>, solid: &'a Solid, Pose { rotation, position }: &'a Pose) -> Self {
        BodyInWorld {
            link,
            mass: solid.mass,
            center: rotation * solid.com + position,
            rotation,
            tensor: &solid.tensor,
        }
    }

    /// The inertia tensor about the centre of mass.
    pub(super) fn tensor(&self) -> Matrix3<f64> {
        self.rotation * self.tensor * self.rotation.transpose()
    }
}

/// The joints' frames and what they carry, in the world.
impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    pub(crate) fn link_poses(&self, q: &D::Vector) -> D::Each<Matrix4<f64>> {
        let poses = self.poses(q);
        self.arm
            .per_joint(|k| homogeneous(&self.arm.table_frame(k, &poses)))
    }

    pub(crate) fn forward_kinematics(&self, q: &D::Vector) -> Matrix4<f64> {
        self.pose_at(None, q)
    }

    pub(crate) fn frame_pose(&self, frame: usize, q: &D::Vector) -> Matrix4<f64> {
        self.pose_at(Some(frame), q)
    }

    pub(crate) fn jacobian(&self, q: &D::Vector) -> V::Columns<6> {
        self.jacobian_at(None, q)
    }

    pub(crate) fn frame_jacobian(&self, frame: usize, q: &D::Vector) -> V::Columns<6> {
        self.jacobian_at(Some(frame), q)
    }

    pub(crate) fn frame_wrench_torques(
        &self,
        frame: usize,
        q: &D::Vector,
        wrench: &Vector6<f64>,
    ) -> V::Vector {
        let jacobian = self.frame_jacobian(frame, q);
        let torque = |joint| (0..6).map(|row| jacobian[(row, joint)] * wrench[row]).sum();
        self.arm.freedoms.vector_of(torque)
    }

    pub(crate) fn jacobian_rate(&self, q: &D::Vector, qd: &V::Vector) -> V::Columns<6> {
        self.jacobian_rate_at(None, q, qd)
    }

    pub(crate) fn frame_jacobian_rate(
        &self,
        frame: usize,
        q: &D::Vector,
        qd: &V::Vector,
    ) -> V::Columns<6> {
        self.jacobian_rate_at(Some(frame), q, qd)
    }

    /// The pose of a frame, or of the tip.
    pub(crate) fn pose_at(&self, frame: Option<usize>, q: &D::Vector) -> Matrix4<f64> {
        let carried = self.carried(frame, &self.poses(q));
        carried.map_or(Matrix4::repeat(f64::NAN), |at| homogeneous(&at.pose))
    }

    /// The Jacobian of a frame, or of the tip.
    pub(crate) fn jacobian_at(&self, frame: Option<usize>, q: &D::Vector) -> V::Columns<6> {
        let poses = self.poses(q);
        let carried = self.carried(frame, &poses);
        let jacobian = carried.map(|at| self.jacobian_of(&at, &poses));
        jacobian.unwrap_or_else(|| self.arm.no_columns())
    }

    /// The rate of that Jacobian.
    pub(crate) fn jacobian_rate_at(
        &self,
        frame: Option<usize>,
        q: &D::Vector,
        qd: &V::Vector,
    ) -> V::Columns<6> {
        let poses = self.poses(q);
        let carried = self.carried(frame, &poses);
        let rate = carried.map(|at| self.jacobian_rate_of(&at, &poses, qd));
        rate.unwrap_or_else(|| self.arm.no_columns())
    }

    pub(crate) fn link_jacobians(&self, q: &D::Vector) -> D::Each<V::Columns<6>> {
        let poses = self.poses(q);
        self.arm.per_joint(|k| {
            let pose = self.arm.table_frame(k, &poses);
            let link = Some(k);
            self.jacobian_of(&Carried { link, pose }, &poses)
        })
    }

    pub(crate) fn center_of_mass(&self, q: &D::Vector) -> Vector3<f64> {
        let (mut moment, mut total) = (Vector3::zeros(), 0.0);
        self.bodies(&self.poses(q), |body| {
            moment += body.center * body.mass;
            total += body.mass;
        });
        moment / total
    }

    /// Each velocity is the sum of what it gives the centres of the bodies that it moves.
    pub(crate) fn center_of_mass_jacobian(&self, q: &D::Vector) -> V::Columns<3> {
        let (poses, mut total) = (self.poses(q), 0.0);
        self.bodies(&poses, |body| total += body.mass);
        let mut jacobian = self.arm.freedoms.columns();
        self.bodies(&poses, |body| {
            self.columns(body.link, &body.center, &poses, |j, column| {
                (0..3).for_each(|row| jacobian[(row, j)] += column[row] * body.mass / total);
            });
        });
        jacobian
    }

    /// The joints' frames in the world.
    pub(super) fn poses(&self, q: &D::Vector) -> D::Links<Pose> {
        self.arm.poses_on(&self.base.place, q)
    }

    /// The tip in the world, and the link that carries it. There is none where several rows carry no other.
    fn tip(&self, poses: &D::Links<Pose>) -> Option<Carried> {
        let arm = self.arm;
        let pose = match (arm.tip_link, arm.body()) {
            (Some(link), _) => poses[link].then(&arm.links[link].tip),
            (None, _) if arm.count > 0 => return None,
            (None, Some(body)) => self.base.place.then(&body.tip),
            (None, None) => self.base.place,
        };
        let link = arm.tip_link;
        Some(Carried { link, pose })
    }

    /// A frame of the table in the world, or the tip, and the link that carries it.
    fn carried(&self, frame: Option<usize>, poses: &D::Links<Pose>) -> Option<Carried> {
        let Some(frame) = frame else {
            return self.tip(poses);
        };
        let FixedFrame { on, place, .. } = &self.arm.table.arm().frames[frame];
        let carrier = on.map_or(self.base.place, |k| self.arm.table_frame(k, poses));
        Some(Carried {
            link: *on,
            pose: carrier.then(&place.into()),
        })
    }

    /// All bodies that move: that of the base, if it does, and the links.
    pub(super) fn bodies(&self, poses: &D::Links<Pose>, mut visit: impl FnMut(BodyInWorld<'_>)) {
        if let Some(body) = self.arm.body() {
            visit(BodyInWorld::new(None, &body.solid, &self.base.place));
        }
        self.arm.walk_outward(|Place { k, link, .. }| {
            visit(BodyInWorld::new(Some(k), &link.solid, &poses[k]));
        });
    }

    /// The velocity of a point that a link or the base carries above the angular velocity there, for a unit of each of the
    /// velocities that move it.
    ///
    /// Column i is `(z_i x (p - p_i), z_i)` for a revolute joint, `(z_i, 0)` for a prismatic one (Craig, section 5.8). With
    /// the rotation R of a base that moves and r from its origin to the point, the base has the columns
    /// `[R, -[r]x R; 0, R]`.
    pub(super) fn columns(
        &self,
        link: Option<usize>,
        point: &Vector3<f64>,
        poses: &D::Links<Pose>,
        mut add: impl FnMut(usize, Vector6<f64>),
    ) {
        if self.arm.floats() {
            let Pose { rotation, position } = self.base.place;
            for j in 0..3 {
                let axis = rotation.column(j).into_owned();
                add(j, joined(&axis, &Vector3::zeros()));
                add(3 + j, joined(&axis.cross(&(point - position)), &axis));
            }
        }
        self.arm.walk_from(link, |place| {
            let column = column(place.link, &poses[place.k], point);
            add(place.joint, column * place.factor);
        });
    }

    /// Geometric Jacobian of a frame's origin.
    fn jacobian_of(&self, frame: &Carried, poses: &D::Links<Pose>) -> V::Columns<6> {
        let mut jacobian = self.arm.freedoms.columns();
        self.columns(frame.link, &frame.pose.position, poses, |j, column| {
            (0..6).for_each(|row| jacobian[(row, j)] += column[row]);
        });
        jacobian
    }

    /// Column i, `(z_i x r_i, z_i)` with `r_i = p - p_i`, changes as its vectors do: `dz_i/dt = w_i x z_i`, and `dr_i/dt` is
    /// the velocity of the frame less that of a point of axis i. The columns of the base change likewise.
    fn jacobian_rate_of(
        &self,
        Carried { link, pose: frame }: &Carried,
        poses: &D::Links<Pose>,
        qd: &V::Vector,
    ) -> V::Columns<6> {
        let mut rate = self.arm.freedoms.columns();
        let velocity = |link, point: &Vector3<f64>| self.velocity(link, point, poses, qd);
        let [of_frame, _] = velocity(*link, &frame.position);
        // The columns of a push along an axis through a place, and of a turn about it.
        let changed = |axis: Vector3<f64>, place: &Vector3<f64>, carrier: Option<usize>| {
            let [v, w] = velocity(carrier, place);
            let turning = w.cross(&axis);
            let lever = turning.cross(&(frame.position - place)) + axis.cross(&(of_frame - v));
            [
                joined(&turning, &Vector3::zeros()),
                joined(&lever, &turning),
            ]
        };
        if self.arm.floats() {
            let Pose { rotation, position } = &self.base.place;
            for j in 0..3 {
                let [push, turn] = changed(rotation.column(j).into_owned(), position, None);
                for row in 0..6 {
                    rate[(row, j)] = push[row];
                    rate[(row, 3 + j)] = turn[row];
                }
            }
        }
        self.arm.walk_from(*link, |joint| {
            let Pose { rotation, position } = &poses[joint.k];
            // The velocity of the axis and of its point, by the joints before it.
            let [push, turn] = changed(rotation.column(2).into_owned(), position, joint.carrier);
            let column = match joint.link.joint_type {
                JointType::Revolute => turn,
                JointType::Prismatic => push,
            };
            joint.add_column(&mut rate, 6, |row| column[row]);
        });
        rate
    }

    /// Linear and angular velocity of a point that a link or the base carries.
    fn velocity(
        &self,
        link: Option<usize>,
        point: &Vector3<f64>,
        poses: &D::Links<Pose>,
        qd: &V::Vector,
    ) -> [Vector3<f64>; 2] {
        let mut velocity = Vector6::zeros();
        self.columns(link, point, poses, |j, column| velocity += column * qd[j]);
        [0, 3].map(|first| velocity.fixed_rows::<3>(first).into_owned())
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
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
                let position = place.position(q);
                let sin_cos = if place.link.is_follower {
                    SinCos::of_joint(position)
                } else {
                    let (sin, cos) = turned[place.joint_of_q()];
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

    /// The joints' frames in the world, from that of the base.
    pub(super) fn poses_on(&self, base: &Pose, q: &D::Vector) -> D::Links<Pose> {
        self.at(q, |joints| {
            let mut poses = self.per_link(*base);
            self.outward(
                *base,
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
    pub(super) fn table_frame(&self, k: usize, poses: &D::Links<Pose>) -> Pose {
        poses[k].then(&self.links[k].table_frame)
    }

    /// The columns of a tip that is not there.
    pub(super) fn no_columns(&self) -> V::Columns<6> {
        let mut columns = self.freedoms.columns();
        for (row, joint) in (0..6).flat_map(|row| (0..self.dof()).map(move |joint| (row, joint))) {
            columns[(row, joint)] = f64::NAN;
        }
        columns
    }
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

pub(super) fn homogeneous(pose: &Pose) -> Matrix4<f64> {
    let mut matrix = pose.rotation.to_homogeneous();
    matrix
        .fixed_view_mut::<3, 1>(0, 3)
        .copy_from(&pose.position);
    matrix
}
