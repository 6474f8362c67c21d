//! Inputs that are not numbers stay visible: a result is finite only if it does not depend on them.

use robot_dynamics::nalgebra::DVector;

use super::any_robot::AnyRobot;
use super::place::Place;
use super::samples::{Magnitude, TOLERANCE, states};

/// Every function at one position, as one list of numbers.
fn all_functions(robot: &dyn AnyRobot, q: &Place<f64>, qd: &DVector<f64>) -> Vec<f64> {
    let n = robot.freedoms();
    let mut values = vec![robot.kinetic_energy(q, qd), robot.potential_energy(q)];
    values.extend(robot.mass_matrix(q).iter());
    values.extend(robot.coriolis_vector(q, qd).iter());
    values.extend(robot.gravity_vector(q).iter());
    values.extend(robot.inverse_dynamics(q, qd, qd).iter());
    values.extend(robot.bias_force(q, qd).iter());
    values.extend(robot.coriolis_matrix(q, qd).iter());
    values.extend(robot.coriolis_coefficients(q).iter());
    values.extend(robot.centrifugal_coefficients(q).iter());
    values.extend(robot.link_poses(q).iter().flatten());
    values.extend(robot.forward_kinematics(q).iter());
    values.extend(robot.jacobian(q).iter());
    let forces = robot.inverse_dynamics_derivatives(q, qd, qd);
    values.extend(forces.iter().flatten());
    match robot.forward_dynamics_derivatives(q, qd, qd) {
        Some(motion) => values.extend(motion.iter().flatten()),
        None => values.resize(values.len() + 3 * n * n, f64::NAN),
    }
    match robot.forward_dynamics(q, qd, qd) {
        Some(qdd) => values.extend(qdd.iter()),
        None => values.resize(values.len() + n, f64::NAN),
    }
    values
}

/// Where a result at positions `q` is finite, it is what it is at every other position.
fn positions_do_not_vanish(robot: &dyn AnyRobot, q: f64) {
    let n = robot.freedoms();
    let state = states(robot).next().expect("a state");
    let is = Magnitude::at(robot, &state);
    let bound = TOLERANCE * n as f64 * (is.torque + is.reach + 1.0);
    let found = all_functions(robot, &state.q.at_joints(q), &state.qd);
    for other in states(robot).take(3) {
        let finite = all_functions(robot, &other.q, &state.qd);
        for (i, (found, finite)) in found.iter().zip(finite).enumerate() {
            let same = (found - finite).abs() <= bound;
            assert!(
                same || !found.is_finite(),
                "value {i}: {found} instead of {finite}"
            );
        }
    }
}

pub(super) fn not_a_number_is_never_turned_into_a_number(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    positions_do_not_vanish(robot, f64::NAN);

    let state = states(robot).next().expect("a state");
    let nan = DVector::repeat(n, f64::NAN);
    assert!(robot.kinetic_energy(&state.q, &nan).is_nan());
    let torque = robot.inverse_dynamics(&state.q, &state.qd, &nan);
    assert!(torque.iter().all(|x| x.is_nan()), "{torque}");
}

pub(super) fn infinite_positions_are_never_turned_into_numbers(robot: &dyn AnyRobot) {
    positions_do_not_vanish(robot, f64::INFINITY);
    positions_do_not_vanish(robot, f64::NEG_INFINITY);
}

pub(super) fn forward_dynamics_does_not_hide_a_torque_that_is_not_a_number(robot: &dyn AnyRobot) {
    let n = robot.freedoms();
    let state = states(robot).next().expect("a state");
    let nan = DVector::repeat(n, f64::NAN);
    if let Some(qdd) = robot.forward_dynamics(&state.q, &state.qd, &nan) {
        assert!(qdd.iter().all(|x| x.is_nan()), "{qdd}");
    }
}

/// V is quadratic in the velocity: at speeds whose square overflows, an entry that is not small is not
/// finite, and one that vanishes identically is still 0. Nothing panics.
pub(super) fn speeds_to_overflow_give_no_finite_forces(robot: &dyn AnyRobot) {
    for state in states(robot).take(3) {
        let once = robot.coriolis_vector(&state.q, &state.qd);
        for factor in [1e100, 1e160, 1e250, f64::MAX / 4.0] {
            let qd = &state.qd * factor;
            let v = robot.coriolis_vector(&state.q, &qd);
            for (v, once) in v.iter().zip(&once) {
                let overflows = (once.abs() * factor) * factor == f64::INFINITY;
                assert!(
                    !overflows || !v.is_finite(),
                    "{once} became {v} at {factor:e}"
                );
                assert!(*once != 0.0 || *v == 0.0 || v.is_nan(), "0 became {v}");
            }
            if let Some(qdd) = robot.forward_dynamics(&state.q, &qd, &state.qdd) {
                let is_lost = v.iter().any(|v| !v.is_finite()) && qdd.iter().all(|x| x.is_finite());
                assert!(!is_lost, "{qdd} at {factor:e}");
            }
        }
    }
}
