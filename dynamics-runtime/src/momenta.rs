//! Arms in positions and momenta, from their mass matrix and inverse dynamics.

use nalgebra::{Const, SMatrix, SVector};

use crate::dual::Dual;
use crate::size::{JointVector as _, Size};
use crate::{InverseDynamics, MassMatrix, NumericArm, SizedMomenta};

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

impl<D: Size> SizedMomenta<D> for NumericArm<D> {
    fn inertia(&self, q: &D::Vector) -> D::Matrix {
        self.mass_matrix(q)
    }

    /// With C of the Christoffel symbols, dT/dq = C' qd.
    fn force(&self, q: &D::Vector, qd: &D::Vector, tau: &D::Vector) -> D::Vector {
        let (coriolis, size) = (self.coriolis_matrix(q, qd), D::of(q));
        let of_kinetic_energy =
            size.vector_of(|j| size.joints().map(|i| coriolis[(i, j)] * qd[i]).sum());
        let potential = self.gravity_vector(q) + self.spring_vector(q);
        tau.plus(1.0, &of_kinetic_energy) - potential - self.friction_vector(qd)
    }
}
