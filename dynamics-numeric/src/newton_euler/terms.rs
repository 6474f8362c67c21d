//! The terms of `tau = M qdd + V + G + K + F`, each by its shortest recursion.

use dynamics_runtime::Size;

use super::walk::Place;
use super::{NumericArm, Placed};

impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    pub(crate) fn mass_matrix(&self, q: &D::Vector) -> V::Matrix {
        self.arm.at(q, |joints| self.arm.composite_bodies(joints))
    }

    pub(crate) fn coriolis_vector(&self, q: &D::Vector, qd: &V::Vector) -> V::Vector {
        self.arm
            .at(q, |joints| self.arm.velocity_forces(joints, qd))
    }

    pub(crate) fn gravity_vector(&self, q: &D::Vector) -> V::Vector {
        let gravity = &self.base.gravity;
        self.arm.at(q, |joints| self.arm.weights(joints, gravity))
    }

    /// F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), sign(0) = 0, with C that of the direction.
    pub(crate) fn friction_vector(&self, qd: &V::Vector) -> V::Vector {
        self.arm.gathered(|place| place.link.friction(place.of(qd)))
    }

    /// K(q) = stiffness (q - rest).
    pub(crate) fn spring_vector(&self, q: &D::Vector) -> V::Vector {
        self.arm
            .gathered(|place| place.link.spring.force(place.position(q)))
    }

    pub(crate) fn inverse_dynamics(
        &self,
        q: &D::Vector,
        qd: &V::Vector,
        qdd: &V::Vector,
    ) -> V::Vector {
        let gravity = &self.base.gravity;
        let tau = self
            .arm
            .at(q, |joints| self.arm.forces(joints, [qd, qdd], gravity));
        tau + self.arm.joint_forces(q, qd)
    }

    pub(crate) fn bias_force(&self, q: &D::Vector, qd: &V::Vector) -> V::Vector {
        self.inverse_dynamics(q, qd, &self.arm.freedoms.vector())
    }
}

impl<D: Size, V: Size> NumericArm<D, V> {
    /// K + F, what acts at the joints themselves.
    pub(super) fn joint_forces(&self, q: &D::Vector, qd: &V::Vector) -> V::Vector {
        self.gathered(|place| {
            place.link.spring.force(place.position(q)) + place.link.friction(place.of(qd))
        })
    }

    /// Forces at the joints of all links, as forces at the joints of q. A force f on a follower that moves k times as far
    /// as its leader is k f at the leader.
    #[inline(always)]
    pub(super) fn gathered(&self, force: impl Fn(&Place<'_>) -> f64) -> V::Vector {
        let mut sum = self.freedoms.vector();
        self.walk_outward(
            #[inline(always)]
            |place| place.add(&mut sum, force(&place)),
        );
        sum
    }
}
