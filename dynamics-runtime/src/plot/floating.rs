//! A run on a base that moves as a figure.

use std::path::Path;

use nalgebra::{Rotation3, SVector, Vector3};

use super::run::{of_joints, with_energies};
use super::{Figure, Outcome, joints};
use crate::simulation::FloatingTrajectory;
use crate::{Model, Trajectory};

impl<const N: usize, const V: usize> FloatingTrajectory<N, V> {
    /// Draws the run into the file, as SVG: panels of the base, its position and its roll, pitch and yaw in the world, its
    /// velocities in its own axes; then those of the joints and of energies, as [`Trajectory::plot`] has them.
    ///
    /// # Errors
    ///
    /// Where the file cannot be written, or there is nothing to draw.
    pub fn plot<R: Model<N, V>>(&self, robot: &R, file: impl AsRef<Path>) -> Outcome {
        self.figure(robot).save(file)
    }

    /// The same as a figure without a title, to add panels to.
    pub fn figure<R: Model<N, V>>(&self, robot: &R) -> Figure {
        let three = |v: &SVector<f64, V>, first: usize| Vector3::from_fn(|i, _| v[first + i]);
        let positions = self.base.iter().map(|base| base.position);
        let angles = self.base.iter().map(|base| {
            let rotation = Rotation3::from_matrix_unchecked(base.rotation);
            let (roll, pitch, yaw) = rotation.euler_angles();
            Vector3::new(roll, pitch, yaw)
        });
        let linear = self.v.iter().map(|v| three(v, 0));
        let angular = self.v.iter().map(|v| three(v, 3));
        let mut figure = Figure::new(String::new());
        if !self.is_empty() {
            figure = figure
                .panel("base, m", joints(["x", "y", "z"], &self.t, positions))
                .panel(
                    "base, rad",
                    joints(["roll", "pitch", "yaw"], &self.t, angles),
                )
                .panel("base, m/s", joints(["vx", "vy", "vz"], &self.t, linear))
                .panel("base, rad/s", joints(["wx", "wy", "wz"], &self.t, angular));
        }
        let tail = |list: &[SVector<f64, V>]| {
            let of_joints = list.iter().map(|v| SVector::from_fn(|i, _| v[6 + i]));
            of_joints.collect::<Vec<_>>()
        };
        let run = Trajectory {
            t: self.t.clone(),
            q: self.q.clone(),
            qd: tail(&self.v),
            qdd: tail(&self.a),
            tau: tail(&self.tau),
            work: self.work,
        };
        let figure = of_joints(figure, robot.joint_names(), &robot.table().rows, &run);
        let places = self.base.iter().zip(&self.q).zip(&self.v);
        let energies = places
            .map(|((base, q), v)| robot.energies_on(base, q, v))
            .collect();
        with_energies(figure, &self.t, energies)
    }
}
