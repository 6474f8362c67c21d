//! The numeric arm in positions and momenta.

use dynamics_runtime::{JointVector as _, Size, SizedMomenta};

use crate::NumericArm;

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
