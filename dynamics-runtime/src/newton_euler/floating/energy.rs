//! Energies and momenta.

use super::{NumericFloating, twist};
use crate::Pose;
use crate::size::{JointMatrix as _, Size};

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// Kinetic energy, the sum of 1/2 m v_c^2 + 1/2 w.I w over the bodies and of 1/2 J qd^2 over the reflected inertias, J.
    /// It holds no coordinate of the base.
    pub fn kinetic_energy(&self, q: &D::Vector, v: &V::Vector) -> f64 {
        let ([linear, angular], body) = (twist::<V>(v), &self.body);
        let centre = linear + angular.cross(&body.com);
        let own = body.mass * centre.norm_squared() + angular.dot(&(body.tensor * angular));
        0.5 * own + self.arm.energy_of_motion(q, v, [angular, linear])
    }

    /// Potential energy of gravity and springs, U = -sum m g.c + sum 1/2 stiffness (q - rest)^2, J. The energy of gravity is
    /// zero if all centres of mass are at the world's origin.
    pub fn potential_energy(&self, base: &Pose<f64>, q: &D::Vector) -> f64 {
        let centre = base.rotation * self.body.com + base.position;
        let own = self.body.mass * self.arm.world_gravity.dot(&centre);
        self.arm.energy_of_place(q, &base.into()) - own
    }

    /// Generalized momentum p = M v: linear and angular momentum of all bodies about the origin of the base's frame, in the
    /// axes of the base, then the momenta of the joints.
    pub fn generalized_momentum(&self, q: &D::Vector, v: &V::Vector) -> V::Vector {
        self.mass_matrix(q).times(v)
    }

    /// Rate of the generalized momentum without applied forces, C' v - G - K - F, with the C of
    /// [`coriolis_matrix`](Self::coriolis_matrix): d(M v)/dt is the sum of it and tau.
    pub fn momentum_bias(&self, base: &Pose<f64>, q: &D::Vector, v: &V::Vector) -> V::Vector {
        let (coriolis, size) = (self.coriolis_matrix(q, v), self.arm.freedoms);
        let of_velocity = size.vector_of(|j| size.joints().map(|i| coriolis[(i, j)] * v[i]).sum());
        of_velocity - self.gravity_vector(base, q) - self.arm.joint_forces(q, v)
    }
}
