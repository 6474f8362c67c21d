//! The terms of `tau = M qdd + V + G + K + F`, each by its shortest recursion.

use nalgebra::{SMatrix, SVector, Vector3};

use super::NewtonEuler;
use super::joint::Joint;

impl<const N: usize> NewtonEuler<N> {
    /// Mass matrix M(q), both triangles: column j is the torque of a unit acceleration of joint j,
    /// at rest and without gravity. Reflected inertias are on the diagonal.
    pub fn mass_matrix(&self, q: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.mass_matrix(q);
        }
        self.composite_bodies(&self.joints(q))
    }

    /// Coriolis and centrifugal torques V(q, qd): no acceleration, no gravity.
    pub fn coriolis_vector(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SVector<f64, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.coriolis_vector(q, qd);
        }
        self.recursion(&self.joints(q), qd, &SVector::zeros(), &Vector3::zeros())
    }

    /// Gravity torques G(q): no velocity, no acceleration, no springs.
    pub fn gravity_vector(&self, q: &SVector<f64, N>) -> SVector<f64, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.gravity_vector(q);
        }
        self.weights(&self.joints(q))
    }

    /// Friction torques F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), sign(0) = 0, with C
    /// that of the direction.
    pub fn friction_vector(&self, qd: &SVector<f64, N>) -> SVector<f64, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.friction_vector(qd);
        }
        SVector::from_fn(|i, _| {
            let link = &self.links[i];
            link.viscous * qd[i] + link.dry.force(qd[i])
        })
    }

    /// Spring torques K(q) = stiffness (q - rest).
    pub fn spring_vector(&self, q: &SVector<f64, N>) -> SVector<f64, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.spring_vector(q);
        }
        SVector::from_fn(|i, _| self.links[i].spring.force(q[i]))
    }

    /// K + F, what acts at the joints themselves.
    pub(super) fn joint_forces(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        self.spring_vector(q) + self.friction_vector(qd)
    }

    /// Torques of a motion, M qdd + V + G + K + F.
    pub fn inverse_dynamics(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.inverse_dynamics(q, qd, qdd);
        }
        self.recursion(&self.joints(q), qd, qdd, &self.gravity) + self.joint_forces(q, qd)
    }

    /// Torques without acceleration, V + G + K + F.
    pub fn bias_force(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SVector<f64, N> {
        self.inverse_dynamics(q, qd, &SVector::zeros())
    }

    /// Coriolis matrix C(q, qd) of the Christoffel symbols of the first kind, so that V = C qd and
    /// Mdot - 2 C is skew.
    ///
    /// With these symbols C = 1/2 dV/dqd. V is quadratic in qd, so its central difference over any
    /// distance h is the derivative itself: `C e_j = (V(qd + h e_j) - V(qd - h e_j)) / (4 h)`. The
    /// greatest speed is taken for h, which keeps rounding at the scale of C.
    pub fn coriolis_matrix(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        christoffel(self.rows(), qd, |qd| self.coriolis_vector(q, &qd))
    }

    /// C where the joints are so, each row a joint of its own.
    pub(super) fn coriolis_matrix_of(
        &self,
        joints: &[Joint; N],
        qd: &SVector<f64, N>,
    ) -> SMatrix<f64, N, N> {
        let still = SVector::zeros();
        christoffel(self.rows(), qd, |qd| {
            self.recursion(joints, &qd, &still, &Vector3::zeros())
        })
    }
}

/// C from V, a quadratic form of the velocities: see [`NewtonEuler::coriolis_matrix`].
fn christoffel<const N: usize>(
    rows: usize,
    qd: &SVector<f64, N>,
    coriolis_vector: impl Fn(SVector<f64, N>) -> SVector<f64, N>,
) -> SMatrix<f64, N, N> {
    let mut coriolis_matrix = SMatrix::<f64, N, N>::zeros();
    let h = qd.amax();
    if h == 0.0 {
        return coriolis_matrix;
    }
    for j in 0..rows {
        let mut distance = SVector::zeros();
        distance[j] = h;
        let difference = coriolis_vector(qd + distance) - coriolis_vector(qd - distance);
        coriolis_matrix.set_column(j, &(difference / (4.0 * h)));
    }
    coriolis_matrix
}
