//! Energies and what derives from them.

use robot_dynamics::nalgebra::{DVector, Vector1, Vector3};

use super::any_robot::AnyRobot;
use super::axes::{axes, with_followers};
use super::gradient::unit;
use super::place::Along;
use super::samples::{Magnitude, assert_small, states};

/// T = 1/2 qd'M qd.
pub(super) fn kinetic_energy_is_that_of_the_mass_matrix(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let m = robot.mass_matrix(&state.q);
        let expected = 0.5 * state.qd.dot(&(m * &state.qd));
        let kinetic = robot.kinetic_energy(&state.q, &state.qd);
        let magnitude = Magnitude::at(robot, &state);
        assert_small(&Vector1::new(kinetic - expected), magnitude.coriolis, n);
    }
}

/// U = -sum m g.c, zero where all centres of mass are at the world's origin, and the energy of springs.
pub(super) fn potential_energy_is_that_of_weights_and_springs(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    let table = robot.table();
    let gravity = Vector3::from(table.gravity);
    for state in states(robot) {
        let poses = with_followers(&table, &state.q.q, &robot.link_poses(&state.q));
        let links = axes(&table).into_iter().zip(poses);
        let energy = links.map(|(axis, pose)| {
            let (row, q) = (axis.row, axis.position(&state.q.q));
            let com = pose * Vector3::from(row.com).push(1.0);
            let stretch = q - row.spring.rest;
            0.5 * row.spring.stiffness * stretch * stretch - row.mass * gravity.dot(&com.xyz())
        });
        let tip = robot.forward_kinematics(&state.q);
        let com = tip * Vector3::from(table.tool.com).push(1.0);
        let of_tool = -table.tool.mass * gravity.dot(&com.xyz());
        let difference = robot.potential_energy(&state.q) - energy.sum::<f64>() - of_tool;
        let magnitude = Magnitude::at(robot, &state);
        let magnitude = magnitude.gravity + magnitude.energy_of_springs;
        assert_small(&Vector1::new(difference), magnitude, n);
    }
}

/// G + K = dU/dq.
pub(super) fn gravity_and_springs_are_the_gradient_of_the_potential_energy(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let slope = |k| robot.potential_energy(&state.q.along(&unit(n, k))).eps;
        let gradient = DVector::from_fn(n, |k, _| slope(k));
        let forces = robot.gravity_vector(&state.q) + robot.spring_vector(&state.q);
        let difference = forces - gradient;
        let magnitude = Magnitude::at(robot, &state);
        // A prismatic joint feels the weight itself, whatever the reach.
        let weight = magnitude.gravity / magnitude.reach.min(1.0);
        assert_small(&difference, weight + magnitude.spring, n);
    }
}

/// d(T + U)/dt = qd'(tau - F).
pub(super) fn power_of_the_torques_is_the_rate_of_the_energy(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    for state in states(robot) {
        let q = state.q.along(&state.qd);
        let qd = state.qd.along(&state.qdd);
        let rate = (robot.kinetic_energy(&q, &qd) + robot.potential_energy(&q)).eps;
        let torque = robot.inverse_dynamics(&state.q, &state.qd, &state.qdd)
            - robot.friction_vector(&state.qd);
        let magnitude = Magnitude::at(robot, &state).torque * state.qd.abs().sum();
        assert_small(&Vector1::new(rate - torque.dot(&state.qd)), magnitude, n);
    }
}
