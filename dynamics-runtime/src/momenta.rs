//! Equations of motion in positions and momenta.

use nalgebra::SVector;

use crate::dual::Dual;
use crate::newton_euler::solve;
use crate::{InverseDynamics, MassMatrix, SingularMassMatrix};

/// An arm in positions q and momenta p = M(q) qd, as Hamilton has it: what the structure-preserving
/// methods of a [`Simulation`](crate::Simulation) need.
///
/// Every arm with `mass_matrix` and `inverse_dynamics` is one. With T the kinetic energy,
///
/// `q' = M^-1 p`, `p' = dT/dq - G - F + tau`, `dT/dq = C' qd = M' qd - V`,
///
/// where C is the Coriolis matrix of the Christoffel symbols and M' qd is the change of momentum at
/// constant velocity: M along a dual number gives it without C (`M' = C + C'` and `V = C qd`).
pub trait Momenta<const N: usize> {
    /// p = M(q) qd, kg m^2/s or kg m/s.
    fn momentum(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> SVector<f64, N>;

    /// qd = M(q)^-1 p.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision.
    fn velocity(
        &self,
        q: &SVector<f64, N>,
        p: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix>;

    /// The velocities of an arm some joints of which stand still: theirs are exactly zero, and of
    /// the others M_ff qd_f = p_f, with the rows and columns of those that move alone. The momenta
    /// of the joints that stand still are not read.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M_ff is not positive definite to working precision.
    fn velocity_beside(
        &self,
        still: &[bool; N],
        q: &SVector<f64, N>,
        p: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix>;

    /// p' = dT/dq - G - F + tau at the velocity `qd`, N m or N.
    fn force(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> SVector<f64, N>;
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
        solve(self.mass_matrix(q), *p)
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
        let qd = solve(m, p)?;
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
