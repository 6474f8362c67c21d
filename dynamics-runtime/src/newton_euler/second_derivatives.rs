//! Second derivatives of the joint torques, by differences that are no approximation.
//!
//! The derivatives of tau by positions are polynomials of the same degrees as tau itself, and so are M and C.

use super::NumericArm;
use crate::size::{Size, SizedSecondDerivatives};

impl<D: Size> NumericArm<D> {
    /// d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq of the inverse dynamics. Entry `[i][(j, k)]` is
    /// the derivative of tau_i by q_j and q_k, by qd_j and qd_k, by q_j and qd_k, and that of M_ij by q_k.
    ///
    /// Friction that falls with the velocity is on the diagonal of d2 tau/dqd dqd; that of other friction
    /// and of springs is zero.
    pub fn inverse_dynamics_second_derivatives(
        &self,
        q: &D::Vector,
        qd: &D::Vector,
        qdd: &D::Vector,
    ) -> SizedSecondDerivatives<D> {
        let (joints, dof) = (self.joints(q), self.dof());
        let none = || self.size.each(|_| self.size.matrix());
        let mut all = (none(), none(), none(), none());
        // C = 1/2 dV/dqd, and its entries at a unit velocity of one joint are the symbols of Christoffel.
        self.walk_outward(|place| {
            let (k, joint, factor) = (place.k, place.joint, place.factor);
            let by_position = self.slope(&joints, k, |joints| self.slopes(joints, qd, qdd));
            let by_both = self.slope(&joints, k, |joints| self.coriolis_matrix_of(joints, qd));
            let of_inertia = self.slope(&joints, k, |joints| self.composite_bodies(joints));
            for i in 0..dof {
                for j in 0..dof {
                    all.0[i][(j, joint)] += factor * by_position[(i, j)];
                    all.2[i][(joint, j)] += factor * 2.0 * by_both[(i, j)];
                    all.3[i][(j, joint)] += factor * of_inertia[(i, j)];
                }
            }
            let curvature = factor * factor * factor * place.link.dry.curvature(place.of(qd));
            all.1[joint][(joint, joint)] += curvature;
        });
        for k in 0..dof {
            let mut unit = self.size.vector();
            unit[k] = 1.0;
            let by_velocity = self.coriolis_matrix_of(&joints, &unit);
            for i in 0..dof {
                for j in 0..dof {
                    all.1[i][(j, k)] += 2.0 * by_velocity[(i, j)];
                }
            }
        }
        all
    }
}
