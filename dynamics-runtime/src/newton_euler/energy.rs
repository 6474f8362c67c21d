//! Energies, from the links' velocities and places.

use nalgebra::Vector3;

use super::NumericArm;
use super::pose::Pose;
use crate::JointType;
use crate::size::Size;

impl<D: Size> NumericArm<D> {
    /// Kinetic energy, the sum of 1/2 m v_c^2 + 1/2 w.I w over the links and of 1/2 J qd^2 over
    /// the reflected inertias.
    pub fn kinetic_energy(&self, q: &D::Vector, qd: &D::Vector) -> f64 {
        self.energy_of_motion(q, qd, [Vector3::zeros(); 2])
    }

    /// Potential energy of gravity and springs, U = -sum m g.c + sum 1/2 stiffness (q - rest)^2. The energy of
    /// gravity is zero if all centres of mass are at the world's origin.
    pub fn potential_energy(&self, q: &D::Vector) -> f64 {
        self.energy_of_place(q, &self.base)
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// Kinetic energy of the links on a base with this angular and linear velocity.
    ///
    /// Velocities go outwards by Craig (5.45) to (5.48):
    /// `w_{i+1} = R w_i + qd z`, `v_{i+1} = R (v_i + w_i x p)` for a revolute joint,
    /// `w_{i+1} = R w_i`, `v_{i+1} = R (v_i + w_i x p) + qd z` for a prismatic one.
    #[inline(always)]
    pub(super) fn energy_of_motion(
        &self,
        q: &D::Vector,
        qd: &V::Vector,
        base: [Vector3<f64>; 2],
    ) -> f64 {
        let mut energy = 0.0;
        self.at(q, |joints| {
            self.outward(
                base,
                #[inline(always)]
                |place, [angular, linear]| {
                    let (link, joint, rate) = (place.link, &joints[place.k], place.of(qd));
                    let moved: Vector3<f64> = linear + angular.cross(&joint.origin);
                    let (mut linear, mut angular) = (joint.outward(&moved), joint.outward(angular));
                    match link.joint_type {
                        JointType::Revolute => angular.z += rate,
                        JointType::Prismatic => linear.z += rate,
                    }
                    let centre: Vector3<f64> = linear + angular.cross(&link.com);
                    energy += link.mass * centre.norm_squared()
                        + angular.dot(&(link.tensor * angular))
                        + link.reflected_inertia * rate * rate;
                    [angular, linear]
                },
            );
        });
        0.5 * energy
    }

    /// Potential energy of the links and of the springs on a base at this place.
    #[inline(always)]
    pub(super) fn energy_of_place(&self, q: &D::Vector, base: &Pose) -> f64 {
        let mut energy = 0.0;
        self.at(q, |joints| {
            self.outward(*base, |place, before| {
                let (link, pose) = (place.link, before.then(&joints[place.k].pose()));
                let centre = pose.rotation * link.com + pose.position;
                energy += link.spring.energy(place.position(q))
                    - link.mass * self.world_gravity.dot(&centre);
                pose
            });
        });
        energy
    }
}
