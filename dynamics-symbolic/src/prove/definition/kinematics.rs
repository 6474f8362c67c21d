//! Poses and motions of a frame, of the links and of the centre of mass: derivatives of poses.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::configuration::Configuration;
use super::derivatives::transpose;
use super::elimination::{solve, with_pivots};
use super::equations::product;
use super::pose::{Lift, Pose};
use super::{Definition, Frame, Matrix, Vector};
use crate::linear::Vector3;

impl Definition {
    /// Rotation by rows and position of a named frame, or of the tip; `None` if there is none.
    pub(in super::super) fn pose_of(&self, frame: Option<usize>) -> Option<[Number; 12]> {
        let frame = match frame {
            Some(frame) => self.frames.get(frame)?,
            None => self.tip.as_ref()?,
        };
        let pose = self.pose(frame, &self.q);
        let entries = pose.rotation.0.into_iter().flatten().chain(pose.origin.0);
        let entries: Vec<Number> = entries.collect();
        entries.try_into().ok()
    }

    /// The pose of a frame in the world.
    pub(super) fn forward_kinematics(&self, frame: &Frame) -> Vector {
        homogeneous(&self.pose(frame, &self.q))
    }

    /// The poses in the world of the frames of all links whose joints move.
    pub(super) fn link_poses(&self) -> Vector {
        let frames = self.frames(&self.q);
        let links = self.free_rows();
        links.flat_map(|i| homogeneous(&frames[i].link)).collect()
    }

    /// By rows: vx vy vz wx wy wz of the frame's origin for unit velocity of each degree of freedom.
    pub(super) fn jacobian(&self, frame: &Frame) -> Matrix {
        let column = |j: usize| velocity(&self.pose(frame, &self.along(j))).to_vec();
        self.by_columns(column)
    }

    /// By rows, link by link: the velocities of the frames of all links whose joints move.
    pub(super) fn link_jacobians(&self) -> Vector {
        let joints = 0..self.dof();
        let frames: Vec<_> = joints.map(|j| self.frames(&self.along(j))).collect();
        let column = |i: usize, j: usize| velocity(&frames[j][i].link).to_vec();
        let jacobian = |i: usize| self.by_columns(|j| column(i, j)).concat();
        self.free_rows().flat_map(jacobian).collect()
    }

    /// J' w
    pub(super) fn wrench_torques(&self, frame: &Frame) -> Vector {
        product(&transpose(&self.jacobian(frame)), &self.wrench)
    }

    /// The rate of the frame's pose along the motion.
    pub(super) fn tool_velocity(&self, frame: &Frame) -> Vector {
        velocity(&self.pose(frame, &self.moving(&self.q, &self.qd))).to_vec()
    }

    /// The rate of that velocity, where the velocities change at the rate qdd.
    pub(super) fn tool_acceleration(&self, frame: &Frame) -> Vector {
        let velocity = velocity(&self.pose(frame, &self.accelerating()));
        velocity.map(|x| x.derivative).to_vec()
    }

    /// By rows: the rate of each column of the Jacobian along the motion.
    pub(super) fn jacobian_rate(&self, frame: &Frame) -> Vector {
        let column = |j: usize| -> Vector {
            let along_motion = self.moving(&self.q, &self.qd);
            let velocity = velocity(&self.pose(frame, &self.moving(&along_motion, &self.unit(j))));
            velocity.iter().map(|x| x.derivative).collect()
        };
        self.by_columns(column).concat()
    }

    /// J M^-1 J' by rows, the pivots, and the diagonal of M. Where M is identically singular there are
    /// no values.
    pub(super) fn operational_inertia_inverse(
        &self,
        frame: &Frame,
        computed: &[Option<Number>],
    ) -> Vector {
        let matrix = self.mass_matrix(&self.q);
        let jacobian = self.jacobian(frame);
        let values = match solve(matrix.clone(), transpose(&jacobian)) {
            Some(x) => {
                let columns = transpose(&x);
                let rows = jacobian.iter().map(|row| product(&columns, row));
                rows.flatten().map(Some).collect()
            }
            None => vec![None; 36],
        };
        with_pivots(values, matrix, computed)
    }

    /// The centre of mass, sum m c / sum m, of all bodies that can move; none of an arm without mass.
    pub(super) fn center_of_mass(&self) -> Option<Vector> {
        let mass = self.moving_mass().inverse()?;
        let moment = self.first_moment(&self.q);
        Some(moment.0.iter().map(|&x| x * mass).collect())
    }

    /// Its derivatives by the degrees of freedom, by rows.
    pub(super) fn center_of_mass_jacobian(&self) -> Option<Vector> {
        let mass = self.moving_mass().inverse()?;
        let column = |j: usize| -> Vector {
            let moment = self.first_moment(&self.along(j));
            moment.0.iter().map(|x| x.derivative * mass).collect()
        };
        Some(self.by_columns(column).concat())
    }

    pub(super) fn moving_mass(&self) -> Number {
        let bodies = self.moving_bodies(&self.q).into_iter();
        bodies.fold(Number::ZERO, |sum, (body, _)| sum + body.mass)
    }

    fn first_moment<R: Lift>(&self, q: &Configuration<R>) -> Vector3<R> {
        let none = Vector3::splat(R::lift(Number::ZERO));
        let bodies = self.moving_bodies(q).into_iter();
        bodies.fold(none, |sum, (body, pose)| {
            sum + body.center(&pose) * R::lift(body.mass)
        })
    }

    /// The rows of the free joints.
    fn free_rows(&self) -> impl Iterator<Item = usize> {
        (0..self.rows.len()).filter(|&i| self.rows[i].joint.is_free)
    }
}

/// vx vy vz wx wy wz of a frame in the world, from a pose with its rate.
fn velocity<R: Lift>(pose: &Pose<Dual<R>>) -> [R; 6] {
    let [wx, wy, wz] = pose.axes().apply(pose.angular_velocity()).0;
    let [vx, vy, vz] = pose.velocity().0;
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
