//! Places of the frames, and the Jacobians.

use nalgebra::{Matrix4, Vector3, Vector6};

use super::{NumericFloating, Place, twist};
use crate::Pose;
use crate::newton_euler::kinematics::{Carried, Ground, center, column, homogeneous, joined};
use crate::size::Size;

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// Homogeneous transforms of the link frames in the world, of those joints that move by themselves.
    pub fn link_poses(&self, base: &Pose<f64>, q: &D::Vector) -> D::Each<Matrix4<f64>> {
        let poses = self.arm.poses_on(&base.into(), q);
        self.arm
            .per_joint(|k| homogeneous(&self.arm.table_frame(k, &poses)))
    }

    /// Homogeneous transform of the tip in the world: of the tool, or else of the only link frame that carries no other
    /// link. For no joints, that of the base.
    pub fn forward_kinematics(&self, base: &Pose<f64>, q: &D::Vector) -> Matrix4<f64> {
        let tip = self.tip(base, &self.arm.poses_on(&base.into(), q));
        tip.map_or(Matrix4::repeat(f64::NAN), |tip| homogeneous(&tip.pose))
    }

    /// Homogeneous transform of a frame in the world.
    pub fn frame_pose(&self, frame: usize, base: &Pose<f64>, q: &D::Vector) -> Matrix4<f64> {
        let poses = self.arm.poses_on(&base.into(), q);
        homogeneous(&self.arm.frame_on(&base.into(), frame, &poses).pose)
    }

    /// Geometric Jacobian of the tip's origin, 6 x V: rows vx vy vz wx wy wz in the world, columns of the velocities of the
    /// base in its own axes and of the joints.
    ///
    /// With the rotation R of the base and r from its origin to the tip, the base has the columns `[R, -[r]x R; 0, R]`.
    pub fn jacobian(&self, base: &Pose<f64>, q: &D::Vector) -> V::Columns<6> {
        let poses = self.arm.poses_on(&base.into(), q);
        let tip = self.tip(base, &poses);
        tip.map_or_else(
            || self.arm.no_columns(),
            |tip| self.jacobian_of(&tip, base, &poses),
        )
    }

    /// Geometric Jacobian of a frame's origin. The columns of joints that do not carry it are zero.
    pub fn frame_jacobian(&self, frame: usize, base: &Pose<f64>, q: &D::Vector) -> V::Columns<6> {
        let poses = self.arm.poses_on(&base.into(), q);
        let frame = self.arm.frame_on(&base.into(), frame, &poses);
        self.jacobian_of(&frame, base, &poses)
    }

    /// J' w: the forces of a wrench w = (fx fy fz nx ny nz), N and N m, on a frame, about its origin and in the axes of the
    /// world.
    pub fn frame_wrench_torques(
        &self,
        frame: usize,
        base: &Pose<f64>,
        q: &D::Vector,
        wrench: &Vector6<f64>,
    ) -> V::Vector {
        let jacobian = self.frame_jacobian(frame, base, q);
        let force = |j| (0..6).map(|row| jacobian[(row, j)] * wrench[row]).sum();
        self.arm.freedoms.vector_of(force)
    }

    /// The rate of the geometric Jacobian along a motion.
    pub fn jacobian_rate(&self, base: &Pose<f64>, q: &D::Vector, v: &V::Vector) -> V::Columns<6> {
        let poses = self.arm.poses_on(&base.into(), q);
        let tip = self.tip(base, &poses);
        tip.map_or_else(
            || self.arm.no_columns(),
            |tip| self.jacobian_rate_of(&tip, base, &poses, v),
        )
    }

    /// The rate of the geometric Jacobian of a frame along a motion.
    pub fn frame_jacobian_rate(
        &self,
        frame: usize,
        base: &Pose<f64>,
        q: &D::Vector,
        v: &V::Vector,
    ) -> V::Columns<6> {
        let poses = self.arm.poses_on(&base.into(), q);
        let frame = self.arm.frame_on(&base.into(), frame, &poses);
        self.jacobian_rate_of(&frame, base, &poses, v)
    }

    /// Geometric Jacobians of the origins of the link frames, of those joints that move by themselves.
    pub fn link_jacobians(&self, base: &Pose<f64>, q: &D::Vector) -> D::Each<V::Columns<6>> {
        let poses = self.arm.poses_on(&base.into(), q);
        self.arm.per_joint(|k| {
            let pose = self.arm.table_frame(k, &poses);
            let link = Some(k);
            self.jacobian_of(&Carried { link, pose }, base, &poses)
        })
    }

    /// Centre of mass of the base, of all links, of the tool and of the bodies of frames in the world, `sum m c / sum m`.
    pub fn center_of_mass(&self, base: &Pose<f64>, q: &D::Vector) -> Vector3<f64> {
        let poses = self.arm.poses_on(&base.into(), q);
        let mut moment = self.center_of_base(base) * self.body.mass;
        self.arm
            .walk_outward(|place| moment += center(place.link, &poses[place.k]) * place.link.mass);
        moment / self.total_mass()
    }

    /// Jacobian of the centre of mass, 3 x V, in the world.
    pub fn center_of_mass_jacobian(&self, base: &Pose<f64>, q: &D::Vector) -> V::Columns<3> {
        let (poses, total) = (self.arm.poses_on(&base.into(), q), self.total_mass());
        let mut jacobian = self.arm.freedoms.columns();
        let mut add_base = |center: &Vector3<f64>, mass: f64| {
            for (j, column) in columns(base, center).into_iter().enumerate() {
                (0..3).for_each(|row| jacobian[(row, j)] += column[row] * mass / total);
            }
        };
        add_base(&self.center_of_base(base), self.body.mass);
        self.arm
            .walk_outward(|body| add_base(&center(body.link, &poses[body.k]), body.link.mass));
        self.arm.walk_outward(|body| {
            let center = center(body.link, &poses[body.k]);
            self.arm.walk_to_base(body.k, |place| {
                let column = column(place.link, &poses[place.k], &center);
                place.add_column(&mut jacobian, 3, |row| column[row] * body.link.mass / total);
            });
        });
        jacobian
    }
}

impl<D: Size, V: Size> NumericFloating<D, V> {
    fn tip(&self, base: &Pose<f64>, poses: &D::Links<Place>) -> Option<Carried> {
        self.arm.tip_on(&Place::from(base).then(&self.tip), poses)
    }

    fn center_of_base(&self, base: &Pose<f64>) -> Vector3<f64> {
        base.rotation * self.body.com + base.position
    }

    /// Mass of all bodies.
    fn total_mass(&self) -> f64 {
        self.body.mass + self.arm.total_mass()
    }

    fn jacobian_of(
        &self,
        frame: &Carried,
        base: &Pose<f64>,
        poses: &D::Links<Place>,
    ) -> V::Columns<6> {
        let mut jacobian = self.arm.jacobian_of(frame, poses);
        for (j, column) in columns(base, &frame.pose.position).into_iter().enumerate() {
            (0..6).for_each(|row| jacobian[(row, j)] = column[row]);
        }
        jacobian
    }

    /// The columns of the base change as their vectors do: `dR/dt = [w]x R`, and dr/dt is the velocity of the frame less that
    /// of the base.
    fn jacobian_rate_of(
        &self,
        frame: &Carried,
        base: &Pose<f64>,
        poses: &D::Links<Place>,
        v: &V::Vector,
    ) -> V::Columns<6> {
        let [linear, angular] = twist::<V>(v).map(|part| base.rotation * part);
        let ground = Ground {
            origin: base.position,
            linear,
            angular,
        };
        let mut rate = self.arm.jacobian_rate_of(frame, poses, v, &ground);
        let point = &frame.pose.position;
        let [of_frame, _] = self.arm.velocity(frame.link, point, poses, v, &ground);
        let (arm, arm_rate) = (point - base.position, of_frame - linear);
        for j in 0..3 {
            let axis = base.rotation.column(j).into_owned();
            let turning = angular.cross(&axis);
            let lever = turning.cross(&arm) + axis.cross(&arm_rate);
            let (push, turn) = (
                joined(&turning, &Vector3::zeros()),
                joined(&lever, &turning),
            );
            for row in 0..6 {
                rate[(row, j)] = push[row];
                rate[(row, 3 + j)] = turn[row];
            }
        }
        rate
    }
}

/// The velocity of a point of the base above its angular velocity, for a unit of each of the base's six numbers.
fn columns(base: &Pose<f64>, point: &Vector3<f64>) -> [Vector6<f64>; 6] {
    let arm = point - base.position;
    core::array::from_fn(|j| {
        let axis = base.rotation.column(j % 3).into_owned();
        if j < 3 {
            joined(&axis, &Vector3::zeros())
        } else {
            joined(&axis.cross(&arm), &axis)
        }
    })
}
