//! Energies, from the links' velocities and places.

use dynamics_runtime::{JointType, Size};
use nalgebra::Vector3;

use super::Placed;
use super::base::twist;

impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    /// Velocities go outwards by Craig (5.45) to (5.48):
    /// `w_{i+1} = R w_i + qd z`, `v_{i+1} = R (v_i + w_i x p)` for a revolute joint,
    /// `w_{i+1} = R w_i`, `v_{i+1} = R (v_i + w_i x p) + qd z` for a prismatic one.
    pub(crate) fn kinetic_energy(&self, q: &D::Vector, qd: &V::Vector) -> f64 {
        let (mut energy, mut base) = (0.0, [Vector3::zeros(); 2]);
        if let Some(body) = self.arm.body() {
            let [linear, angular] = twist(qd);
            let centre = linear + angular.cross(&body.solid.com);
            energy = body.solid.mass * centre.norm_squared()
                + angular.dot(&(body.solid.tensor * angular));
            base = [angular, linear];
        }
        self.arm.at(q, |joints| {
            self.arm.outward(
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
                    let centre: Vector3<f64> = linear + angular.cross(&link.solid.com);
                    energy += link.solid.mass * centre.norm_squared()
                        + angular.dot(&(link.solid.tensor * angular))
                        + link.reflected_inertia * rate * rate;
                    [angular, linear]
                },
            );
        });
        0.5 * energy
    }

    pub(crate) fn potential_energy(&self, q: &D::Vector) -> f64 {
        let (place, gravity) = (self.base.place, &self.arm.world_gravity);
        let mut energy = 0.0;
        if let Some(body) = self.arm.body() {
            energy -=
                body.solid.mass * gravity.dot(&(place.rotation * body.solid.com + place.position));
        }
        self.arm.at(q, |joints| {
            self.arm.outward(place, |place, before| {
                let (link, pose) = (place.link, before.then(&joints[place.k].pose()));
                let centre = pose.rotation * link.solid.com + pose.position;
                energy +=
                    link.spring.energy(place.position(q)) - link.solid.mass * gravity.dot(&centre);
                pose
            });
        });
        energy
    }
}
