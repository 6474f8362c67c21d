//! Arms in positions and momenta, from their mass matrix and inverse dynamics.

use nalgebra::{SMatrix, SVector};

use crate::dual::Dual;
use crate::factorisation::solve;
use crate::{InverseDynamics, MassMatrix, Momenta, NewtonEuler, SingularMassMatrix};

/// M_ff qd_f = p_f, where the joints that stand still have no velocity.
fn velocity_beside<const N: usize>(
    mut m: SMatrix<f64, N, N>,
    still: &[bool; N],
    p: &SVector<f64, N>,
) -> Result<SVector<f64, N>, SingularMassMatrix> {
    let mut p = *p;
    // Their rows and columns are those of the unit matrix.
    for i in (0..N).filter(|i| still[*i]) {
        m.row_mut(i).fill(0.0);
        m.column_mut(i).fill(0.0);
        m[(i, i)] = 1.0;
        p[i] = 0.0;
    }
    let qd = solve(m, &p)?;
    Ok(SVector::from_fn(|i, _| if still[i] { 0.0 } else { qd[i] }))
}

impl<R: MassMatrix<N> + InverseDynamics<N>, const N: usize> Momenta<N> for R {
    fn momentum(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SVector<f64, N> {
        self.mass_matrix(q) * qd
    }

    fn velocity(
        &self,
        q: &SVector<f64, N>,
        p: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        solve(self.mass_matrix(q), p)
    }

    fn velocity_beside(
        &self,
        still: &[bool; N],
        q: &SVector<f64, N>,
        p: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        velocity_beside(self.mass_matrix(q), still, p)
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
    fn momentum(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SVector<f64, N> {
        self.mass_matrix(q) * qd
    }

    fn velocity(
        &self,
        q: &SVector<f64, N>,
        p: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        solve(self.mass_matrix(q), p)
    }

    fn velocity_beside(
        &self,
        still: &[bool; N],
        q: &SVector<f64, N>,
        p: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        velocity_beside(self.mass_matrix(q), still, p)
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
