//! Arms in positions and momenta, from their mass matrix and inverse dynamics.

use nalgebra::{Const, SMatrix, SVector};

use crate::dual::Dual;
use crate::{InverseDynamics, MassMatrix, SizedMomenta};

impl<R: MassMatrix<N> + InverseDynamics<N>, const N: usize> SizedMomenta<Const<N>> for R {
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
