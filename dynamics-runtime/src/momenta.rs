//! Arms in positions and momenta, from their mass matrix and inverse dynamics.

use nalgebra::SVector;

use crate::dual::Dual;
use crate::factorisation::solve;
use crate::{InverseDynamics, MassMatrix, Momenta, SingularMassMatrix};

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
        let (mut m, mut p) = (self.mass_matrix(q), *p);
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
