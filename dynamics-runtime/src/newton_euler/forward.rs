//! Forward dynamics: M by composite bodies, V + G + F by the recursion, and one factorisation.

use nalgebra::{SMatrix, SVector};

use super::NewtonEuler;
use crate::{Conditioning, SingularMassMatrix};

impl<const N: usize> NewtonEuler<N> {
    /// Joint accelerations qdd of `M qdd + V + G + F = tau`; `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M is not positive definite to working precision, or holds a
    /// NaN.
    pub fn forward_dynamics(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        let joints = self.joints(q);
        let bias = self.recursion(&joints, qd, &SVector::zeros(), &self.gravity);
        let available = tau - bias - self.friction_vector(qd);
        solve(self.composite_bodies(&joints), available)
    }

    /// How near M(q) is to singular: which joint, and how many digits accelerations lose there.
    pub fn conditioning(&self, q: &SVector<f64, N>) -> Conditioning {
        Conditioning::of(&self.mass_matrix(q))
    }
}

/// Solves `M x = b` by `M = L^T D L` with a unit lower triangle L, from the last row upwards
/// (Featherstone 2008, table 6.3): each pivot is the inertia that a joint feels with the joints
/// beyond it free.
#[inline]
pub(crate) fn solve<const N: usize>(
    mut m: SMatrix<f64, N, N>,
    b: SVector<f64, N>,
) -> Result<SVector<f64, N>, SingularMassMatrix> {
    let mut inverse_pivots = [0.0; N];
    let diagonal = m.diagonal();
    for k in (0..N).rev() {
        let pivot = m[(k, k)];
        SingularMassMatrix::test(k, pivot, diagonal[k])?;
        inverse_pivots[k] = 1.0 / pivot;
        for i in (0..k).rev() {
            let factor = m[(k, i)] * inverse_pivots[k];
            for j in 0..=i {
                m[(i, j)] -= factor * m[(k, j)];
            }
            m[(k, i)] = factor;
        }
    }

    let mut x = b;
    for k in (0..N).rev() {
        for i in 0..k {
            x[i] -= m[(k, i)] * x[k];
        }
    }
    for k in 0..N {
        x[k] *= inverse_pivots[k];
        for i in 0..k {
            x[k] -= m[(k, i)] * x[i];
        }
    }
    Ok(x)
}
