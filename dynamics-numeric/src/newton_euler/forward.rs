//! Forward dynamics: M by composite bodies, V + G + K + F by the recursion, and one factorisation.

use dynamics_runtime::internal::solve;
use dynamics_runtime::{Conditioning, SingularMassMatrix, Size};

use super::{Placed, base};

impl<D: Size, V: Size> Placed<'_, '_, D, V> {
    pub(crate) fn forward_dynamics(
        &self,
        q: &D::Vector,
        qd: &V::Vector,
        tau: &V::Vector,
    ) -> Result<V::Vector, SingularMassMatrix> {
        let (arm, gravity) = (self.arm, &self.base.gravity);
        let accelerations = arm.at(q, |joints| {
            let bias = arm.forces(joints, [qd, &arm.freedoms.vector()], gravity);
            let available = tau.clone() - bias - arm.joint_forces(q, qd);
            solve(arm.composite_bodies(joints), &available)
        });
        accelerations.map_err(|error| self.named(error))
    }

    /// Says which number of a base that moves it is.
    pub(super) fn named(&self, error: SingularMassMatrix) -> SingularMassMatrix {
        if self.arm.floats() {
            base::named(error)
        } else {
            error
        }
    }

    pub(crate) fn conditioning(&self, q: &D::Vector) -> Conditioning {
        Conditioning::of_joints(self.arm.dof(), &self.mass_matrix(q))
    }
}
