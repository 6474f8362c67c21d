//! Arms in positions and momenta, from their mass matrix and inverse dynamics.

use nalgebra::{SMatrix, SVector};

use crate::dual::Dual;
use crate::{InverseDynamics, MassMatrix, Momenta, NewtonEuler};

impl<R: MassMatrix<N> + InverseDynamics<N>, const N: usize> Momenta<N> for R {
    fn inertia(&self, q: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.mass_matrix(q)
    }

    fn force(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let along = SVector::from_fn(|i, _| Dual::new(q[i], qd[i]));
        let mass_rate = self.mass_matrix(&along).map(|entry| entry.slope);
        let bias = self.inverse_dynamics(q, qd, &SVector::zeros());
        tau + mass_rate * qd - bias
    }
}

impl<const N: usize> Momenta<N> for NewtonEuler<N> {
    fn inertia(&self, q: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        self.mass_matrix(q)
    }

    /// With C of the Christoffel symbols, dT/dq = C' qd.
    fn force(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        let of_kinetic_energy = self.coriolis_matrix(q, qd).tr_mul(qd);
        let potential = self.gravity_vector(q) + self.spring_vector(q);
        tau + of_kinetic_energy - potential - self.friction_vector(qd)
    }
}
