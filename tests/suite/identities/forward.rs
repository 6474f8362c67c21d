//! Forward dynamics against inverse dynamics.

use super::any_arm::AnyArm;
use super::samples::{Magnitude, TOLERANCE, assert_small, states};

/// qdd of tau(qdd) is qdd, up to what M makes of a rounding of tau: |M^-1| times the tolerance.
pub(super) fn forward_dynamics_undoes_inverse_dynamics<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for state in states() {
        let torque = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        let qdd = robot.forward_dynamics(&state.q, &state.qd, &torque);
        let error = qdd.expect("M is positive definite") - state.qdd;

        let bound = TOLERANCE * N as f64 * Magnitude::at(robot, &state).torque;
        let m = robot.mass_matrix(&state.q);
        let inverse = m.try_inverse().expect("M is positive definite");
        for (i, error) in error.iter().enumerate() {
            let bound = bound * inverse.row(i).abs().sum();
            assert!(
                error.abs() <= bound,
                "joint {i}: {error:e}, beyond {bound:e}"
            );
        }
    }
}

/// tau of qdd(tau) is tau.
pub(super) fn inverse_dynamics_undoes_forward_dynamics<const N: usize, const P: usize>(
    robot: &dyn AnyArm<N, P>,
) {
    for mut state in states() {
        let torque = state.qdd;
        let qdd = robot.forward_dynamics(&state.q, &state.qd, &torque);
        state.qdd = qdd.expect("M is positive definite");
        let back = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        assert_small(&(back - torque), Magnitude::at(robot, &state).torque, N);
    }
}
