//! Forward dynamics: M by composite bodies, V + G + K + F by the recursion, and one factorisation.

use super::NumericArm;
use crate::factorisation::solve;
use crate::size::Size;
use crate::{Conditioning, SingularMassMatrix};

impl<D: Size> NumericArm<D> {
    /// Joint accelerations qdd of `M qdd + V + G + K + F = tau`; `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M is not positive definite to working precision, or holds a
    /// NaN.
    pub fn forward_dynamics(
        &self,
        q: &D::Vector,
        qd: &D::Vector,
        tau: &D::Vector,
    ) -> Result<D::Vector, SingularMassMatrix> {
        self.at(q, |joints| {
            let bias = self.recursion(joints, qd, &self.size.vector(), &self.gravity);
            let available = tau.clone() - bias - self.joint_forces(q, qd);
            solve(self.composite_bodies(joints), &available)
        })
    }

    /// How near M(q) is to singular: which joint, and how many digits accelerations lose there.
    pub fn conditioning(&self, q: &D::Vector) -> Conditioning {
        Conditioning::of_joints(self.dof(), &self.mass_matrix(q))
    }
}
