//! Inverse dynamics and its parts.

use robot_dynamics::nalgebra::DVector;

use super::any_robot::AnyRobot;
use super::samples::{Magnitude, assert_small, states};

/// tau = M qdd + V + G + K + F.
pub(super) fn inverse_dynamics_is_the_sum_of_its_terms(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let sum = robot.mass_matrix(&state.q) * &state.qdd
            + robot.coriolis_vector(&state.q, &state.qd)
            + robot.gravity_vector(&state.q)
            + robot.spring_vector(&state.q)
            + robot.friction_vector(&state.qd);
        let torque = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd);
        assert_small(&(torque - sum), Magnitude::at(robot, &state).torque, n);
    }
}

/// V + G + K + F = tau(q, qd, 0).
pub(super) fn bias_force_is_the_torque_without_acceleration(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let torque = robot.inverse_dynamics(&state.q, &state.qd, &DVector::zeros(n));
        let bias = robot.bias_force(&state.q, &state.qd);
        let sum = robot.coriolis_vector(&state.q, &state.qd)
            + robot.gravity_vector(&state.q)
            + robot.spring_vector(&state.q)
            + robot.friction_vector(&state.qd);
        assert_small(&(&bias - sum), Magnitude::at(robot, &state).torque, n);
        assert_small(&(torque - bias), Magnitude::at(robot, &state).torque, n);
    }
}
