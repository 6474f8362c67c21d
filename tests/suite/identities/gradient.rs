//! Exact derivatives of the mass matrix.

use robot_dynamics::nalgebra::{DMatrix, DVector};

use super::any_robot::AnyRobot;
use super::place::{Along, Place};

/// dM/dt along the velocity `qd`.
pub(super) fn mass_matrix_rate(
    robot: &dyn AnyRobot,
    q: &Place<f64>,
    qd: &DVector<f64>,
) -> DMatrix<f64> {
    robot.mass_matrix(&q.along(qd)).map(|m| m.eps)
}

/// dM/dq_k for each joint k.
pub(super) fn mass_matrix_gradient(robot: &dyn AnyRobot, q: &Place<f64>) -> Vec<DMatrix<f64>> {
    let along = |k| mass_matrix_rate(robot, q, &unit(robot.freedoms(), k));
    (0..robot.freedoms()).map(along).collect()
}

/// The unit vector `k` of `n`.
pub(super) fn unit(n: usize, k: usize) -> DVector<f64> {
    DVector::from_fn(n, |i, _| if i == k { 1.0 } else { 0.0 })
}
