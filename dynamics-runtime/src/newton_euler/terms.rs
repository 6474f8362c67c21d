//! The terms of `tau = M qdd + V + G + K + F`, each by its shortest recursion.

use nalgebra::Vector3;

use super::NumericArm;
use super::joint::Joint;
use super::walk::Place;
use crate::size::{JointVector as _, Size};

impl<D: Size> NumericArm<D> {
    /// Mass matrix M(q), both triangles: column j is the torque of a unit acceleration of joint j,
    /// at rest and without gravity. Reflected inertias are on the diagonal.
    pub fn mass_matrix(&self, q: &D::Vector) -> D::Matrix {
        self.at(q, |joints| self.composite_bodies(joints))
    }

    /// Coriolis and centrifugal torques V(q, qd): no acceleration, no gravity.
    pub fn coriolis_vector(&self, q: &D::Vector, qd: &D::Vector) -> D::Vector {
        self.at(q, |joints| self.velocity_torques(joints, qd))
    }

    /// Gravity torques G(q): no velocity, no acceleration, no springs.
    pub fn gravity_vector(&self, q: &D::Vector) -> D::Vector {
        self.at(q, |joints| self.weights(joints))
    }

    /// Friction torques F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), sign(0) = 0, with C
    /// that of the direction.
    pub fn friction_vector(&self, qd: &D::Vector) -> D::Vector {
        self.gathered(|place| place.link.friction(place.of(qd)))
    }

    /// Spring torques K(q) = stiffness (q - rest).
    pub fn spring_vector(&self, q: &D::Vector) -> D::Vector {
        self.gathered(|place| place.link.spring.force(place.position(q)))
    }

    /// Torques of a motion, M qdd + V + G + K + F.
    pub fn inverse_dynamics(&self, q: &D::Vector, qd: &D::Vector, qdd: &D::Vector) -> D::Vector {
        let tau = self.at(q, |joints| self.recursion(joints, qd, qdd, &self.gravity));
        tau + self.joint_forces(q, qd)
    }

    /// Torques without acceleration, V + G + K + F.
    pub fn bias_force(&self, q: &D::Vector, qd: &D::Vector) -> D::Vector {
        self.inverse_dynamics(q, qd, &self.size.vector())
    }

    /// Coriolis matrix C(q, qd) of the Christoffel symbols of the first kind, so that V = C qd and
    /// Mdot - 2 C is skew.
    ///
    /// With these symbols C = 1/2 dV/dqd. V is quadratic in qd, so its central difference over any
    /// distance h is the derivative itself: `C e_j = (V(qd + h e_j) - V(qd - h e_j)) / (4 h)`. The
    /// greatest speed is taken for h, which keeps rounding at the scale of C.
    pub fn coriolis_matrix(&self, q: &D::Vector, qd: &D::Vector) -> D::Matrix {
        self.at(q, |joints| self.coriolis_matrix_of(joints, qd))
    }

    /// C where the joints are so.
    pub(super) fn coriolis_matrix_of(&self, joints: &D::Links<Joint>, qd: &D::Vector) -> D::Matrix {
        let mut coriolis_matrix = self.size.matrix();
        let h = qd.largest();
        if h == 0.0 {
            return coriolis_matrix;
        }
        for j in 0..self.dof() {
            let moved = |distance: f64| {
                let mut qd = qd.clone();
                qd[j] += distance;
                self.velocity_torques(joints, &qd)
            };
            let difference = moved(h) - moved(-h);
            for i in 0..self.dof() {
                coriolis_matrix[(i, j)] = difference[i] / (4.0 * h);
            }
        }
        coriolis_matrix
    }

    /// V where the joints are so.
    #[inline(always)]
    fn velocity_torques(&self, joints: &D::Links<Joint>, qd: &D::Vector) -> D::Vector {
        self.recursion(joints, qd, &self.size.vector(), &Vector3::zeros())
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
