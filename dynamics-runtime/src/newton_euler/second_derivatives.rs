//! Second derivatives of the joint torques, by differences that are no approximation.
//!
//! The derivatives of tau by positions are polynomials of the same degrees as tau itself, and so are M and C.

use nalgebra::{SMatrix, SVector};

use super::NewtonEuler;
use super::joint::Joint;
use super::sum::Sum;
use crate::SecondDerivatives;

impl<const N: usize> NewtonEuler<N> {
    /// d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq of the inverse dynamics. Entry `[i][(j, k)]` is
    /// the derivative of tau_i by q_j and q_k, by qd_j and qd_k, by q_j and qd_k, and that of M_ij by q_k.
    ///
    /// Friction that falls with the velocity is on the diagonal of d2 tau/dqd dqd; that of other friction
    /// and of springs is zero.
    pub fn inverse_dynamics_second_derivatives(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        qdd: &SVector<f64, N>,
    ) -> SecondDerivatives<f64, N> {
        if let Some(coupled) = &self.coupled {
            return coupled.second_derivatives(q, qd, qdd);
        }
        let joints = self.joints(q);
        let mut all = Sum::default();
        for k in 0..self.rows() {
            all.add(k, 1.0, self.slopes_by(k, &joints, [qd, qdd]));
            all.0.1[k][(k, k)] += self.links[k].dry.curvature(qd[k]);
        }
        all.0
    }

    /// By joint k: d2 tau/dq dq_k, d2 V/dqd dqd_k, d2 V/dqd dq_k and dM/dq_k.
    pub(super) fn slopes_by(
        &self,
        k: usize,
        joints: &[Joint; N],
        [qd, qdd]: [&SVector<f64, N>; 2],
    ) -> [SMatrix<f64, N, N>; 4] {
        let mut unit = SVector::zeros();
        unit[k] = 1.0;
        // C = 1/2 dV/dqd, and its entries at a unit velocity of one joint are the symbols of Christoffel.
        [
            self.slope(joints, k, |joints| self.slopes(joints, qd, qdd)),
            self.coriolis_matrix_of(joints, &unit) * 2.0,
            self.slope(joints, k, |joints| self.coriolis_matrix_of(joints, qd)) * 2.0,
            self.slope(joints, k, |joints| self.composite_bodies(joints)),
        ]
    }

    /// d2F/dqd2 of the joint of row k.
    pub(super) fn curvature_of_friction(&self, k: usize, qd: f64) -> f64 {
        self.links[k].dry.curvature(qd)
    }
}
