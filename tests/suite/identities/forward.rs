//! Forward dynamics against inverse dynamics.

use super::any_robot::AnyRobot;
use super::momenta::assert_within;
use super::samples::{Magnitude, TOLERANCE, assert_small, states};

/// qdd of tau(qdd) is qdd, up to what M makes of a rounding of tau: |M^-1| times the tolerance.
pub(super) fn forward_dynamics_undoes_inverse_dynamics(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let torque = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        let qdd = robot.forward_dynamics(&state.q, &state.qd, &torque);
        let error = qdd.expect("M is positive definite") - &state.qdd;
        let bound = TOLERANCE * n as f64 * Magnitude::at(robot, &state).torque;
        assert_within(&error, bound, &robot.mass_matrix(&state.q));
    }
}

/// tau of qdd(tau) is tau.
pub(super) fn inverse_dynamics_undoes_forward_dynamics(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for mut state in states(robot) {
        let torque = state.qdd.clone();
        let qdd = robot.forward_dynamics(&state.q, &state.qd, &torque);
        state.qdd = qdd.expect("M is positive definite");
        let back = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        assert_small(&(back - torque), Magnitude::at(robot, &state).torque, n);
    }
}
