//! Energies, from the links' velocities and places.

use nalgebra::{SVector, Vector3};

use super::NewtonEuler;
use crate::JointType;

impl<const N: usize> NewtonEuler<N> {
    /// Kinetic energy, the sum of 1/2 m v_c^2 + 1/2 w.I w over the links and of 1/2 J qd^2 over
    /// the reflected inertias.
    ///
    /// Velocities go outwards by Craig (5.45) to (5.48):
    /// `w_{i+1} = R w_i + qd z`, `v_{i+1} = R (v_i + w_i x p)` for a revolute joint,
    /// `w_{i+1} = R w_i`, `v_{i+1} = R (v_i + w_i x p) + qd z` for a prismatic one.
    pub fn kinetic_energy(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> f64 {
        if let Some(coupled) = &self.coupled {
            return coupled.kinetic_energy(q, qd);
        }
        let joints = self.joints(q);
        let mut energy = 0.0;
        let mut angular = Vector3::<f64>::zeros();
        let mut linear = Vector3::zeros();
        for (i, link) in self.links().iter().enumerate() {
            linear = joints[i].outward(&(linear + angular.cross(&joints[i].origin)));
            angular = joints[i].outward(&angular);
            match link.joint_type {
                JointType::Revolute => angular.z += qd[i],
                JointType::Prismatic => linear.z += qd[i],
            }
            let centre: Vector3<f64> = linear + angular.cross(&link.com);
            energy += link.mass * centre.norm_squared()
                + angular.dot(&(link.tensor * angular))
                + link.reflected_inertia * qd[i] * qd[i];
        }
        0.5 * energy
    }

    /// Potential energy of gravity and springs, U = -sum m g.c + sum 1/2 stiffness (q - rest)^2. That of gravity is
    /// zero if all centres of mass are at the world's origin.
    pub fn potential_energy(&self, q: &SVector<f64, N>) -> f64 {
        if let Some(coupled) = &self.coupled {
            return coupled.potential_energy(q);
        }
        let poses = self.poses_in_world(q);
        let energy = |i: usize| {
            let link = &self.links[i];
            let centre = poses[i].rotation * link.com + poses[i].position;
            link.spring.energy(q[i]) - link.mass * self.world_gravity.dot(&centre)
        };
        (0..self.rows()).map(energy).sum()
    }
}
