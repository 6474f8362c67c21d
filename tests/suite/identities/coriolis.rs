//! Coriolis and centrifugal terms: vector, matrix, and coefficients.

use robot_dynamics::nalgebra::{DMatrix, DVector};

use super::any_robot::AnyRobot;
use super::gradient::{mass_matrix_gradient, mass_matrix_rate};
use super::samples::{Magnitude, assert_small, states};

/// C qd = V.
pub(super) fn coriolis_matrix_gives_the_coriolis_vector(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let c = robot.coriolis_matrix(&state.q, &state.qd);
        let v = robot.coriolis_vector(&state.q, &state.qd);
        let magnitude = Magnitude::at(robot, &state);
        assert_small(&(c * &state.qd - v), magnitude.coriolis, n);
    }
}

/// C_ij = sum_k 1/2 (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) qd_k (Siciliano et al. 2009, 7.44,
/// 7.45).
pub(super) fn coriolis_matrix_is_made_of_christoffel_symbols(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let dm = mass_matrix_gradient(robot, &state.q);
        let symbol =
            |i: usize, j: usize, k: usize| 0.5 * (dm[k][(i, j)] + dm[j][(i, k)] - dm[i][(j, k)]);
        let expected = DMatrix::from_fn(n, n, |i, j| {
            (0..n).map(|k| symbol(i, j, k) * state.qd[k]).sum()
        });
        let c = robot.coriolis_matrix(&state.q, &state.qd);
        let magnitude = Magnitude::at(robot, &state);
        assert_small(&(c - expected), magnitude.coriolis_matrix, n);
    }
}

/// Mdot - 2C = -(Mdot - 2C)'.
pub(super) fn rate_of_the_mass_matrix_minus_twice_coriolis_is_skew(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let rate = mass_matrix_rate(robot, &state.q, &state.qd);
        let skew = rate - robot.coriolis_matrix(&state.q, &state.qd) * 2.0;
        let magnitude = Magnitude::at(robot, &state);
        assert_small(&(&skew + skew.transpose()), magnitude.coriolis_matrix, n);
    }
}

/// V = B [qd_j qd_k] + C [qd_j^2] with B_i,jk = dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i, columns in
/// the order (1,2), (1,3), ..., (n-1,n), and C_ij = dM_ij/dq_j - 1/2 dM_jj/dq_i (Craig 6.63).
pub(super) fn coriolis_coefficients_are_those_of_the_configuration_space_form(
    robot: &dyn AnyRobot,
) {
    let n = robot.freedoms();
    let pairs: Vec<_> = (0..n)
        .flat_map(|j| (j + 1..n).map(move |k| (j, k)))
        .collect();
    for state in states(robot) {
        let magnitude = Magnitude::at(robot, &state);
        let dm = mass_matrix_gradient(robot, &state.q);
        let b = robot.coriolis_coefficients(&state.q);
        let b = DMatrix::from_column_slice(n, pairs.len(), b.as_slice());
        let c = robot.centrifugal_coefficients(&state.q);

        let expected_b = DMatrix::from_fn(n, pairs.len(), |i, column| {
            let (j, k) = pairs[column];
            dm[k][(i, j)] + dm[j][(i, k)] - dm[i][(j, k)]
        });
        let expected_c = DMatrix::from_fn(n, n, |i, j| dm[j][(i, j)] - 0.5 * dm[i][(j, j)]);
        assert_small(&(&b - expected_b), magnitude.inertia, n);
        assert_small(&(&c - expected_c), magnitude.inertia, n);

        let products = DVector::from_fn(pairs.len(), |column, _| {
            let (j, k) = pairs[column];
            state.qd[j] * state.qd[k]
        });
        let v = robot.coriolis_vector(&state.q, &state.qd);
        let form = b * products + c * state.qd.component_mul(&state.qd);
        assert_small(&(form - v), magnitude.coriolis, n);
    }
}

/// V(q, -qd) = V(q, qd), to the bit: every product of two velocities keeps its sign.
pub(super) fn coriolis_vector_is_even_in_the_velocity(robot: &dyn AnyRobot) {
    for state in states(robot) {
        let forth = robot.coriolis_vector(&state.q, &state.qd);
        let back = robot.coriolis_vector(&state.q, &-&state.qd);
        assert_eq!(forth, back);
    }
}

/// V(q, 2 qd) = 4 V(q, qd), to the bit: a power of two changes no rounding.
pub(super) fn coriolis_vector_is_quadratic_in_the_velocity(robot: &dyn AnyRobot) {
    for state in states(robot) {
        let once = robot.coriolis_vector(&state.q, &state.qd);
        let twice = robot.coriolis_vector(&state.q, &(&state.qd * 2.0));
        assert_eq!(twice, once * 4.0);
    }
}
