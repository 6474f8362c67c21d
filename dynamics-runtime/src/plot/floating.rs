//! A run on a base that moves as a figure.

use std::path::Path;

use nalgebra::{Rotation3, Vector3};

use super::run::{of_joints, with_energies, with_joints};
use super::{Figure, Outcome, joints};
use crate::simulation::{OnBase, SizedFloatingTrajectory, SizedModel};
use crate::size::Size;
use crate::table::AsArm as _;

impl<D: Size, V: Size> SizedFloatingTrajectory<D, V> {
    /// Draws the run into the file, as SVG. The first panels are about the base: its position and its roll,
    /// pitch and yaw in the world, its velocities and the force and moment on it in its own axes. The panels
    /// of the joints and of energies follow, as
    /// [`SizedTrajectory::plot`](crate::simulation::SizedTrajectory::plot) has them.
    ///
    /// # Errors
    ///
    /// Where the file cannot be written, or there is nothing to draw.
    pub fn plot<R>(&self, robot: &R, file: impl AsRef<Path>) -> Outcome
    where
        R: SizedModel<OnBase<D, V>>,
    {
        self.figure(robot).save(file)
    }

    /// The same as a figure without a title, to add panels to.
    pub fn figure<R: SizedModel<OnBase<D, V>>>(&self, robot: &R) -> Figure {
        let three = |v: &V::Vector, first: usize| Vector3::from_fn(|i, _| v[first + i]);
        let positions = self.base.iter().map(|base| base.position);
        let angles = self.base.iter().map(|base| {
            let rotation = Rotation3::from_matrix_unchecked(base.rotation);
            let (roll, pitch, yaw) = rotation.euler_angles();
            Vector3::new(roll, pitch, yaw)
        });
        let of_base = |list: &[V::Vector], first: usize| -> Vec<_> {
            list.iter().map(|v| three(v, first)).collect()
        };
        let mut figure = Figure::new(String::new());
        if !self.is_empty() {
            let (t, v) = (&self.t, &self.v);
            figure = figure
                .panel("base, m", joints(["x", "y", "z"], t, positions))
                .panel("base, rad", joints(["roll", "pitch", "yaw"], t, angles))
                .panel("base, m/s", joints(["vx", "vy", "vz"], t, of_base(v, 0)))
                .panel("base, rad/s", joints(["wx", "wy", "wz"], t, of_base(v, 3)));
        }
        if !self.is_empty() && self.tau.len() == self.len() {
            let (t, tau) = (&self.t, &self.tau);
            figure = figure
                .panel("base, N", joints(["fx", "fy", "fz"], t, of_base(tau, 0)))
                .panel("base, N m", joints(["nx", "ny", "nz"], t, of_base(tau, 3)));
        }
        let [qd, qdd, tau] = [&self.v, &self.a, &self.tau].map(|list| of_joints(list, 6));
        let lists = [of_joints(&self.q, 0), qd, qdd, tau];
        let (names, table) = (robot.names(), robot.sized_table());
        let figure = with_joints(figure, names.as_ref(), table.arm().rows, &self.t, lists);
        let places = self.base.iter().zip(&self.q).zip(&self.v);
        let energies = places
            .map(|((base, q), v)| robot.sized_energies((base, q), v))
            .collect();
        with_energies(figure, &self.t, energies)
    }
}
