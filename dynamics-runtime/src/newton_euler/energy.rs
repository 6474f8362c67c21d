//! Energies, from the links' velocities and places.

use nalgebra::Vector3;

use super::NumericArm;
use super::link::Link;
use crate::JointType;
use crate::size::Size;

impl<D: Size> NumericArm<D> {
    /// Kinetic energy, the sum of 1/2 m v_c^2 + 1/2 w.I w over the links and of 1/2 J qd^2 over
    /// the reflected inertias.
    ///
    /// Velocities go outwards by Craig (5.45) to (5.48):
    /// `w_{i+1} = R w_i + qd z`, `v_{i+1} = R (v_i + w_i x p)` for a revolute joint,
    /// `w_{i+1} = R w_i`, `v_{i+1} = R (v_i + w_i x p) + qd z` for a prismatic one.
    pub fn kinetic_energy(&self, q: &D::Vector, qd: &D::Vector) -> f64 {
        let joints = self.joints(q);
        let rest = [Vector3::zeros(); 2];
        let velocities = self.outward(rest, |k, link, [angular, linear]| {
            let moved: Vector3<f64> = linear + angular.cross(&joints[k].origin);
            let mut linear = joints[k].outward(&moved);
            let mut angular = joints[k].outward(angular);
            match link.joint_type {
                JointType::Revolute => angular.z += link.of(qd),
                JointType::Prismatic => linear.z += link.of(qd),
            }
            [angular, linear]
        });
        let energy = |(k, link): (usize, &Link)| {
            let ([angular, linear], rate) = (velocities[k], link.of(qd));
            let centre: Vector3<f64> = linear + angular.cross(&link.com);
            link.mass * centre.norm_squared()
                + angular.dot(&(link.tensor * angular))
                + link.reflected_inertia * rate * rate
        };
        0.5 * self.links().map(energy).sum::<f64>()
    }

    /// Potential energy of gravity and springs, U = -sum m g.c + sum 1/2 stiffness (q - rest)^2. That of gravity is
    /// zero if all centres of mass are at the world's origin.
    pub fn potential_energy(&self, q: &D::Vector) -> f64 {
        let poses = self.poses_in_world(q);
        let energy = |(k, link): (usize, &Link)| {
            let centre = poses[k].rotation * link.com + poses[k].position;
            link.spring.energy(link.of(q)) - link.mass * self.world_gravity.dot(&centre)
        };
        self.links().map(energy).sum()
    }
}
