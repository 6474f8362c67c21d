//! Coriolis and centrifugal terms: vector, matrix, and coefficients.

use robot_dynamics::nalgebra::{SMatrix, SVector};

use super::any_arm::AnyArm;
use super::gradient::{mass_matrix_gradient, mass_matrix_rate};
use super::samples::{Magnitude, assert_small, states};

/// C qd = V.
pub(super) fn coriolis_matrix_gives_the_coriolis_vector<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let c = robot.coriolis_matrix(&state.q, &state.qd);
        let v = robot.coriolis_vector(&state.q, &state.qd);
        let magnitude = Magnitude::at(robot, &state);
        assert_small(&(c * state.qd - v), magnitude.coriolis, N);
    }
}

/// C_ij = sum_k 1/2 (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) qd_k (Siciliano et al. 2009, 7.44,
/// 7.45).
pub(super) fn coriolis_matrix_is_made_of_christoffel_symbols<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let dm = mass_matrix_gradient(robot, &state.q);
        let symbol =
            |i: usize, j: usize, k: usize| 0.5 * (dm[k][(i, j)] + dm[j][(i, k)] - dm[i][(j, k)]);
        let expected = SMatrix::<f64, N, N>::from_fn(|i, j| {
            (0..N).map(|k| symbol(i, j, k) * state.qd[k]).sum()
        });
        let c = robot.coriolis_matrix(&state.q, &state.qd);
        let magnitude = Magnitude::at(robot, &state);
        assert_small(&(c - expected), magnitude.coriolis_matrix, N);
    }
}

/// Mdot - 2C = -(Mdot - 2C)'.
pub(super) fn rate_of_the_mass_matrix_minus_twice_coriolis_is_skew<
    const N: usize,
    const P: usize,
>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let rate = mass_matrix_rate(robot, &state.q, &state.qd);
        let skew = rate - robot.coriolis_matrix(&state.q, &state.qd) * 2.0;
        let magnitude = Magnitude::at(robot, &state);
        assert_small(&(skew + skew.transpose()), magnitude.coriolis_matrix, N);
    }
}

/// V = B [qd_j qd_k] + C [qd_j^2] with B_i,jk = dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i, columns in
/// the order (1,2), (1,3), ..., (n-1,n), and C_ij = dM_ij/dq_j - 1/2 dM_jj/dq_i (Craig 6.63).
pub(super) fn coriolis_coefficients_are_those_of_the_configuration_space_form<
    const N: usize,
    const P: usize,
>(
    robot: &dyn AnyArm<N, P>,
) {
    let pairs: Vec<_> = (0..N)
        .flat_map(|j| (j + 1..N).map(move |k| (j, k)))
        .collect();
    assert_eq!(pairs.len(), P);
    for state in states() {
        let magnitude = Magnitude::at(robot, &state);
        let dm = mass_matrix_gradient(robot, &state.q);
        let b = robot.coriolis_coefficients(&state.q);
        let c = robot.centrifugal_coefficients(&state.q);

        let expected_b = SMatrix::<f64, N, P>::from_fn(|i, column| {
            let (j, k) = pairs[column];
            dm[k][(i, j)] + dm[j][(i, k)] - dm[i][(j, k)]
        });
        let expected_c = SMatrix::<f64, N, N>::from_fn(|i, j| dm[j][(i, j)] - 0.5 * dm[i][(j, j)]);
        assert_small(&(b - expected_b), magnitude.inertia, N);
        assert_small(&(c - expected_c), magnitude.inertia, N);

        let products = SVector::<f64, P>::from_fn(|column, _| {
            let (j, k) = pairs[column];
            state.qd[j] * state.qd[k]
        });
        let v = robot.coriolis_vector(&state.q, &state.qd);
        let form = b * products + c * state.qd.component_mul(&state.qd);
        assert_small(&(form - v), magnitude.coriolis, N);
    }
}

/// V(q, -qd) = V(q, qd), to the bit: every product of two velocities keeps its sign.
pub(super) fn coriolis_vector_is_even_in_the_velocity<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let forth = robot.coriolis_vector(&state.q, &state.qd);
        let back = robot.coriolis_vector(&state.q, &-state.qd);
        assert_eq!(forth, back);
    }
}

/// V(q, 2 qd) = 4 V(q, qd), to the bit: a power of two changes no rounding.
pub(super) fn coriolis_vector_is_quadratic_in_the_velocity<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let once = robot.coriolis_vector(&state.q, &state.qd);
        let twice = robot.coriolis_vector(&state.q, &(state.qd * 2.0));
        assert_eq!(twice, once * 4.0);
    }
}
