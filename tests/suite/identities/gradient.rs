//! Exact derivatives of the mass matrix.

use robot_dynamics::nalgebra::{SMatrix, SVector};

use super::any_arm::AnyArm;
use super::samples::along;

/// dM/dt along the velocity `qd`.
pub(super) fn mass_matrix_rate<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
    q: &SVector<f64, N>,
    qd: &SVector<f64, N>,
) -> SMatrix<f64, N, N> {
    robot.mass_matrix(&along(q, qd)).map(|m| m.eps)
}

/// dM/dq_k for each joint k.
pub(super) fn mass_matrix_gradient<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
    q: &SVector<f64, N>,
) -> [SMatrix<f64, N, N>; N] {
    std::array::from_fn(|k| mass_matrix_rate(robot, q, &unit(k)))
}

/// The unit vector of joint `k`.
pub(super) fn unit<const N: usize>(k: usize) -> SVector<f64, N> {
    SVector::from_fn(|i, _| if i == k { 1.0 } else { 0.0 })
}
