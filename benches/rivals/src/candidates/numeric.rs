//! The runtime's own numeric algorithms: recursive Newton-Euler, composite bodies, factorisation.

use robot_dynamics::NewtonEuler;
use robot_dynamics::nalgebra::{SMatrix, SVector};

use super::Candidate;

impl<const N: usize> Candidate<N> for NewtonEuler<N> {
    const NAME: &'static str = "numeric";

    fn inverse_dynamics(
        &mut self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> SVector<f64, N> {
        NewtonEuler::inverse_dynamics(self, q, qd, qdd)
    }

    fn mass_matrix(&mut self, q: &SVector<f64, N>) -> SMatrix<f64, N, N> {
        NewtonEuler::mass_matrix(self, q)
    }

    fn coriolis_vector(&mut self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SVector<f64, N> {
        NewtonEuler::coriolis_vector(self, q, qd)
    }

    fn gravity_vector(&mut self, q: &SVector<f64, N>) -> SVector<f64, N> {
        NewtonEuler::gravity_vector(self, q)
    }

    fn forward_dynamics(
        &mut self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Option<SVector<f64, N>> {
        NewtonEuler::forward_dynamics(self, q, qd, tau).ok()
    }
}
