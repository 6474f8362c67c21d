//! Forward dynamics: M by composite bodies, V + G + K + F by the recursion, and one factorisation.

use nalgebra::SVector;

use super::NewtonEuler;
use crate::factorisation::solve;
use crate::{Conditioning, SingularMassMatrix};

impl<const N: usize> NewtonEuler<N> {
    /// Joint accelerations qdd of `M qdd + V + G + K + F = tau`; `tau` in N m or N.
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
        if self.coupled.is_some() {
            return solve(self.mass_matrix(q), &(tau - self.bias_force(q, qd)));
        }
        let joints = self.joints(q);
        let bias = self.recursion(&joints, qd, &SVector::zeros(), &self.gravity);
        let available = tau - bias - self.joint_forces(q, qd);
        solve(self.composite_bodies(&joints), &available)
    }

    /// How near M(q) is to singular: which joint, and how many digits accelerations lose there.
    pub fn conditioning(&self, q: &SVector<f64, N>) -> Conditioning {
        Conditioning::of(&self.mass_matrix(q))
    }
}
